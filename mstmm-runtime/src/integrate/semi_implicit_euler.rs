//! The semi-implicit Euler method.

use super::ask::{always, ask};
use super::combine::{add_scaled_coordinates, add_scaled_rates, copy};
use super::fixed_step::{self, FixedStep, Pace, Span, arrive, clone_and_debug, fixed_step_methods};
use super::held::held_methods;
use crate::{Chain, ChainState, Error};

/// The semi-implicit (symplectic) Euler method with a fixed step: order one with one evaluation per step.
///
/// v ← v + h v̇(q, v, t), then q ← q + h q̇(q, v) with the new v, then [`Chain::normalize`]. If v̇ depends only on
/// coordinates and q̇ = v, the energy does not drift but varies in proportion to the step. Velocity-dependent terms
/// destroy this property, also those of chains of several hinges; see [the comparison of methods](super).
///
/// The method is stable for steps up to 2/ω, where ω is the highest angular frequency, and up to 2 m/c for a damper.
///
/// Times are summed with compensation as in [`Rk4`](super::Rk4).
#[doc(alias("symplectic Euler", "mjINT_EULER", "mj_Euler"))]
pub struct SemiImplicitEuler<C: Chain> {
    pace: Pace<C::Scalar>,
    rate: C::State,
    result: C::State,
}

fixed_step_methods!(SemiImplicitEuler);

held_methods!(SemiImplicitEuler);

clone_and_debug!(SemiImplicitEuler { rate, result });

impl<C: Chain> SemiImplicitEuler<C> {
    /// Makes an integrator with a step of `step` seconds; a negative step goes back in time.
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
    /// Those of [`Chain::check_state`], [`Chain::check_inputs`], [`Chain::derivative_into`] and
    /// [`Chain::project`], and [`Error::NotFinite`] if the result is not finite.
    /// `state` is then unchanged.
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

/// Integrates the rates with v̇ of `rate`, and then the coordinates with the new rates.
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
