//! Dormand and Prince's method of order five with an error estimate of order four.

mod trial;

use super::Real;
use super::ask::always;
use super::combine::{copy, start_plus_scaled, weighted_sum};
use super::step_control::StepControl;
use super::tableau::{B, D};
use crate::{Chain, ChainState, Error, Scalar};
use trial::Failure;

/// How much work an integrator with step size control did.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Statistics {
    /// Steps that were taken.
    pub accepted: u64,
    /// Tries that missed the tolerance or were not finite.
    pub rejected: u64,
    /// Evaluations of [`Chain::derivative_into`].
    pub evaluations: u64,
}

/// Dormand and Prince's Runge–Kutta method of order five that chooses its own steps.
///
/// The error of a step is estimated by comparison with a method of order four, for every coordinate
/// y and every rate, in units of absolute + relative · |y|; a step is accepted if the root mean
/// square of these is at most one. The next step follows by proportional-integral control. Where
/// the chain is computed in lanes, all take the same step and the worst lane decides.
///
/// The clock moves from one representable time to another and the step is exactly their difference,
/// so no rounding adds up.
///
/// The last evaluation of a step is at its end, with quaternions already brought back to unit
/// length, and serves as the first one of the next step inside [`advance_to`](Dopri5::advance_to): six
/// evaluations a step. [`step`](Dopri5::step) always evaluates anew, seven times, since chain,
/// state and inputs may have changed since the last call.
///
/// It keeps 16 states of the chain: those of the last accepted step, for
/// [`interpolate`](Dopri5::interpolate), and those of the step that is tried.
pub struct Dopri5<C: Chain> {
    relative: Real<C>,
    absolute: Real<C>,
    control: StepControl<Real<C>>,
    statistics: Statistics,
    /// The last accepted step and the one that is tried, in turn.
    steps: [Stages<C::State>; 2],
    /// Whether the second of both is the one that is tried.
    second: bool,
    /// The rate at the second stage, which no result needs; then the error.
    scratch: C::State,
    /// The state of a stage, and the end of the step that was tried last.
    end: C::State,
    /// The time at the end of the last accepted step, if its stages are known.
    accepted: Option<Real<C>>,
}

/// What is known of a step.
#[derive(Clone)]
struct Stages<S> {
    start: S,
    /// Rates at the stages 1 and 3 to 7.
    rates: [S; 6],
}

// Derived, both would ask the same of the chain's own type.
impl<C: Chain> Clone for Dopri5<C> {
    fn clone(&self) -> Self {
        Self {
            relative: self.relative,
            absolute: self.absolute,
            control: self.control,
            statistics: self.statistics,
            steps: self.steps.clone(),
            second: self.second,
            scratch: self.scratch.clone(),
            end: self.end.clone(),
            accepted: self.accepted,
        }
    }
}

impl<C: Chain> core::fmt::Debug for Dopri5<C> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("Dopri5")
            .field("relative", &self.relative)
            .field("absolute", &self.absolute)
            .field("statistics", &self.statistics)
            .finish_non_exhaustive()
    }
}

impl<C: Chain> Dopri5<C> {
    /// An integrator with these tolerances for the error of one step: `relative` to each entry of
    /// the state, and `absolute` in its unit. One of them may be zero.
    pub fn new(relative: Real<C>, absolute: Real<C>) -> Self {
        let state = |_| C::State::default();
        Self {
            relative,
            absolute,
            control: StepControl::new(),
            statistics: Statistics::default(),
            steps: core::array::from_fn(|_| Stages {
                start: C::State::default(),
                rates: core::array::from_fn(state),
            }),
            second: false,
            scratch: C::State::default(),
            end: C::State::default(),
            accepted: None,
        }
    }

    /// Sets the size in s of the first step to try. Without it, or with zero, it is guessed from
    /// the first rates.
    pub fn with_first_step(mut self, step: Real<C>) -> Self {
        self.control.step = step.abs();
        self
    }

    /// Sets the shortest and the longest step in s. A step that ends an interval may be shorter
    /// than the shortest one.
    pub fn with_step_limits(mut self, minimum: Real<C>, maximum: Real<C>) -> Self {
        (self.control.minimum, self.control.maximum) = (minimum.abs(), maximum.abs());
        self
    }

