//! One step: its start, attempts of different sizes, and the stages of each attempt.

use super::stiffness::is_limited;
use super::{Dopri5, Stages, Statistics};
use crate::description::Origin;
use crate::integrate::Real;
use crate::integrate::ask::ask;
use crate::integrate::combine::{
    add_scaled, copy, has_finite_entries, is_finite, not_finite, start_plus_scaled, weighted_sum,
};
use crate::integrate::step_control::{norm, power};
use crate::integrate::tableau::{A2, A3, A4, A5, A6, ABSCISSAE, B, E};
use crate::{Chain, ChainState, Error, Scalar};

/// The reason why a step failed.
pub(super) enum Failure<X> {
    /// An error of the inputs or of the state at the start, which ends the step.
    Inputs(X),
    /// An error of the chain or of the step size control. During an attempt, a shorter step may not have it.
    Chain(Error),
}

impl<X> From<Error> for Failure<X> {
    fn from(error: Error) -> Self {
        Failure::Chain(error)
    }
}

impl<C: Chain> Dopri5<C> {
    /// Sets the start and the first rate, and estimates the first step size if there is none.
    pub(super) fn begin<X: From<Error>>(
        &mut self,
        chain: &C,
        state: &C::State,
        inputs: &mut impl FnMut(C::Scalar, &C::State) -> Result<C::Inputs, X>,
        backwards: bool,
    ) -> Result<(), Failure<X>> {
        let zero = Real::<C>::default();
        let usable =
            self.relative >= zero && self.absolute >= zero && self.relative + self.absolute > zero;
        if !usable {
            let error = Error::InvalidParameter { name: "tolerance", reason: "must be positive" };
            return Err(error.into());
        }
        if !self.control.has_limits() {
            let (name, reason) =
                ("step limits", "must be a minimum and a positive maximum that is not below it");
            return Err(Error::InvalidParameter { name, reason }.into());
        }
        let Self { steps: [a, b], end, .. } = self;
        let Stages { start, rates: [first, ..] } = if self.second { b } else { a };
        copy(start, state);
        copy(end, state);
        if !is_finite(start) {
            return Err(Failure::Inputs(not_finite(start).into()));
        }
        evaluate(chain, end, inputs, &mut self.statistics, first)?;
        if !has_finite_entries(first) {
            return Err(Error::NotFinite(Origin::Result).into());
        }
        if self.control.step == zero {
            self.control.step = self.guess_first_step(chain, inputs, backwards)?;
        }
        Ok(())
    }

    /// Starts the next step at the end of the last one, whose last stage was at this state, with the same chain and
    /// inputs.
    pub(super) fn go_on(&mut self) {
        let [a, b] = &mut self.steps;
        let (next, last) = if self.second { (b, a) } else { (a, b) };
        let (Stages { rates: [first, ..], start }, Stages { rates: [.., at_end], .. }) =
            (next, last);
        copy(first, at_end);
        copy(start, &self.end);
    }

    /// Estimates a first step size whose error is about a hundredth of the tolerance, from one Euler step (Hairer,
    /// Nørsett and Wanner, section II.4).
    fn guess_first_step<X: From<Error>>(
        &mut self,
        chain: &C,
        inputs: &mut impl FnMut(C::Scalar, &C::State) -> Result<C::Inputs, X>,
        backwards: bool,
    ) -> Result<Real<C>, Failure<X>> {
        let (small, hundredth) = (Real::<C>::constant(1e-5), Real::<C>::constant(0.01));
        let (relative, absolute) =
            (C::Scalar::splat(reachable(self.relative)), C::Scalar::splat(self.absolute));
        let size =
            |value: &C::State, start: &C::State| norm(value, (start, start), relative, absolute);
        let Self { steps: [a, b], end, scratch: second, .. } = self;
        let Stages { start, rates: [first, ..] } = if self.second { b } else { a };

        let (state, rate) = (size(start, start), size(first, start));
        let known = state > small && rate > small && state.is_finite() && rate.is_finite();
        let step = if known { hundredth * state * rate.recip() } else { Real::<C>::constant(1e-6) };
        let signed = C::Scalar::splat(if backwards { -step } else { step });
        add_scaled(end, signed, first);
        end.set_time(start.time() + signed);
        match evaluate(chain, end, inputs, &mut self.statistics, second) {
            Ok(()) => {}
            Err(Failure::Chain(_)) => return Ok(step),
            Err(failure) => return Err(failure),
        }
        add_scaled(second, C::Scalar::constant(-1.0), first);
        let change = size(second, start) * step.recip();
        let fastest = if change > rate { change } else { rate };
        // 26/128 approximates 1/5, the exponent of the error.
        let by_change = power(hundredth * fastest.recip(), 26);
        let longest = Real::<C>::constant(100.0) * step;
        Ok(match (by_change > Real::<C>::default(), by_change < longest) {
            (true, true) => by_change,
            (true, false) => longest,
            // The change is too fast to be measured, or NaN.
            (false, _) => step,
        })
    }

