//! The command `cargo mstmm`, as a library.

pub mod commands;
pub mod import;
