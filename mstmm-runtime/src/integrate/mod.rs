//! Integrators in time, for anything that is a [`Chain`]. Each owns its buffers; nothing is
//! allocated.
//!
//! | method | evaluations a step | order | energy of an oscillation | longest step | take it for |
//! |---|---|---|---|---|---|
//! | [`Dopri5`] | 6, or 7 | 5 | error by tolerance | its own | a tolerance that is to be met |
//! | [`Rk4`] | 4 | 4 | loses (hω)⁶/72 a step | 2.8/ω | small errors at an even pace |
//! | [`Newmark`] | 4: 1 and 3 iterations | 2 | loses (hω)⁸/128 a step | 2/ω | long runs that oscillate |
//! | [`SemiImplicitEuler`] | 1 | 1 | swings by hω/2, no drift | 2/ω | real time, many short steps |
//! | [`LinearlyImplicitEuler`] | 1 | 1 | loses (hω)² a step | any, for springs in hinges | stiff springs and limits |
//!
//! h is the step, ω the angular frequency of the oscillation. Orders and energies are those that
//! the tests measure, on a spring, a driven pendulum, a free top and a pendulum in space, both with
//! a quaternion. An evaluation is one of [`Chain::derivative_into`], or of
//! [`Chain::implicit_derivative_into`].
//!
//! Both methods of Euler take what depends on rates as it is at the start of a step, besides the
//! dampers that the linearly implicit one looks ahead to. So the transverse rates of a spinning
//! body, which turn in it at some Ω, gain (hΩ)² of their energy a step: over more than a fraction of
//! 1/(hΩ²) take another method.
//!
//! All of them ask a closure for what acts on the chain, with the time in s and a state: `|time,
//! state| inputs`. It is asked at every stage of a step, so it should be smooth in time within a
//! step; where it jumps, let a step end.
//!
//! Inputs that may fail, such as those of a controller that reads sensors, are given to `try_step` and
//! `try_advance_to` as a `Result` with an error of any type `E: From<Error>`. The first error ends the
//! step at once and reaches the caller unchanged. The state, the clock, and of [`Dopri5`] the size of
//! the next step and the dense output are then as before that step. Errors of the chain are converted
//! to `E`.
//!
//! ```
//! # use mstmm_runtime::{Chain, ChainState, Error, Rk4};
//! #[derive(Debug, PartialEq)]
//! enum Fault {
//!     Sensor,
//!     Dynamics(Error),
//! }
//!
//! impl From<Error> for Fault {
//!     fn from(error: Error) -> Self {
//!         Fault::Dynamics(error)
//!     }
//! }
//!
//! /// A torque against the rate that a sensor measures.
//! fn control<C: Chain<Scalar = f64, Inputs = f64>>(state: &C::State) -> Result<f64, Fault> {
//!     let measured = state.rates().first().filter(|rate| rate.abs() < 10.0);
//!     Ok(-0.5 * measured.ok_or(Fault::Sensor)?)
//! }
//!
//! fn move_on<C: Chain<Scalar = f64, Inputs = f64>>(
//!     chain: &C,
//!     state: &mut C::State,
//! ) -> Result<(), Fault> {
//!     Rk4::new(1e-3).try_step(chain, state, |_time, state| control::<C>(state))
//! }
//! ```
//!
//! A quaternion of the given state, or of a prescribed motion, whose length is not between 0.9 and 1.1
//! is refused with [`Error::InvalidQuaternion`](crate::Error::InvalidQuaternion). The state is checked once in a call
//! of `step` or `advance_to`; the states of stages, which an integrator makes itself, are not.
//!
//! Quaternions are integrated as four numbers, and brought back to unit length after every step by
//! [`Chain::normalize`]; a chain held at both ends is then brought back onto its closure by
//! [`Chain::project`], which asks for what acts on it once more. That moves the state by no more than
//! the error of the step, so a method keeps its order, and unlike any three angles quaternions have
//! no pose in which they fail. The stages of a step are off the closure by their error. They take the
//! rank of a redundant closure from the linkage, not from their state; Bennett's linkage keeps its
//! energy within 10⁻⁸ in a minute of [`Rk4`] at 1 ms. [`Dopri5::interpolate`] closes nothing: within a step a chain is open
//! by about the error of the step.

mod ask;
mod combine;
mod dopri5;
mod fixed_step;
mod linearly_implicit_euler;
mod newmark;
mod rk4;
mod semi_implicit_euler;
mod step_control;
mod tableau;

pub use dopri5::{Dopri5, Statistics};
pub use linearly_implicit_euler::LinearlyImplicitEuler;
pub use newmark::Newmark;
pub use rk4::Rk4;
pub use semi_implicit_euler::SemiImplicitEuler;

use crate::{Chain, Scalar};

/// The numbers in which tolerances and steps of chain `C` are given: the chain's own, or that of
/// one of its lanes.
pub type Real<C> = <<C as Chain>::Scalar as Scalar>::Real;
