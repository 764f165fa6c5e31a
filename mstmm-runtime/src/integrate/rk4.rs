//! The classical Runge–Kutta method.

use super::ask::{always, ask};
use super::combine::{add_scaled, copy, start_plus_scaled, sum_scaled, weighted_sum};
use super::fixed_step::{self, FixedStep, Pace, Span, arrive, clone_and_debug, fixed_step_methods};
use super::held::held_methods;
use crate::{Chain, ChainState, Error, Scalar};

/// The classical Runge–Kutta method of order four with a fixed step.
///
/// A step costs four evaluations, so its run time is constant. After a step quaternions are scaled to unit length, which
/// keeps the order. The type of the chain follows from the first [`step`](Rk4::step).
///
/// The time is summed with compensation (Kahan 1965): the rounding error of one step is added to the next one. So after
/// n steps the time is the start plus n·h, up to one rounding. Setting the time of the state restarts the summation.
#[doc(alias("RungeKutta", "RK4", "mjINT_RK4", "mj_RungeKutta"))]
pub struct Rk4<C: Chain> {
    pace: Pace<C::Scalar>,
    stage: C::State,
    rate: C::State,
    sum: C::State,
}

fixed_step_methods!(Rk4);

held_methods!(Rk4);

clone_and_debug!(Rk4 { stage, rate, sum });

impl<C: Chain> Rk4<C> {
    /// Makes an integrator with a step of `step` seconds; a negative step goes back in time.
    pub fn new(step: C::Scalar) -> Self {
        Self {
            pace: Pace::new(step),
            stage: C::State::zero_position(),
            rate: C::State::zero_position(),
            sum: C::State::zero_position(),
        }
    }

    /// Integrates `state` over one step.
    ///
    /// `inputs` is evaluated four times: at the start, twice in the middle and at the end of the step. Its arguments are
    /// the time in s and the state of the stage, whose quaternions have unit length up to the error of the stage.
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

impl<C: Chain> FixedStep<C> for Rk4<C> {
    fn pace(&mut self) -> &mut Pace<C::Scalar> {
        &mut self.pace
    }

    fn take<E: From<Error>>(
        &mut self,
        chain: &C,
        state: &mut C::State,
        Span { step, end }: Span<C::Scalar>,
        inputs: &mut impl FnMut(C::Scalar, &C::State) -> Result<C::Inputs, E>,
    ) -> Result<(), E> {
        let half = step * C::Scalar::constant(0.5);
        let (one, two) = (C::Scalar::constant(1.0), C::Scalar::constant(2.0));
        let (start, middle) = (state.time(), state.time() + half);

        weighted_sum(&mut self.sum, [], []);
        copy(&mut self.stage, state);
        // For each stage: its time, its weight in the mean of the rates in sixths, and the factor of its rate in the
        // next stage.
        for (time, weight, onward) in [
            (start, one, Some(half)),
            (middle, two, Some(half)),
            (middle, two, Some(step)),
            (end, one, None),
        ] {
            self.stage.set_time(time);
            let acting = ask(chain, inputs, time, &self.stage)?;
            chain.derivative_into(&self.stage, &acting, &mut self.rate)?;
            add_scaled(&mut self.sum, weight, &self.rate);
            if let Some(onward) = onward {
                sum_scaled(&mut self.stage, state, onward, &self.rate);
            }
        }
        start_plus_scaled(&mut self.sum, state, step * C::Scalar::constant(1.0 / 6.0));
        arrive(chain, &mut self.sum, end, state, inputs)
    }
}
