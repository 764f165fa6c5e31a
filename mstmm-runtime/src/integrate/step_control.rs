//! Step size control: proportional-integral control (Gustafsson 1991) in the form of Hairer and Wanner, *Solving Ordinary Differential Equations II*, section IV.2.

use super::combine::entries;
use crate::{ChainState, Error, Scalar};

/// The largest number of attempts at one step; the last is 0.2⁶⁴ of the first.
const MAX_ATTEMPTS: u32 = 64;

/// With steps of this part of the time left, 10¹⁸ of them, no integration ends: 2⁻⁶⁰.
pub(super) const LEAST_PART: f64 = 8.67e-19;

/// The exponent of the error, in units of 1/128: 22/128 = 11/64. Control of order five requires 1/5 − ¾ of the exponent
/// of the previous error, 0.171. Powers with dyadic fractions are products of square roots, whose bits are the same on
/// every target.
const ERROR_EXPONENT: u32 = 22;

/// The exponent of the previous error, in units of 1/128.
const MEMORY_EXPONENT: u32 = 5;

/// The step size, as a magnitude in s, and the memory of the control.
#[derive(Clone, Copy)]
pub(super) struct StepControl<R> {
    /// The next step size; zero if it is not known yet.
    pub(super) step: R,
    pub(super) minimum: R,
    pub(super) maximum: R,
    previous_error: R,
    /// The number of rejected attempts at the present step.
    failures: u32,
}

impl<R: Scalar<Real = R, Mask = bool> + PartialOrd> StepControl<R> {
    pub(super) fn new() -> Self {
        let maximum = R::constant(f64::INFINITY);
        Self {
            step: R::default(),
            minimum: R::default(),
            maximum,
            previous_error: R::constant(1e-4),
            failures: 0,
        }
    }

    /// Returns the step size to attempt, within the limits.
    pub(super) fn proposal(&self, shortest: R) -> R {
        clamp(self.step, shortest, self.maximum)
    }

    /// Returns whether the limits are numbers, the maximum is positive, and the minimum is at most the maximum.
    pub(super) fn has_limits(&self) -> bool {
        self.minimum <= self.maximum && self.maximum > R::default()
    }

    /// Sets the next step size after an accepted step of size `step`, which may differ from the proposed one.
    pub(super) fn accept(&mut self, step: R, error: R) {
        let most = R::constant(if self.failures > 0 { 1.0 } else { 5.0 });
        let memory = power(self.previous_error, MEMORY_EXPONENT);
        let factor = R::constant(0.9) * memory * power(error, ERROR_EXPONENT).recip();
        let next = step * clamp(factor, R::constant(0.2), most);
        // A step that was shortened to end at the limit is no reason to reduce the proposed step size.
        let cut_short = self.failures == 0 && step < self.step;
        let next = if cut_short && next < self.step { self.step } else { next };
        self.step = clamp(next, R::default(), self.maximum);
        self.previous_error = clamp(error, R::constant(1e-4), R::constant(1.0));
        self.failures = 0;
    }

    /// Sets a shorter step size after a rejected step of size `step`.
    ///
    /// The error may be infinite or NaN.
    ///
    /// # Errors
    /// [`Error::StepTooSmall`] if `step` was the shortest step, or after too many attempts.
    pub(super) fn reject(&mut self, shortest: R, step: R, error: R) -> Result<(), Error> {
        self.failures += 1;
        if step <= shortest || self.failures >= MAX_ATTEMPTS {
            self.failures = 0;
            self.step = R::default();
            return Err(Error::StepTooSmall);
        }
        let factor = R::constant(0.9) * power(error, ERROR_EXPONENT).recip();
        self.step =
            clamp(step * clamp(factor, R::constant(0.2), R::constant(0.9)), shortest, self.maximum);
        Ok(())
    }

    /// Returns the shortest step size to attempt: the user's minimum, a few units in the last place of the time, or the part
    /// [`LEAST_PART`] of the time `left` to the end, so that a run-away state near time zero ends in an error.
    pub(super) fn shortest(&self, time: R, left: R) -> R {
        let tick = R::constant(4.0) * R::epsilon() * time.abs();
        let never = R::constant(LEAST_PART) * left.abs();
        let least = if tick > never { tick } else { never };
        if self.minimum > least { self.minimum } else { least }
    }
}

/// Returns `value` limited to `low` and `high`, or `low` for NaN.
fn clamp<R: PartialOrd>(value: R, low: R, high: R) -> R {
    if value >= high {
        high
    } else if value > low {
        value
    } else {
        low
    }
}

/// Returns `base` to the power of `exponent`/128 as a product of repeated square roots, for exponents below 128.
pub(super) fn power<R: Scalar>(base: R, exponent: u32) -> R {
    let (mut root, mut product) = (base, R::constant(1.0));
    for bit in [64, 32, 16, 8, 4, 2, 1] {
        root = root.sqrt();
        if exponent & bit != 0 {
            product *= root;
        }
    }
    product
}

/// Returns the root mean square of the entries of `value`, each in units of absolute + relative · max(|a|, |b|), for the
/// lane in which it is largest. An entry that is zero meets every tolerance, also zero.
pub(super) fn norm<S: ChainState>(
    value: &S,
    (a, b): (&S, &S),
    relative: S::Scalar,
    absolute: S::Scalar,
) -> <S::Scalar as Scalar>::Real {
    let (zero, one) = (S::Scalar::constant(0.0), S::Scalar::constant(1.0));
    let (mut total, mut count) = (S::Scalar::default(), S::Scalar::default());
    for ((value, a), b) in entries(value).zip(entries(a)).zip(entries(b)) {
        let size = S::Scalar::select(a.abs().simd_gt(b.abs()), a.abs(), b.abs());
        let measured = value * (absolute + relative * size).recip();
        let is_zero = !value.abs().simd_gt(zero) & value.is_finite();
        let measured = S::Scalar::select(is_zero, zero, measured);
        total += measured * measured;
        count += one;
    }
    // A chain without coordinates has no error.
    let count = S::Scalar::select(count.simd_gt(one), count, one);
    (total * count.recip()).max_lane().sqrt()
}

#[cfg(test)]
mod tests {
    use super::power;

    #[test]
    fn powers_are_dyadic() {
        for exponent in 0..128 {
            let expected = f64::from(exponent).mul_add(3.7f64.ln() / 128.0, 0.0).exp();
            assert!((power(3.7, exponent) / expected - 1.0).abs() < 1e-14);
        }
    }
}