    /// The size in s of the step that would be tried next; zero as long as nothing is known.
    pub fn next_step(&self) -> Real<C> {
        self.control.step
    }

    /// The work done since the integrator was made.
    pub fn statistics(&self) -> Statistics {
        self.statistics
    }

    /// Takes `state` one accepted step forward in time.
    ///
    /// `inputs` is asked at each stage, with the time in s and the stage's state, whose quaternions
    /// are of unit length only up to the stage's error.
    ///
    /// # Errors
    /// - [`Error::InvalidParameter`] if a tolerance is negative or NaN, or both are zero.
    /// - Those of [`Chain::check_state`], and of [`Chain::derivative_into`] at the start.
    /// - Those of [`Chain::check_inputs`] at any stage.
    /// - [`Error::StepTooSmall`] if no step meets the tolerance, or if all steps give values that are
    ///   not finite; another error of [`Chain::derivative_into`] or [`Chain::project`] if even the
    ///   shortest step fails with it.
    ///
    /// `state` is left as it was.
    pub fn step(
        &mut self,
        chain: &C,
        state: &mut C::State,
        inputs: impl FnMut(C::Scalar, &C::State) -> C::Inputs,
    ) -> Result<(), Error> {
        self.try_step(chain, state, always::<C>(inputs))
    }

    /// Takes `state` one accepted step forward in time, as [`step`](Dopri5::step) does, with
    /// `inputs` that may fail.
    ///
    /// # Errors
    /// The first error of `inputs`, unchanged: it ends the step at once, and no shorter step is
    /// tried. The size of the [next step](Dopri5::next_step) and what
    /// [`interpolate`](Dopri5::interpolate) gives are left as they were; evaluations and rejected
    /// tries are counted. Those of [`step`](Dopri5::step), as an `E`.
    ///
    /// `state` is left as it was.
    pub fn try_step<E: From<Error>>(
        &mut self,
        chain: &C,
        state: &mut C::State,
        mut inputs: impl FnMut(C::Scalar, &C::State) -> Result<C::Inputs, E>,
    ) -> Result<(), E> {
        chain.check_state(state)?;
        let before = self.control;
        let begun = self.begin(chain, state, &mut inputs, false);
        let taken = begun.and_then(|()| self.take(chain, &mut inputs, None));
        taken.map_err(|failure| self.failed(failure, before))?;
        copy(state, &self.end);
        Ok(())
    }

    /// Takes `state` to the time `end` in s, before or after its own, and lands on it exactly.
    ///
    /// # Errors
    /// Those of [`step`](Dopri5::step), and [`Error::NotFinite`] if `end` is not finite. `state` is
    /// then what the last accepted step led to.
    pub fn advance_to(
        &mut self,
        chain: &C,
        state: &mut C::State,
        end: Real<C>,
        inputs: impl FnMut(C::Scalar, &C::State) -> C::Inputs,
    ) -> Result<(), Error> {
        self.try_advance_to(chain, state, end, always::<C>(inputs))
    }

    /// Integrates `state` over `duration` in s, as [`advance_to`](Dopri5::advance_to) does to the time of
    /// `state` plus `duration`.
    ///
    /// A negative duration goes back in time. The end time is rounded, so calls in a row add up rounding
    /// errors; [`advance_to`](Dopri5::advance_to) does not.
    ///
    /// # Errors
    /// Those of [`advance_to`](Dopri5::advance_to).
    pub fn advance_by(
        &mut self,
        chain: &C,
        state: &mut C::State,
        duration: Real<C>,
        inputs: impl FnMut(C::Scalar, &C::State) -> C::Inputs,
    ) -> Result<(), Error> {
        self.try_advance_by(chain, state, duration, always::<C>(inputs))
    }