    /// Attempts steps until one is accepted; none goes beyond `limit`.
    pub(super) fn take<X: From<Error>>(
        &mut self,
        chain: &C,
        inputs: &mut impl FnMut(C::Scalar, &C::State) -> Result<C::Inputs, X>,
        limit: Option<Real<C>>,
    ) -> Result<(), Failure<X>> {
        let [a, b] = &self.steps;
        let start = if self.second { b } else { a }.start.time().max_lane();
        let left = limit.map_or(Real::<C>::default(), |limit| limit - start);
        let shortest = self.control.shortest(start, left);
        let mut cause = Error::StepTooSmall;
        loop {
            let end = end_of_step(start, self.control.proposal(shortest), limit);
            if end == start {
                return Err(cause.into());
            }
            let size = (end - start).abs();
            let outcome = match self.attempt(chain, inputs, end) {
                Ok(outcome) => Ok(outcome),
                Err(Failure::Chain(error)) => Err(error),
                Err(failure) => return Err(failure),
            };
            if let Ok((error, limited)) = outcome
                && error <= Real::<C>::constant(1.0)
            {
                self.control.accept(size, error);
                self.statistics.accepted = self.statistics.accepted.saturating_add(1);
                self.detector.count(limited);
                self.accepted = Some(end);
                self.second = !self.second;
                return Ok(());
            }
            self.statistics.rejected = self.statistics.rejected.saturating_add(1);
            let error = outcome.map_or(Real::<C>::constant(f64::INFINITY), |(error, _)| error);
            cause = match outcome {
                Ok(_) | Err(Error::NotFinite(_)) => Error::StepTooSmall,
                Err(other) => other,
            };
            self.control.reject(shortest, size, error).map_err(|_| cause)?;
        }
    }

    /// Attempts one step to the time `end`, with the result in `self.end`, and returns its error in units of the
    /// tolerance and whether it is at the limit of stability.
    fn attempt<X: From<Error>>(
        &mut self,
        chain: &C,
        inputs: &mut impl FnMut(C::Scalar, &C::State) -> Result<C::Inputs, X>,
        end: Real<C>,
    ) -> Result<(Real<C>, bool), Failure<X>> {
        let Self { steps: [a, b], scratch: k2, end: state, statistics: count, .. } = self;
        let Stages { start, rates: [k1, k3, k4, k5, k6, k7] } = if self.second { b } else { a };
        let step = C::Scalar::splat(end - start.time().max_lane());
        let end = C::Scalar::splat(end);
        let time = start.time();
        let [c2, c3, c4, c5] = ABSCISSAE.map(|c| time + step * C::Scalar::constant(c));

        lead_to(state, start, step, c2, A2, [k1]);
        evaluate(chain, state, inputs, count, k2)?;
        lead_to(state, start, step, c3, A3, [k1, k2]);
        evaluate(chain, state, inputs, count, k3)?;
        lead_to(state, start, step, c4, A4, [k1, k2, k3]);
        evaluate(chain, state, inputs, count, k4)?;
        lead_to(state, start, step, c5, A5, [k1, k2, k3, k4]);
        evaluate(chain, state, inputs, count, k5)?;
        lead_to(state, start, step, end, A6, [k1, k2, k3, k4, k5]);
        evaluate(chain, state, inputs, count, k6)?;
        lead_to(state, start, step, end, B, [k1, k3, k4, k5, k6]);
        // Projected before the last evaluation, so that this is at the state from which the next step starts. The
        // error estimate changes by as little as the state does, which is of higher order.
        chain.normalize(state);
        let time = state.time();
        chain.project(state, |state| ask(chain, inputs, time, state).map_err(Failure::Inputs))?;
        evaluate(chain, state, inputs, count, k7)?;
        if !is_finite(state) {
            return Err(not_finite(state).into());
        }
        let limited = is_limited([k1, k2, k3, k4, k5, k6, k7]);
        weighted_sum(k2, E.map(|e| step * C::Scalar::constant(e)), [k1, k3, k4, k5, k6, k7]);
        let (relative, absolute) =
            (C::Scalar::splat(reachable(self.relative)), C::Scalar::splat(self.absolute));
        Ok((norm(k2, (start, state), relative, absolute), limited))
    }
}

/// Returns a relative tolerance that rounding does not exceed.
fn reachable<R: Scalar + PartialOrd>(relative: R) -> R {
    let least = R::constant(4.0) * R::epsilon();
    if relative < least { least } else { relative }
}

/// Returns the end of a step of this size from `start`: `limit` if that is near, and not so close before it that the
/// next step would be very short.
fn end_of_step<R: Scalar<Real = R, Mask = bool> + PartialOrd>(
    start: R,
    size: R,
    limit: Option<R>,
) -> R {
    let Some(limit) = limit else { return start + size };
    let left = limit - start;
    if size >= left.abs() {
        limit
    } else if size + size > left.abs() {
        start + left * R::constant(0.5)
    } else {
        start + size.copysign(left)
    }
}

/// `state` = `start` + step · Σ weight · rate, at `time`.
#[inline(always)]
fn lead_to<S: ChainState, const N: usize>(
    state: &mut S,
    start: &S,
    step: S::Scalar,
    time: S::Scalar,
    weights: [f64; N],
    rates: [&S; N],
) {
    weighted_sum(state, weights.map(S::Scalar::constant), rates);
    start_plus_scaled(state, start, step);
    state.set_time(time);
}

/// Evaluates the rate at `state` and counts the evaluation.
fn evaluate<C: Chain, X: From<Error>>(
    chain: &C,
    state: &C::State,
    inputs: &mut impl FnMut(C::Scalar, &C::State) -> Result<C::Inputs, X>,
    statistics: &mut Statistics,
    rate: &mut C::State,
) -> Result<(), Failure<X>> {
    statistics.evaluations = statistics.evaluations.saturating_add(1);
    let acting = ask(chain, inputs, state.time(), state).map_err(Failure::Inputs)?;
    Ok(chain.derivative_into(state, &acting, rate)?)
}
