//! The classical method of order four.

use super::ask::{always, ask};
use super::combine::{add_scaled, copy, start_plus_scaled, sum_scaled, weighted_sum};
use super::fixed_step::{self, FixedStep, Pace, Span, advance_methods, arrive, clone_and_debug};
use crate::{Chain, ChainState, Error, Scalar};

/// The classical Runge–Kutta method of order four with a fixed step.
///
/// A step costs four evaluations and takes the same time every time. After it quaternions are
/// brought back to unit length, which keeps the order. The type of the chain follows from the first
/// [`step`](Rk4::step).
///
/// The time is added up with compensation (Kahan 1965): what rounding takes from it in one step is
/// given back in the next, so after n steps it is the start plus n·h but for one rounding. Setting
/// the state's time in between starts the count anew.
pub struct Rk4<C: Chain> {
    pace: Pace<C::Scalar>,
    stage: C::State,
    rate: C::State,
    sum: C::State,
}

advance_methods!(Rk4);

clone_and_debug!(Rk4 { stage, rate, sum });

impl<C: Chain> Rk4<C> {
    /// An integrator whose step is `step` seconds; a negative one goes back in time.
    pub fn new(step: C::Scalar) -> Self {
        Self {
            pace: Pace::new(step),
            stage: C::State::default(),
            rate: C::State::default(),
            sum: C::State::default(),
        }
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
    /// `inputs` is asked four times, at the start, twice in the middle and at the end of the step,
    /// with the time in s and the stage's state, whose quaternions are of unit length only up to
    /// the stage's error.
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
        // Each stage: its time, its weight in the mean of the rates, in sixths, and how far it
        // leads to the next one, if there is one.
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
