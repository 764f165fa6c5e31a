//! The parts that all methods with a fixed step share: the clock, the steps to an end time, the end of a step.

use super::Real;
use super::ask::ask;
use super::combine::{copy, is_finite, not_finite};
use super::step_control::LEAST_PART;
use crate::description::Origin;
use crate::{Chain, ChainState, Error, Scalar};

/// A method whose steps have a given size.
pub(super) trait FixedStep<C: Chain> {
    /// Returns the step size and the clock.
    fn pace(&mut self) -> &mut Pace<C::Scalar>;

    /// Integrates `state` over one step.
    ///
    /// # Errors
    /// Those of `inputs` and of [`Chain::derivative_into`], and [`Error::NotFinite`] if the result is
    /// not finite. `state` is then unchanged.
    fn take<E: From<Error>>(
        &mut self,
        chain: &C,
        state: &mut C::State,
        span: Span<C::Scalar>,
        inputs: &mut impl FnMut(C::Scalar, &C::State) -> Result<C::Inputs, E>,
    ) -> Result<(), E>;
}

/// Takes one step of full size.
pub(super) fn step<C: Chain, E: From<Error>>(
    method: &mut impl FixedStep<C>,
    chain: &C,
    state: &mut C::State,
    mut inputs: impl FnMut(C::Scalar, &C::State) -> Result<C::Inputs, E>,
) -> Result<(), E> {
    chain.check_state(state)?;
    let pace = method.pace();
    let (span, clock) = pace.whole(state.time(), pace.step);
    method.take(chain, state, span, &mut inputs)?;
    method.pace().clock = clock;
    Ok(())
}

/// Takes steps of full size and a last one that ends at the time `end`.
pub(super) fn advance_to<C: Chain, E: From<Error>>(
    method: &mut impl FixedStep<C>,
    chain: &C,
    state: &mut C::State,
    end: Real<C>,
    inputs: impl FnMut(C::Scalar, &C::State) -> Result<C::Inputs, E>,
) -> Result<(), E> {
    let now = state.time().max_lane();
    if now == end {
        return Ok(chain.check_state(state)?);
    }
    let target = Clock { time: C::Scalar::splat(end), lost: C::Scalar::default() };
    // The rounding of `end` and of the time at which the count started.
    let latest = if end.abs() > now.abs() { end.abs() } else { now.abs() };
    advance(method, chain, state, (target, Real::<C>::epsilon() * latest), inputs)
}

/// Takes steps of full size and a last one, which take the time `duration` together.
pub(super) fn advance_by<C: Chain, E: From<Error>>(
    method: &mut impl FixedStep<C>,
    chain: &C,
    state: &mut C::State,
    duration: Real<C>,
    inputs: impl FnMut(C::Scalar, &C::State) -> Result<C::Inputs, E>,
) -> Result<(), E> {
    if duration == Real::<C>::default() {
        return Ok(chain.check_state(state)?);
    }
    let target = method.pace().clock.advanced(state.time(), C::Scalar::splat(duration));
    advance(method, chain, state, (target, Real::<C>::epsilon() * duration.abs()), inputs)
}

/// Takes steps of full size and a last one that ends at a time. The last one may be longer by `rounding`, so that no short
/// one follows.
fn advance<C: Chain, E: From<Error>>(
    method: &mut impl FixedStep<C>,
    chain: &C,
    state: &mut C::State,
    (target, rounding): (Clock<C::Scalar>, Real<C>),
    mut inputs: impl FnMut(C::Scalar, &C::State) -> Result<C::Inputs, E>,
) -> Result<(), E> {
    if !target.time.max_lane().is_finite() {
        return Err(Error::NotFinite(Origin::End).into());
    }
    chain.check_state(state)?;
    loop {
        let Next { span, clock, is_last } = method.pace().towards(state.time(), target, rounding);
        if !is_last && !method.pace().reaches(state.time(), target, clock) {
            return Err(
                Error::InvalidParameter { name: "step", reason: "must move the clock" }.into()
            );
        }
        method.take(chain, state, span, &mut inputs)?;
        method.pace().clock = clock;
        if is_last {
            return Ok(());
        }
    }
}

