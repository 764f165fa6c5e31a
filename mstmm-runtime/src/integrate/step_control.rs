//! How long the next step should be: proportional-integral control (Gustafsson 1991) in the form of
//! Hairer and Wanner, *Solving Ordinary Differential Equations II*, section IV.2.

use super::combine::entries;
use crate::{ChainState, Error, Scalar};

/// Tries at one step before giving up: 0.2⁶⁴ of the first try.
const MOST_ATTEMPTS: u32 = 64;

/// The error exponent, 11/64. Control of order five wants 1/5 − 3/4 of the memory's exponent,
/// 0.171. As dyadic fractions the powers are products of square roots, which are the same bits on
/// every target.
const ERROR_EXPONENT: u32 = 22;

/// The exponent of the error before, 5/128.
const MEMORY_EXPONENT: u32 = 5;

/// The size of steps, as a magnitude in s, and the memory of the control.
#[derive(Clone, Copy)]
pub(super) struct StepControl<R> {
    /// The next step; zero as long as nothing is known.
    pub(super) step: R,
    pub(super) minimum: R,
    pub(super) maximum: R,
    previous_error: R,
    /// Tries at the present step that failed.
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

    /// The step to try from `time`, within the limits.
    pub(super) fn proposal(&self, time: R) -> R {
        clamp(self.step, self.shortest(time), self.maximum)
    }

    /// After an accepted step of size `step`, which need not be the one proposed: sets the next
    /// one.
    pub(super) fn accept(&mut self, step: R, error: R) {
        let most = R::constant(if self.failures > 0 { 1.0 } else { 5.0 });
        let memory = power(self.previous_error, MEMORY_EXPONENT);
        let factor = R::constant(0.9) * memory * power(error, ERROR_EXPONENT).recip();
        let next = step * clamp(factor, R::constant(0.2), most);
        // A step cut short by the end of the interval says nothing against the one that was
        // proposed.
        let cut_short = self.failures == 0 && step < self.step;
        let next = if cut_short && next < self.step { self.step } else { next };
        self.step = clamp(next, R::default(), self.maximum);
        self.previous_error = clamp(error, R::constant(1e-4), R::constant(1.0));
        self.failures = 0;
    }

    /// After a rejected step of size `step` from `time`: sets a shorter one. The error may be
    /// infinite or NaN.
    ///
    /// # Errors
    /// [`Error::StepTooSmall`] if it was the shortest already, or one of too many tries.
    pub(super) fn reject(&mut self, time: R, step: R, error: R) -> Result<(), Error> {
        self.failures += 1;
        let shortest = self.shortest(time);
        if step <= shortest || self.failures >= MOST_ATTEMPTS {
            self.failures = 0;
            self.step = R::default();
            return Err(Error::StepTooSmall);
        }
        let factor = R::constant(0.9) * power(error, ERROR_EXPONENT).recip();
        self.step =
            clamp(step * clamp(factor, R::constant(0.2), R::constant(0.9)), shortest, self.maximum);
        Ok(())
    }

    /// The shortest step worth trying: the user's minimum, or what moves the clock by a few units
    /// in the last place.
    fn shortest(&self, time: R) -> R {
        let tick = R::constant(4.0) * R::epsilon() * time.abs();
        if self.minimum > tick { self.minimum } else { tick }
    }
}

/// `value` between `low` and `high`; `low` for NaN.
fn clamp<R: PartialOrd>(value: R, low: R, high: R) -> R {
    if value >= high {
        high
    } else if value > low {
        value
    } else {
        low
    }
}

/// `base` to the power of `exponent`/128, for exponents below 128: a product of repeated square
/// roots.
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

/// The root mean square of the entries of `value`, each measured by absolute + relative · max(|a|,
/// |b|), in the worst lane.
pub(super) fn norm<S: ChainState>(
    value: &S,
    (a, b): (&S, &S),
    relative: S::Scalar,
    absolute: S::Scalar,
) -> <S::Scalar as Scalar>::Real {
    let one = S::Scalar::constant(1.0);
    let (mut total, mut count) = (S::Scalar::default(), S::Scalar::default());
    for ((value, a), b) in entries(value).zip(entries(a)).zip(entries(b)) {
        let size = S::Scalar::select(a.abs().simd_gt(b.abs()), a.abs(), b.abs());
        let measured = value * (absolute + relative * size).recip();
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
