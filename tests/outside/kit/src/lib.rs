//! A crate that re-exports the dynamics.

#![no_std]

/// Only the macro, under another name.
pub use mstmm::mstmm_chain as machine;

/// All of it.
pub use mstmm as dynamics;
