//! Programs that show what the crate `mstmm` does; each is an example of this package.

pub mod questions;
pub mod step;
