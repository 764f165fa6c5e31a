//! Euler's method for stiff springs.

use super::ask::{always, ask};
use super::fixed_step::{self, FixedStep, Pace, Span, advance_methods, clone_and_debug};
use super::semi_implicit_euler::follow;
use crate::{Chain, ChainState, Error};

/// The linearly implicit method of Euler with a fixed step, for springs, dampers and limits too
/// stiff for the step: order one at one evaluation a step.
///
/// v ← v + h v̇ with the rate of [`Chain::implicit_derivative_into`], which looks ahead to what
/// springs and dampers in hinges will do during the step, then q ← q + h q̇(q, v) with the new v,
/// then [`Chain::normalize`]. No spring or damper in a hinge limits the step. What is faster than
/// the step is damped away rather than followed, and slower oscillations lose energy too, in
/// proportion to the step.
///
/// Times are added up as in [`Rk4`](super::Rk4).
pub struct LinearlyImplicitEuler<C: Chain> {
    pace: Pace<C::Scalar>,
    rate: C::State,
    result: C::State,
}

advance_methods!(LinearlyImplicitEuler);

clone_and_debug!(LinearlyImplicitEuler { rate, result });

impl<C: Chain> LinearlyImplicitEuler<C> {
    /// An integrator whose step is `step` seconds. A negative one goes back in time, where what
    /// damps drives.
    pub fn new(step: C::Scalar) -> Self {
        Self { pace: Pace::new(step), rate: C::State::default(), result: C::State::default() }
    }

    /// The step in s.
    pub fn step_size(&self) -> C::Scalar {
        self.pace.step
    }

    /// Sets the step in s, for the steps from now on.
    pub fn set_step_size(&mut self, step: C::Scalar) {
        self.pace.step = step;
    }

    /// Takes `state` one step further.
    ///
    /// `inputs` is asked once, at the start, with the time in s and the state.
    ///
    /// # Errors
    /// Those of [`Chain::check_state`], [`Chain::check_inputs`], [`Chain::implicit_derivative_into`] and
    /// [`Chain::project`], and [`Error::NotFinite`] if the result is not finite. `state` is left as it was.
    pub fn step(
        &mut self,
        chain: &C,
        state: &mut C::State,
        inputs: impl FnMut(C::Scalar, &C::State) -> C::Inputs,
    ) -> Result<(), Error> {
        fixed_step::step(self, chain, state, always::<C>(inputs))
    }
}

impl<C: Chain> FixedStep<C> for LinearlyImplicitEuler<C> {
    fn pace(&mut self) -> &mut Pace<C::Scalar> {
        &mut self.pace
    }

    fn take<E: From<Error>>(
        &mut self,
        chain: &C,
        state: &mut C::State,
        span: Span<C::Scalar>,
        inputs: &mut impl FnMut(C::Scalar, &C::State) -> Result<C::Inputs, E>,
    ) -> Result<(), E> {
        let acting = ask(chain, inputs, state.time(), state)?;
        chain.implicit_derivative_into(state, &acting, span.step, &mut self.rate)?;
        follow(chain, state, span, &mut self.rate, &mut self.result, inputs)
    }
}
