//! The linearly implicit Euler method.

use super::ask::{always, ask};
use super::fixed_step::{self, FixedStep, Pace, Span, clone_and_debug, fixed_step_methods};
use super::held::held_methods;
use super::semi_implicit_euler::follow;
use crate::{Chain, ChainState, Error};

/// The linearly implicit Euler method with a fixed step, for springs, dampers and limits that are too stiff for the
/// step: order one with one evaluation per step.
///
/// v ← v + h v̇ with the rate of [`Chain::implicit_derivative_into`], which treats the springs and dampers in hinges
/// implicitly, then q ← q + h q̇(q, v) with the new v, then [`Chain::normalize`]. Springs and dampers in hinges do not
/// limit the step. Oscillations that are faster than the step are damped; slower ones lose energy in proportion to the
/// step.
///
/// Times are summed with compensation as in [`Rk4`](super::Rk4).
#[doc(alias("mjINT_IMPLICITFAST", "mj_implicit", "Rosenbrock", "implicit"))]
pub struct LinearlyImplicitEuler<C: Chain> {
    pace: Pace<C::Scalar>,
    rate: C::State,
    result: C::State,
}

fixed_step_methods!(LinearlyImplicitEuler);

held_methods!(LinearlyImplicitEuler);

clone_and_debug!(LinearlyImplicitEuler { rate, result });

impl<C: Chain> LinearlyImplicitEuler<C> {
    /// Makes an integrator with a step of `step` seconds. A negative step goes back in time, where dampers add energy.
    pub fn new(step: C::Scalar) -> Self {
        Self {
            pace: Pace::new(step),
            rate: C::State::zero_position(),
            result: C::State::zero_position(),
        }
    }

    /// Integrates `state` over one step.
    ///
    /// `inputs` is evaluated once, at the start, with the time in s and the state.
    ///
    /// # Errors
    /// Those of [`Chain::check_state`], [`Chain::check_inputs`], [`Chain::implicit_derivative_into`] and
    /// [`Chain::project`], and [`Error::NotFinite`] if the result is not finite. `state` is then unchanged.
    #[doc(alias("mj_step"))]
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
