#![doc = include_str!("../README.md")]
#![no_std]
#![deny(missing_docs)]

pub mod hinges;

pub use mstmm_macros::mstmm_chain;
#[doc(inline)]
pub use mstmm_runtime::*;

/// What most programs need: the macro, the integrators and the traits that they work on.
pub mod prelude {
    pub use crate::{
        Chain, ChainState, Dopri5, LinearlyImplicitEuler, Newmark, Rk4, SemiImplicitEuler,
        mstmm_chain,
    };
}
