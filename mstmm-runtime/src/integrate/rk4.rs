//! The classical method of order four.

use super::combine::{add_scaled, copy, is_finite, start_plus_scaled, weighted_sum};
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
    step: C::Scalar,
    clock: Clock<C::Scalar>,
    stage: C::State,
    rate: C::State,
    sum: C::State,
}

// Derived, both would ask the same of the chain's own type.
impl<C: Chain> Clone for Rk4<C> {
    fn clone(&self) -> Self {
        Self {
            step: self.step,
            clock: self.clock,
            stage: self.stage.clone(),
            rate: self.rate.clone(),
            sum: self.sum.clone(),
        }
    }
}

impl<C: Chain> core::fmt::Debug for Rk4<C> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("Rk4").field("step_size", &self.step).finish_non_exhaustive()
    }
}

impl<C: Chain> Rk4<C> {
    /// An integrator whose step is `step` seconds; a negative one goes back in time.
    pub fn new(step: C::Scalar) -> Self {
        let clock = Clock { time: C::Scalar::default(), lost: C::Scalar::default() };
        Self {
            step,
            clock,
            stage: C::State::default(),
            rate: C::State::default(),
            sum: C::State::default(),
        }
    }

    /// The step in s.
    pub fn step_size(&self) -> C::Scalar {
        self.step
    }

    /// Sets the step in s, for the steps from now on.
    pub fn set_step_size(&mut self, step: C::Scalar) {
        self.step = step;
    }

    /// Takes `state` one step further.
    ///
    /// `inputs` is asked four times, at the start, twice in the middle and at the end of the step,
    /// with the time in s and the stage's state, whose quaternions are of unit length only up to
    /// the stage's error.
    ///
    /// # Errors
    /// Those of [`Chain::derivative_into`], and [`Error::NotFinite`] if the result is not finite.
    /// `state` is left as it was.
    pub fn step(
        &mut self,
        chain: &C,
        state: &mut C::State,
        mut inputs: impl FnMut(C::Scalar, &C::State) -> C::Inputs,
    ) -> Result<(), Error> {
        let half = self.step * C::Scalar::constant(0.5);
        let (zero, one, two) =
            (C::Scalar::default(), C::Scalar::constant(1.0), C::Scalar::constant(2.0));
        let clock = self.clock.advanced(state.time(), self.step);
        let (start, middle, end) = (state.time(), state.time() + half, clock.time);

        weighted_sum(&mut self.sum, [], []);
        copy(&mut self.stage, state);
        // Each stage: its time, its weight in the mean of the rates, in sixths, and how far it
        // leads to the next one.
        for (time, weight, onward) in
            [(start, one, half), (middle, two, half), (middle, two, self.step), (end, one, zero)]
        {
            self.stage.set_time(time);
            chain.derivative_into(&self.stage, &inputs(time, &self.stage), &mut self.rate)?;
            add_scaled(&mut self.sum, weight, &self.rate);
            copy(&mut self.stage, state);
            add_scaled(&mut self.stage, onward, &self.rate);
        }
        start_plus_scaled(&mut self.sum, state, self.step * C::Scalar::constant(1.0 / 6.0));
        self.sum.set_time(end);
        chain.normalize(&mut self.sum);
        if !is_finite(&self.sum) {
            return Err(Error::NotFinite);
        }
        copy(state, &self.sum);
        self.clock = clock;
        Ok(())
    }
}

/// A time and what rounding took from it.
#[derive(Clone, Copy)]
struct Clock<T> {
    time: T,
    lost: T,
}

impl<T: Scalar> Clock<T> {
    /// The clock one step after `now`. If `now` is not what this clock last said, nothing is owed
    /// to it.
    fn advanced(self, now: T, step: T) -> Self {
        let lost = if self.time == now { self.lost } else { T::default() };
        let change = step + lost;
        let time = now + change;
        // Knuth's two-sum: exact whichever of the two is larger.
        let back = time - now;
        Self { time, lost: (now - (time - back)) + (change - back) }
    }
}
