//! Integrators in time, for anything that is a [`Chain`]. Each owns its buffers; nothing is
//! allocated.
//!
//! All of them ask a closure for what acts on the chain, with the time in s and a state: `|time,
//! state| inputs`. It is asked at every stage of a step, so it should be smooth in time within a
//! step; where it jumps, let a step end.
//!
//! Quaternions are integrated as four numbers, and brought back to unit length after every step by
//! [`Chain::normalize`]. That moves them by no more than the error of the step, so a method keeps
//! its order, and unlike any three angles they have no pose in which they fail.

mod combine;
mod dopri5;
mod rk4;
mod step_control;
mod tableau;

pub use dopri5::{Dopri5, Statistics};
pub use rk4::Rk4;

use crate::{Chain, Scalar};

/// The numbers in which tolerances and steps of chain `C` are given: the chain's own, or that of
/// one of its lanes.
pub type Real<C> = <<C as Chain>::Scalar as Scalar>::Real;
