//! The method of Dormand and Prince of order five, with an error estimate of order four.

mod stiffness;
mod trial;

use super::Real;
use super::ask::always;
use super::combine::{copy, start_plus_scaled, weighted_sum};
use super::fixed_step::Clock;
use super::held::held_methods;
use super::step_control::StepControl;
use super::tableau::{B, D};
use crate::description::Origin;
use crate::{Chain, ChainState, Error, Scalar};
use stiffness::Detector;
use trial::Failure;

/// The work of an integrator with step size control.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Statistics {
    /// The number of accepted steps.
    pub accepted: u64,
    /// The number of attempts that missed the tolerance or were not finite.
    pub rejected: u64,
    /// The number of evaluations of [`Chain::derivative_into`].
    pub evaluations: u64,
}

/// The Runge–Kutta method of Dormand and Prince of order five, with step size control.
///
/// The error of a step is estimated by comparison with a method of order four, for each coordinate y and each rate, in
/// units of absolute + relative · |y|. A step is accepted if the root mean square of these errors is at most one. The
/// next step size follows from proportional-integral control. All lanes take the same step, and the lane with the
/// largest error decides.
///
/// The step is the exact difference of two representable times, so rounding errors do not add up in the time.
///
/// The last evaluation of a step is at its end, with normalised quaternions. Inside
/// [`advance_to`](Dopri5::advance_to) it serves as the first evaluation of the next step: six evaluations per step.
/// [`step`](Dopri5::step) always evaluates seven times, because chain, state and inputs may have changed since the last
/// call.
///
/// The integrator stores 16 states of the chain: those of the last accepted step, for
/// [`interpolate`](Dopri5::interpolate), and those of the present attempt.
#[doc(alias("ode45", "RK45", "DOPRI", "Dormand-Prince", "RungeKutta5"))]
pub struct Dopri5<C: Chain> {
    relative: Real<C>,
    absolute: Real<C>,
    control: StepControl<Real<C>>,
    statistics: Statistics,
    detector: Detector,
    /// The last accepted step and the present attempt, alternately.
    steps: [Stages<C::State>; 2],
    /// Whether the second of both is the present attempt.
    second: bool,
    /// The rate at the second stage, which the result does not depend on; then the error.
    scratch: C::State,
    /// The state of a stage; then the end of the last attempt.
    end: C::State,
    /// The time at the end of the last accepted step, if its stages are known.
    accepted: Option<Real<C>>,
    /// The time that the durations of [`advance_by`](Dopri5::advance_by) add up to.
    clock: Clock<Real<C>>,
}

/// The start of a step and the rates at its stages.
#[derive(Clone)]
struct Stages<S> {
    start: S,
    /// Rates at the stages 1 and 3 to 7.
    rates: [S; 6],
}