    /// Takes `state` to the time `end` in s, as [`advance_to`](Dopri5::advance_to) does, with `inputs`
    /// that may fail.
    ///
    /// # Errors
    /// The first error of `inputs`, unchanged, as of [`try_step`](Dopri5::try_step). Those of
    /// [`advance_to`](Dopri5::advance_to), as an `E`. `state`, the size of the next step and the dense
    /// output are then what the last accepted step led to.
    pub fn try_advance_to<E: From<Error>>(
        &mut self,
        chain: &C,
        state: &mut C::State,
        end: Real<C>,
        mut inputs: impl FnMut(C::Scalar, &C::State) -> Result<C::Inputs, E>,
    ) -> Result<(), E> {
        if !end.is_finite() {
            return Err(Error::NotFinite.into());
        }
        chain.check_state(state)?;
        if state.time().max_lane() == end {
            return Ok(());
        }
        let mut before = self.control;
        self.begin(chain, state, &mut inputs, end < state.time().max_lane())
            .map_err(|failure| self.failed(failure, before))?;
        loop {
            self.take(chain, &mut inputs, Some(end))
                .map_err(|failure| self.failed(failure, before))?;
            copy(state, &self.end);
            if state.time().max_lane() == end {
                return Ok(());
            }
            before = self.control;
            self.go_on();
        }
    }

    /// Integrates `state` over `duration` in s as [`advance_by`](Dopri5::advance_by) does, with `inputs`
    /// that may fail.
    ///
    /// # Errors
    /// Those of [`try_advance_to`](Dopri5::try_advance_to).
    pub fn try_advance_by<E: From<Error>>(
        &mut self,
        chain: &C,
        state: &mut C::State,
        duration: Real<C>,
        inputs: impl FnMut(C::Scalar, &C::State) -> Result<C::Inputs, E>,
    ) -> Result<(), E> {
        let end = state.time().max_lane() + duration;
        self.try_advance_to(chain, state, end, inputs)
    }

    /// Writes the state at `time`, in s, within the last accepted step to `out`, to order four and
    /// with unit quaternions.
    ///
    /// # Errors
    /// [`Error::OutsideStep`] if `time` lies outside the last accepted step, or if there was none,
    /// or if the last call of [`step`](Dopri5::step) or [`advance_to`](Dopri5::advance_to) failed for
    /// another reason than an error of its inputs or of its arguments. `out` is left as it was.
    pub fn interpolate(&self, chain: &C, time: Real<C>, out: &mut C::State) -> Result<(), Error> {
        let Some(end) = self.accepted else {
            return Err(Error::OutsideStep);
        };
        let [first, second] = &self.steps;
        let Stages { start: from, rates } = if self.second { first } else { second };
        let start = from.time().max_lane();
        if !((start <= time && time <= end) || (end <= time && time <= start)) {
            return Err(Error::OutsideStep);
        }
        let one = Real::<C>::constant(1.0);
        let along = (time - start) * (end - start).recip();
        let (square, left) = (along * along, one - along);
        // Hermite's cubic through both ends, y₀ + h θ [ (1−θ)² k₁ + θ(3−2θ) Σ b k − θ(1−θ) k₇ ],
        // and a quartic on top.
        let hermite = C::Scalar::splat(square * (one + left + left));
        let quartic = C::Scalar::splat(square * left * left);
        let [mut w1, w3, w4, w5, w6, mut w7] = D.map(|d| quartic * C::Scalar::constant(d));
        w1 += C::Scalar::splat(along * left * left);
        w7 += C::Scalar::splat(-(square * left));
        let [b1, b3, b4, b5, b6] = B.map(|b| hermite * C::Scalar::constant(b));

        let weights = [w1 + b1, w3 + b3, w4 + b4, w5 + b5, w6 + b6, w7];
        weighted_sum(out, weights, rates.each_ref());
        start_plus_scaled(out, from, C::Scalar::splat(end - start));
        out.set_time(C::Scalar::splat(time));
        chain.normalize(out);
        Ok(())
    }

    /// What is left of a failed step: after an error of the inputs the step size control is as
    /// `before` it, and the last accepted step is kept.
    fn failed<E: From<Error>>(&mut self, failure: Failure<E>, before: StepControl<Real<C>>) -> E {
        match failure {
            Failure::Inputs(error) => {
                self.control = before;
                error
            }
            Failure::Chain(error) => {
                self.accepted = None;
                error.into()
            }
        }
    }
}
