//! A kit for machines that hands the dynamics on.

#![no_std]

/// The macro alone, under a name of this crate's own.
pub use mstmm::mstmm_chain as machine;

/// All of it.
pub use mstmm as dynamics;