// Derived implementations would require the traits of the type of the chain.
impl<C: Chain> Clone for Dopri5<C> {
    fn clone(&self) -> Self {
        Self {
            relative: self.relative,
            absolute: self.absolute,
            control: self.control,
            statistics: self.statistics,
            detector: self.detector,
            steps: self.steps.clone(),
            second: self.second,
            scratch: self.scratch.clone(),
            end: self.end.clone(),
            accepted: self.accepted,
            clock: self.clock,
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

held_methods!(Dopri5);

impl<C: Chain> Dopri5<C> {
    /// Makes an integrator with these tolerances for the error of one step.
    ///
    /// `relative` is relative to each entry of the state, `absolute` is in the unit of the entry. One of them may be
    /// zero. A relative tolerance below four times the machine epsilon counts as this, since rounding exceeds less.
    pub fn new(relative: Real<C>, absolute: Real<C>) -> Self {
        let state = |_| C::State::zero_position();
        Self {
            relative,
            absolute,
            control: StepControl::new(),
            statistics: Statistics::default(),
            detector: Detector::default(),
            steps: core::array::from_fn(|_| Stages {
                start: C::State::zero_position(),
                rates: core::array::from_fn(state),
            }),
            second: false,
            scratch: C::State::zero_position(),
            end: C::State::zero_position(),
            accepted: None,
            clock: Clock::default(),
        }
    }

    /// Sets the size in s of the first attempted step.
    ///
    /// The default, zero, estimates it from the first rates.
    pub fn with_first_step(mut self, step: Real<C>) -> Self {
        self.control.step = step.abs();
        self
    }

    /// Sets the shortest and the longest step in s.
    ///
    /// The last step to an end time may be shorter. Steps return [`Error::InvalidParameter`] unless the maximum is positive and
    /// the minimum is at most the maximum.
    pub fn with_step_limits(mut self, minimum: Real<C>, maximum: Real<C>) -> Self {
        (self.control.minimum, self.control.maximum) = (minimum.abs(), maximum.abs());
        self
    }

    /// Returns the size in s of the next attempted step, or zero if it is not known yet.
    pub fn next_step(&self) -> Real<C> {
        self.control.step
    }

    /// Returns the work done since the integrator was made.
    pub fn statistics(&self) -> Statistics {
        self.statistics
    }

    /// Returns whether stability and not the tolerance limits the present steps: the problem is stiff.
    ///
    /// The answer is yes after 15 accepted steps h with h·|λ| > 3.25, and no again after 6 consecutive steps below, where
    /// |λ| estimates the fastest decay from the last two stages. Undamped oscillations, which limit the step to about
    /// h·|λ| = 1, are not reported.
    ///
    /// A stiff problem is integrated correctly, but by many short steps. Use
    /// [`LinearlyImplicitEuler`](crate::LinearlyImplicitEuler) if stiff springs, dampers or limits in hinges are the
    /// reason. Use an implicit method with error control, such as BDF of the crate `diffsol`, for small errors.
    #[doc(alias("stiffness"))]
    pub fn is_stiff(&self) -> bool {
        self.detector.is_stiff()
    }

    /// Integrates `state` over one accepted step, forward in time.
    ///
    /// `inputs` is evaluated at each stage. Its arguments are the time in s and the state of the stage, whose quaternions
    /// have unit length up to the error of the stage.
    ///
    /// # Errors
    /// - [`Error::InvalidParameter`] if a tolerance is negative or NaN, or both are zero, or the limits of the step are not a
    ///   minimum and a maximum.
    /// - Those of [`Chain::check_state`], and of [`Chain::derivative_into`] at the start.
    /// - Those of [`Chain::check_inputs`] at any stage.
    /// - [`Error::StepTooSmall`] if no step meets the tolerance, or if all steps give values that are
    ///   not finite; another error of [`Chain::derivative_into`] or [`Chain::project`] if even the
    ///   shortest step fails with it.
    ///
    /// `state` is then unchanged.
    pub fn step(
        &mut self,
        chain: &C,
        state: &mut C::State,
        inputs: impl FnMut(C::Scalar, &C::State) -> C::Inputs,
    ) -> Result<(), Error> {
        self.try_step(chain, state, always::<C>(inputs))
    }

    /// Integrates `state` over one accepted step as [`step`](Dopri5::step) does, with `inputs` that may fail.
    ///
    /// # Errors
    /// The first error of `inputs`, unchanged: it ends the step at once, without an attempt at a shorter step. The size
    /// of the [next step](Dopri5::next_step) and the results of [`interpolate`](Dopri5::interpolate) are then unchanged;
    /// evaluations and rejected attempts are counted. Those of [`step`](Dopri5::step), converted to `E`.
    ///
    /// `state` is then unchanged.
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

    /// Integrates `state` to the time `end` in s and ends exactly there.
    ///
    /// `end` may be earlier than the time of `state`.
    ///
    /// # Errors
    /// Those of [`step`](Dopri5::step), and [`Error::NotFinite`] if `end` is not finite. `state` is then the
    /// result of the last accepted step.
    #[doc(alias("AdvanceTo", "Simulator"))]
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
    /// A negative duration goes back in time. The end time is rounded, and the next call adds the rounding error:
    /// durations of calls in a row add up to their sum. A call whose duration is shorter than the spacing of times may
    /// change nothing.
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

    /// Integrates `state` to the time `end` in s as [`advance_to`](Dopri5::advance_to) does, with `inputs` that may
    /// fail.
    ///
    /// # Errors
    /// The first error of `inputs`, unchanged, as for [`try_step`](Dopri5::try_step). Those of
    /// [`advance_to`](Dopri5::advance_to), converted to `E`. `state`, the size of the next step and the dense output are
    /// then those after the last accepted step.
    pub fn try_advance_to<E: From<Error>>(
        &mut self,
        chain: &C,
        state: &mut C::State,
        end: Real<C>,
        mut inputs: impl FnMut(C::Scalar, &C::State) -> Result<C::Inputs, E>,
    ) -> Result<(), E> {
        if !end.is_finite() {
            return Err(Error::NotFinite(Origin::End).into());
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
        let clock = self.clock.advanced(state.time().max_lane(), duration);
        self.try_advance_to(chain, state, clock.time, inputs)?;
        self.clock = clock;
        Ok(())
    }

    /// Computes the state at `time` in s within the last accepted step into `out` (dense output).
    ///
    /// The interpolation has order four and unit quaternions.
    ///
    /// # Errors
    /// [`Error::OutsideStep`] if `time` lies outside the last accepted step, or if there was none,
    /// or if the last call of [`step`](Dopri5::step) or [`advance_to`](Dopri5::advance_to) failed for a reason other than
    /// an error of its inputs or of its arguments. `out` is then unchanged.
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
        // plus a quartic term.
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

    /// Restores the state of the integrator after a failed step, and returns the error.
    ///
    /// After an error of the inputs the step size control is as `before` the step, and the last accepted step is kept.
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
