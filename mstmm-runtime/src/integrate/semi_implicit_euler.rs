//! Euler's method that takes the coordinates along by the new rates.

use super::ask::{always, ask};
use super::combine::{add_scaled_coordinates, add_scaled_rates, copy};
use super::fixed_step::{self, FixedStep, Pace, Span, advance_methods, arrive, clone_and_debug};
use crate::{Chain, ChainState, Error};

/// The semi-implicit, or symplectic, method of Euler with a fixed step: order one at one evaluation
/// a step.
///
/// v ← v + h v̇(q, v, t), then q ← q + h q̇(q, v) with the new v, then [`Chain::normalize`]. Where
/// v̇ depends on coordinates alone and q̇ is v, the energy does not drift: it swings by what is in
/// proportion to the step. What depends on rates spoils that; see [the table](super) for spinning
/// bodies.
///
/// Stable are steps up to 2/ω for the highest angular frequency ω, or up to 2 m/c for a damper
/// alone.
///
/// Times are added up as in [`Rk4`](super::Rk4).
pub struct SemiImplicitEuler<C: Chain> {
    pace: Pace<C::Scalar>,
    rate: C::State,
    result: C::State,
}

advance_methods!(SemiImplicitEuler);

clone_and_debug!(SemiImplicitEuler { rate, result });

impl<C: Chain> SemiImplicitEuler<C> {
    /// An integrator whose step is `step` seconds; a negative one goes back in time.
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
    /// Those of [`Chain::check_state`], [`Chain::check_inputs`], [`Chain::derivative_into`] and
    /// [`Chain::project`], and [`Error::NotFinite`] if the result is not finite.
    /// `state` is left as it was.
    pub fn step(
        &mut self,
        chain: &C,
        state: &mut C::State,
        inputs: impl FnMut(C::Scalar, &C::State) -> C::Inputs,
    ) -> Result<(), Error> {
        fixed_step::step(self, chain, state, always::<C>(inputs))
    }
}

impl<C: Chain> FixedStep<C> for SemiImplicitEuler<C> {
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
        chain.derivative_into(state, &acting, &mut self.rate)?;
        follow(chain, state, span, &mut self.rate, &mut self.result, inputs)
    }
}

/// Follows v̇ in `rate` over `span`, first with the rates, then by these with the coordinates.
pub(super) fn follow<C: Chain, E: From<Error>>(
    chain: &C,
    state: &mut C::State,
    Span { step, end }: Span<C::Scalar>,
    rate: &mut C::State,
    result: &mut C::State,
    inputs: &mut impl FnMut(C::Scalar, &C::State) -> Result<C::Inputs, E>,
) -> Result<(), E> {
    copy(result, state);
    add_scaled_rates(result, step, rate);
    chain.configuration_rate_into(result, rate);
    add_scaled_coordinates(result, step, rate);
    arrive(chain, result, end, state, inputs)
}