/// Ends a step: sets the time of `result`, normalises and projects it, and copies it to `state`.
pub(super) fn arrive<C: Chain, E: From<Error>>(
    chain: &C,
    result: &mut C::State,
    time: C::Scalar,
    state: &mut C::State,
    inputs: &mut impl FnMut(C::Scalar, &C::State) -> Result<C::Inputs, E>,
) -> Result<(), E> {
    result.set_time(time);
    chain.normalize(result);
    chain.project(result, |state| ask(chain, inputs, time, state))?;
    if !is_finite(result) {
        return Err(not_finite(result).into());
    }
    copy(state, result);
    Ok(())
}

/// The size of a step, and the time at its end.
#[derive(Clone, Copy)]
pub(super) struct Span<T> {
    pub(super) step: T,
    pub(super) end: T,
}

/// The step size, and the clock that adds up the steps.
#[derive(Clone, Copy)]
pub(super) struct Pace<T> {
    pub(super) step: T,
    clock: Clock<T>,
}

impl<T: Scalar> Pace<T> {
    pub(super) fn new(step: T) -> Self {
        Self { step, clock: Clock { time: T::default(), lost: T::default() } }
    }

    /// Returns a step of full size from `now`, and the clock after it.
    fn whole(&self, now: T, step: T) -> (Span<T>, Clock<T>) {
        let clock = self.clock.advanced(now, step);
        (Span { step, end: clock.time }, clock)
    }

    /// Returns the next step towards a time: a step of full size, or the time left if that is shorter, or longer by no
    /// more than `rounding`. The lane with the largest value decides.
    fn towards(&self, now: T, target: Clock<T>, rounding: T::Real) -> Next<T> {
        let (owed, lost) = (self.clock.owed(now).max_lane(), target.lost.max_lane());
        let left = (target.time.max_lane() - now.max_lane()) + (lost - owed);
        let size = self.step.max_lane().abs();
        let rounding = rounding + T::Real::epsilon() * (lost.abs() + owed.abs());
        let rounding = if rounding < size { rounding } else { size };
        let is_last = left.abs() <= size + rounding;
        let (span, clock) = match is_last {
            true => (Span { step: T::splat(left), end: target.time }, target),
            false => self.whole(now, T::splat(size.copysign(left))),
        };
        Next { span, clock, is_last }
    }

    /// Returns whether steps reach a time: a step moves the clock, and is not too small a part of the time left.
    fn reaches(&self, now: T, target: Clock<T>, next: Clock<T>) -> bool {
        let left = target.time.max_lane() - now.max_lane();
        let moves = next.time.max_lane() != now.max_lane()
            || next.lost.max_lane() != self.clock.owed(now).max_lane();
        let is_short = self.step.max_lane().abs() <= T::Real::constant(LEAST_PART) * left.abs();
        moves && !is_short
    }
}

/// A step, and the clock after it.
struct Next<T> {
    span: Span<T>,
    clock: Clock<T>,
    is_last: bool,
}

/// A time and its rounding error (compensated summation).
#[derive(Clone, Copy, Default)]
pub(super) struct Clock<T> {
    pub(super) time: T,
    lost: T,
}

impl<T: Scalar> Clock<T> {
    /// Returns the rounding error of the time `now`, or zero if `now` is not the time of this clock.
    fn owed(self, now: T) -> T {
        if self.time == now { self.lost } else { T::default() }
    }

    /// Returns the clock one step after `now`.
    pub(super) fn advanced(self, now: T, step: T) -> Self {
        let change = step + self.owed(now);
        let time = now + change;
        // Knuth's two-sum, which is exact whichever of the two is larger.
        let back = time - now;
        Self { time, lost: (now - (time - back)) + (change - back) }
    }
}

