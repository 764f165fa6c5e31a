//! Dormand and Prince's method of order five with an error estimate of order four.

use super::Real;
use super::ask::ask;
use super::combine::{
    add_scaled, copy, has_finite_entries, is_finite, start_plus_scaled, weighted_sum,
};
use super::step_control::{StepControl, norm, power};
use super::tableau::{A2, A3, A4, A5, A6, ABSCISSAE, B, D, E};
use crate::{Chain, ChainState, Error, Scalar};

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
/// length, and serves as the first one of the next step inside [`advance`](Dopri5::advance): six
/// evaluations a step. [`step`](Dopri5::step) always evaluates anew, seven times, since chain,
/// state and inputs may have changed since the last call.
pub struct Dopri5<C: Chain> {
    relative: Real<C>,
    absolute: Real<C>,
    control: StepControl<Real<C>>,
    statistics: Statistics,
    /// Rates at the seven stages; the second, which no result needs, gives its place to the error.
    rates: [C::State; 7],
    start: C::State,
    end: C::State,
    /// Whether `rates`, `start` and `end` are those of an accepted step.
    taken: bool,
}

// Derived, both would ask the same of the chain's own type.
impl<C: Chain> Clone for Dopri5<C> {
    fn clone(&self) -> Self {
        Self {
            relative: self.relative,
            absolute: self.absolute,
            control: self.control,
            statistics: self.statistics,
            rates: self.rates.clone(),
            start: self.start.clone(),
            end: self.end.clone(),
            taken: self.taken,
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
        Self {
            relative,
            absolute,
            control: StepControl::new(),
            statistics: Statistics::default(),
            rates: core::array::from_fn(|_| C::State::default()),
            start: C::State::default(),
            end: C::State::default(),
            taken: false,
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
    /// - [`Error::Parameter`] if a tolerance is negative or NaN, or both are zero.
    /// - Those of [`Chain::derivative_into`] at the start.
    /// - [`Error::StepTooSmall`] if no step meets the tolerance, or if all give what is not finite;
    ///   another error of [`Chain::derivative_into`] if that stands in the way of the shortest
    ///   step.
    ///
    /// `state` is left as it was.
    pub fn step(
        &mut self,
        chain: &C,
        state: &mut C::State,
        mut inputs: impl FnMut(C::Scalar, &C::State) -> C::Inputs,
    ) -> Result<(), Error> {
        chain.check_state(state)?;
        self.begin(chain, state, &mut inputs, false)?;
        self.take(chain, &mut inputs, None)?;
        copy(state, &self.end);
        Ok(())
    }

    /// Takes `state` to the time `end` in s, before or after its own, and lands on it exactly.
    ///
    /// # Errors
    /// Those of [`step`](Dopri5::step), and [`Error::NotFinite`] if `end` is not finite. `state` is
    /// then what the last accepted step led to.
    pub fn advance(
        &mut self,
        chain: &C,
        state: &mut C::State,
        end: Real<C>,
        mut inputs: impl FnMut(C::Scalar, &C::State) -> C::Inputs,
    ) -> Result<(), Error> {
        if !end.finite() {
            return Err(Error::NotFinite);
        }
        chain.check_state(state)?;
        if state.time().worst() == end {
            return Ok(());
        }
        self.begin(chain, state, &mut inputs, end < state.time().worst())?;
        loop {
            self.take(chain, &mut inputs, Some(end))?;
            copy(state, &self.end);
            if state.time().worst() == end {
                return Ok(());
            }
            // The last stage was at the very state the next step starts from, with the same chain
            // and inputs.
            let [first, .., last] = &mut self.rates;
            core::mem::swap(first, last);
            copy(&mut self.start, &self.end);
        }
    }

    /// Writes the state at `time`, in s, within the last accepted step to `out`, to order four and
    /// with unit quaternions.
    ///
    /// # Errors
    /// [`Error::OutsideStep`] if `time` lies outside the last step, or if the last call of
    /// [`step`](Dopri5::step) or [`advance`](Dopri5::advance) failed, or if there was none. `out`
    /// is left as it was.
    pub fn interpolate(&self, chain: &C, time: Real<C>, out: &mut C::State) -> Result<(), Error> {
        let (start, end) = (self.start.time().worst(), self.end.time().worst());
        let inside = (start <= time && time <= end) || (end <= time && time <= start);
        if !(self.taken && inside) {
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

        let [k1, _, k3, k4, k5, k6, k7] = &self.rates;
        weighted_sum(
            out,
            [w1 + b1, w3 + b3, w4 + b4, w5 + b5, w6 + b6, w7],
            [k1, k3, k4, k5, k6, k7],
        );
        start_plus_scaled(out, &self.start, C::Scalar::splat(end - start));
        out.set_time(C::Scalar::splat(time));
        chain.normalize(out);
        Ok(())
    }

    /// Sets start and first rate, and guesses the first step if there is none.
    fn begin(
        &mut self,
        chain: &C,
        state: &C::State,
        inputs: &mut impl FnMut(C::Scalar, &C::State) -> C::Inputs,
        backwards: bool,
    ) -> Result<(), Error> {
        let zero = Real::<C>::default();
        let usable =
            self.relative >= zero && self.absolute >= zero && self.relative + self.absolute > zero;
        if !usable {
            return Err(Error::Parameter { name: "tolerance", reason: "must be positive" });
        }
        self.taken = false;
        copy(&mut self.start, state);
        copy(&mut self.end, state);
        if !is_finite(&self.start) {
            return Err(Error::NotFinite);
        }
        let [first, ..] = &mut self.rates;
        evaluate(chain, &self.end, inputs, &mut self.statistics, first)?;
        if !has_finite_entries(first) {
            return Err(Error::NotFinite);
        }
        if self.control.step == zero {
            self.control.step = self.guess_first_step(chain, inputs, backwards);
        }
        Ok(())
    }

    /// A first step whose error should be about a hundredth of the tolerance, from one step of
    /// Euler's method (Hairer, Nørsett and Wanner, section II.4).
    fn guess_first_step(
        &mut self,
        chain: &C,
        inputs: &mut impl FnMut(C::Scalar, &C::State) -> C::Inputs,
        backwards: bool,
    ) -> Real<C> {
        let (small, hundredth) = (Real::<C>::constant(1e-5), Real::<C>::constant(0.01));
        let (relative, absolute) =
            (C::Scalar::splat(self.relative), C::Scalar::splat(self.absolute));
        let size =
            |value: &C::State, start: &C::State| norm(value, (start, start), relative, absolute);
        let [first, second, ..] = &mut self.rates;

        let (state, rate) = (size(&self.start, &self.start), size(first, &self.start));
        let known = state > small && rate > small && state.finite() && rate.finite();
        let step = if known { hundredth * state * rate.recip() } else { Real::<C>::constant(1e-6) };
        let signed = C::Scalar::splat(if backwards { -step } else { step });
        add_scaled(&mut self.end, signed, first);
        self.end.set_time(self.start.time() + signed);
        if evaluate(chain, &self.end, inputs, &mut self.statistics, second).is_err() {
            return step;
        }
        add_scaled(second, C::Scalar::constant(-1.0), first);
        let change = size(second, &self.start) * step.recip();
        let fastest = if change > rate { change } else { rate };
        // 13/64 stands for 1/5.
        let by_change = power(hundredth * fastest.recip(), 26);
        let longest = Real::<C>::constant(100.0) * step;
        match (by_change > Real::<C>::default(), by_change < longest) {
            (true, true) => by_change,
            (true, false) => longest,
            // Too fast to be measured; NaN comes here too.
            (false, _) => step,
        }
    }

    /// Tries steps until one is accepted, none of them past `limit`.
    fn take(
        &mut self,
        chain: &C,
        inputs: &mut impl FnMut(C::Scalar, &C::State) -> C::Inputs,
        limit: Option<Real<C>>,
    ) -> Result<(), Error> {
        let start = self.start.time().worst();
        self.taken = false;
        loop {
            let end = end_of_step(start, self.control.proposal(start), limit);
            if end == start {
                return Err(Error::StepTooSmall);
            }
            let size = (end - start).abs();
            let outcome = self.attempt(chain, inputs, end);
            if let Ok(error) = outcome
                && error <= Real::<C>::constant(1.0)
            {
                self.control.accept(size, error);
                self.statistics.accepted = self.statistics.accepted.saturating_add(1);
                self.taken = true;
                return Ok(());
            }
            self.statistics.rejected = self.statistics.rejected.saturating_add(1);
            let error = outcome.unwrap_or(Real::<C>::constant(f64::INFINITY));
            self.control.reject(start, size, error).map_err(|too_small| match outcome {
                Ok(_) | Err(Error::NotFinite) => too_small,
                Err(other) => other,
            })?;
        }
    }

    /// One step from `start` to the time `end`: the stages, the result in `self.end`, and the error
    /// in units of tolerance.
    fn attempt(
        &mut self,
        chain: &C,
        inputs: &mut impl FnMut(C::Scalar, &C::State) -> C::Inputs,
        end: Real<C>,
    ) -> Result<Real<C>, Error> {
        let [k1, k2, k3, k4, k5, k6, k7] = &mut self.rates;
        let step = C::Scalar::splat(end - self.start.time().worst());
        let end = C::Scalar::splat(end);
        let time = self.start.time();
        let [c2, c3, c4, c5] = ABSCISSAE.map(|c| time + step * C::Scalar::constant(c));
        let state = &mut self.end;
        let count = &mut self.statistics;

        lead_to(state, &self.start, step, c2, A2, [k1]);
        evaluate(chain, state, inputs, count, k2)?;
        lead_to(state, &self.start, step, c3, A3, [k1, k2]);
        evaluate(chain, state, inputs, count, k3)?;
        lead_to(state, &self.start, step, c4, A4, [k1, k2, k3]);
        evaluate(chain, state, inputs, count, k4)?;
        lead_to(state, &self.start, step, c5, A5, [k1, k2, k3, k4]);
        evaluate(chain, state, inputs, count, k5)?;
        lead_to(state, &self.start, step, end, A6, [k1, k2, k3, k4, k5]);
        evaluate(chain, state, inputs, count, k6)?;
        lead_to(state, &self.start, step, end, B, [k1, k3, k4, k5, k6]);
        // Before the last evaluation and not after it: so it is that of the state the next step
        // starts from. The estimate moves by as little as the state does, which is of higher order.
        chain.normalize(state);
        let time = state.time();
        chain.close(state, |state| inputs(time, state));
        evaluate(chain, state, inputs, count, k7)?;
        if !is_finite(state) {
            return Err(Error::NotFinite);
        }
        weighted_sum(k2, E.map(|e| step * C::Scalar::constant(e)), [k1, k3, k4, k5, k6, k7]);
        let (relative, absolute) =
            (C::Scalar::splat(self.relative), C::Scalar::splat(self.absolute));
        Ok(norm(k2, (&self.start, state), relative, absolute))
    }
}

/// Where a step of this size from `start` ends: on `limit` if that is near, and not so short of it
/// that a sliver is left.
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

/// The rate at `state`, counted.
fn evaluate<C: Chain>(
    chain: &C,
    state: &C::State,
    inputs: &mut impl FnMut(C::Scalar, &C::State) -> C::Inputs,
    statistics: &mut Statistics,
    rate: &mut C::State,
) -> Result<(), Error> {
    statistics.evaluations = statistics.evaluations.saturating_add(1);
    let acting = ask(chain, inputs, state.time(), state)?;
    chain.derivative_into(state, &acting, rate)
}
