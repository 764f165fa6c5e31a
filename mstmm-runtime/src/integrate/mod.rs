//! Integrators in time for every [`Chain`]. Each owns its buffers and allocates nothing.
//!
//! | method | evaluations per step | order | energy of a single oscillator | longest step | use it for |
//! |---|---|---|---|---|---|
//! | [`Dopri5`] | 6 or 7 | 5 | error by tolerance | chosen by the method | a required accuracy |
//! | [`Rk4`] | 4 | 4 | loses (hω)⁶/72 per step | 2.8/ω | small errors at a constant cost per step |
//! | [`Newmark`] | 4: 1 and 3 iterations | 2 | loses (hω)⁸/128 per step | 2/ω | long runs of oscillating chains |
//! | [`SemiImplicitEuler`] | 1 | 1 | varies by hω/2, without drift | 2/ω | real time with many short steps |
//! | [`LinearlyImplicitEuler`] | 1 | 1 | loses (hω)² per step | any, for springs in hinges | stiff springs and limits |
//!
//! h is the step, ω is the angular frequency of the oscillation. The tests measure orders and energies on a spring, a
//! driven pendulum, a free top, and a spherical pendulum; the last two have a quaternion. An evaluation is one call of
//! [`Chain::derivative_into`] or [`Chain::implicit_derivative_into`].
//!
//! Both Euler methods evaluate velocity-dependent terms at the start of the step; only the dampers of the linearly
//! implicit method are implicit. Chains of several hinges have such terms: the Coriolis and centrifugal forces. Their
//! energy grows or falls, in proportion to the step and to the time: that of an undamped double pendulum by more than its
//! energy of motion within a hundred seconds at 10 ms. Use [`Newmark`] or [`Rk4`] for long runs. The transverse rates of a spinning body, which rotate in the body at an angular
//! velocity Ω, gain (hΩ)² of their energy per step.
//!
//! `step` takes one step. `advance_to` integrates to an end time and `advance_by` over a duration. Every integrator
//! calls `|time, state| inputs`, with the time in s, at each stage of a step. Inputs should be smooth in time within a
//! step; let a step end where they jump.
//!
//! `step_held` and `advance_held` hold given inputs over a step or a duration, as a digital controller does (zero-order
//! hold). They are `step` and `advance_by` with constant inputs.
//!
//! Inputs that can fail, such as those of a controller that reads sensors, are given to `try_step`, `try_advance_to` or
//! `try_advance_by` as a `Result` with an error of any type `E: From<Error>`. The first error ends the step at once and
//! reaches the caller unchanged. The state and the clock are then those before that step, as are the size of the next
//! step and the dense output of [`Dopri5`]. Errors of the chain are converted to `E`.
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
//! /// Returns a torque against the rate that a sensor measures.
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
//! A quaternion of the given state or of a prescribed motion whose length is not between 0.9 and 1.1 is refused with
//! [`Error::InvalidQuaternion`](crate::Error::InvalidQuaternion). The state is checked once in each call; the states of
//! stages, which an integrator computes itself, are not.
//!
//! Quaternions are integrated as four numbers. After every step [`Chain::normalize`] scales them to unit length, and
//! [`Chain::project`] projects a closed chain onto its loop constraints, for which it evaluates the inputs once more.
//! Both change the state by no more than the error of the step, so a method keeps its order. The stages of a step
//! violate the loop constraints by their error. They take the rank of redundant constraints from the linkage and not
//! from their state; Bennett's linkage keeps its energy within 10⁻⁸ in a minute of [`Rk4`] at 1 ms.
//! [`Dopri5::interpolate`] does not project: within a step the loop constraints are violated by about the error of the
//! step.

mod ask;
pub(crate) mod combine;
mod dopri5;
mod fixed_step;
mod held;
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

/// The type of tolerances and times of chain `C`: its scalar type, or that of one lane.
pub type Real<C> = <<C as Chain>::Scalar as Scalar>::Real;
