//! The command `cargo mstmm`, as a library.

pub mod commands;
pub mod export;
pub mod header;
pub mod import;
pub mod messages;
pub mod new;
pub mod python;
pub mod source;
pub mod unclosed;