/// The methods of an integrator that follow from its [`FixedStep`]: the step size, `advance_to`, `advance_by`, and those with
/// inputs that may fail.
macro_rules! fixed_step_methods {
    ($method:ident) => {
        impl<C: Chain> $method<C> {
            /// Returns the step size in s.
            pub fn step_size(&self) -> C::Scalar {
                self.pace.step
            }

            /// Sets the step size in s of the next steps.
            pub fn set_step_size(&mut self, step: C::Scalar) {
                self.pace.step = step;
            }

            /// Integrates `state` to the time `end` in s and ends exactly there.
            ///
            /// `end` may be earlier than the time of `state`. All steps have the step size and the sign of the
            /// direction, except that the last one is as long as the time left. All lanes must have the same
            /// time and step.
            ///
            /// # Errors
            /// Those of [`step`](Self::step), [`Error::NotFinite`] if `end` is not finite, and
            /// [`Error::InvalidParameter`] if the step is too small to reach `end`. `state` is then the result of the
            /// last complete step.
            #[doc(alias("AdvanceTo", "Simulator"))]
            pub fn advance_to(
                &mut self,
                chain: &C,
                state: &mut C::State,
                end: $crate::integrate::Real<C>,
                inputs: impl FnMut(C::Scalar, &C::State) -> C::Inputs,
            ) -> Result<(), Error> {
                self.try_advance_to(chain, state, end, always::<C>(inputs))
            }

            /// Integrates `state` over `duration` in s, with steps as [`advance_to`](Self::advance_to) takes
            /// them.
            ///
            /// A negative duration goes back in time. The time is summed with compensation: durations of calls in
            /// a row add up to their sum, also where they are shorter than the spacing of times.
            ///
            /// # Errors
            /// Those of [`advance_to`](Self::advance_to).
            pub fn advance_by(
                &mut self,
                chain: &C,
                state: &mut C::State,
                duration: $crate::integrate::Real<C>,
                inputs: impl FnMut(C::Scalar, &C::State) -> C::Inputs,
            ) -> Result<(), Error> {
                self.try_advance_by(chain, state, duration, always::<C>(inputs))
            }

            /// Takes one step as [`step`](Self::step) does, with `inputs` that may fail.
            ///
            /// # Errors
            /// The first error of `inputs`, unchanged, which ends the step at once, and those of
            /// [`step`](Self::step), converted to `E`. `state` and the integrator are unchanged.
            pub fn try_step<E: From<Error>>(
                &mut self,
                chain: &C,
                state: &mut C::State,
                inputs: impl FnMut(C::Scalar, &C::State) -> Result<C::Inputs, E>,
            ) -> Result<(), E> {
                fixed_step::step(self, chain, state, inputs)
            }

            /// Integrates `state` to the time `end` in s as [`advance_to`](Self::advance_to) does, with
            /// `inputs` that may fail.
            ///
            /// # Errors
            /// The first error of `inputs`, unchanged, which ends the step at once, and those of
            /// [`advance_to`](Self::advance_to), converted to `E`. `state` and the integrator are then those
            /// after the last complete step.
            pub fn try_advance_to<E: From<Error>>(
                &mut self,
                chain: &C,
                state: &mut C::State,
                end: $crate::integrate::Real<C>,
                inputs: impl FnMut(C::Scalar, &C::State) -> Result<C::Inputs, E>,
            ) -> Result<(), E> {
                fixed_step::advance_to(self, chain, state, end, inputs)
            }

            /// Integrates `state` over `duration` in s as [`advance_by`](Self::advance_by) does, with
            /// `inputs` that may fail.
            ///
            /// # Errors
            /// Those of [`try_advance_to`](Self::try_advance_to).
            pub fn try_advance_by<E: From<Error>>(
                &mut self,
                chain: &C,
                state: &mut C::State,
                duration: $crate::integrate::Real<C>,
                inputs: impl FnMut(C::Scalar, &C::State) -> Result<C::Inputs, E>,
            ) -> Result<(), E> {
                fixed_step::advance_by(self, chain, state, duration, inputs)
            }
        }
    };
}
pub(super) use fixed_step_methods;

/// Implements `Clone` and `Debug` for a method whose first field is its [`Pace`]. Derived implementations would require
/// them of the type of the chain.
macro_rules! clone_and_debug {
    ($method:ident { $($field:ident),* }) => {
        impl<C: Chain> Clone for $method<C> {
            fn clone(&self) -> Self {
                Self { pace: self.pace, $($field: self.$field.clone()),* }
            }
        }

        impl<C: Chain> core::fmt::Debug for $method<C> {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                f.debug_struct(stringify!($method))
                    .field("step_size", &self.pace.step)
                    .finish_non_exhaustive()
            }
        }
    };
}
pub(super) use clone_and_debug;
