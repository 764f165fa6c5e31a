//! Numbers of twice the precision of `f64`: the unevaluated sum of two. Relative error about
//! 1e-31 an operation, by the exact sum and product of two floats (Dekker 1971, Knuth).

use mstmm::Scalar;
use std::cmp::Ordering;
use std::ops::{Add, AddAssign, Mul, MulAssign, Neg, Sub, SubAssign};

/// `high + low`, with `low` at most half a unit in the last place of `high`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DoubleDouble {
    pub high: f64,
    low: f64,
}

fn exact_sum(a: f64, b: f64) -> DoubleDouble {
    let high = a + b;
    let part = high - a;
    DoubleDouble { high, low: (a - (high - part)) + (b - part) }
}

fn exact_product(a: f64, b: f64) -> DoubleDouble {
    let high = a * b;
    DoubleDouble { high, low: a.mul_add(b, -high) }
}

impl DoubleDouble {
    fn sine_and_cosine(self) -> (Self, Self) {
        // Taylor series of the angle over 64, then the double-angle formulas six times.
        let small = self * Self::constant(1.0 / 64.0);
        let square = small * small;
        let (mut sine, mut versine) = (Self::default(), Self::default());
        let (mut odd, mut even) = (small, square * Self::constant(0.5));
        for k in 0..14 {
            (sine, versine) = (sine + odd, versine + even);
            let next =
                |term: Self, a: f64| -(term * square * Self::constant(a * (a + 1.0)).recip());
            (odd, even) = (next(odd, 2.0 * k as f64 + 2.0), next(even, 2.0 * k as f64 + 3.0));
        }
        // 1 − cos rather than cos keeps all digits of small angles.
        let (one, two) = (Self::constant(1.0), Self::constant(2.0));
        for _ in 0..6 {
            (sine, versine) = (sine * (one - versine) * two, sine * sine * two);
        }
        (sine, one - versine)
    }
}

impl Add for DoubleDouble {
    type Output = Self;
    // Kept out of line: generated code has some thousand of them.
    #[inline(never)]
    fn add(self, other: Self) -> Self {
        let (high, low) = (exact_sum(self.high, other.high), exact_sum(self.low, other.low));
        let first = exact_sum(high.high, high.low + low.high);
        exact_sum(first.high, first.low + low.low)
    }
}

impl Neg for DoubleDouble {
    type Output = Self;
    fn neg(self) -> Self {
        DoubleDouble { high: -self.high, low: -self.low }
    }
}

impl Sub for DoubleDouble {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for DoubleDouble {
    type Output = Self;
    #[inline(never)]
    fn mul(self, other: Self) -> Self {
        let product = exact_product(self.high, other.high);
        let cross = self.high * other.low + self.low * other.high;
        exact_sum(product.high, product.low + cross)
    }
}

impl AddAssign for DoubleDouble {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl SubAssign for DoubleDouble {
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

impl MulAssign for DoubleDouble {
    fn mul_assign(&mut self, other: Self) {
        *self = *self * other;
    }
}

impl PartialOrd for DoubleDouble {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        (*self - *other).high.partial_cmp(&0.0)
    }
}

impl Scalar for DoubleDouble {
    type Mask = bool;
    type Real = Self;

    fn constant(value: f64) -> Self {
        DoubleDouble { high: value, low: 0.0 }
    }

    fn epsilon() -> Self {
        Self::constant(f64::EPSILON * f64::EPSILON)
    }

    /// Two Newton steps double the digits of the `f64` quotient twice.
    fn recip(self) -> Self {
        let two = Self::constant(2.0);
        let start = Self::constant(1.0 / self.high);
        let better = start * (two - self * start);
        better * (two - self * better)
    }

    fn sqrt(self) -> Self {
        if self.high == 0.0 {
            return self;
        }
        let step = |root: Self| (root + self * root.recip()) * Self::constant(0.5);
        step(step(Self::constant(self.high.sqrt())))
    }

    fn copysign(self, sign: Self) -> Self {
        let same = self.high.is_sign_negative() == sign.high.is_sign_negative();
        if same { self } else { -self }
    }

    fn abs(self) -> Self {
        self.copysign(Self::constant(1.0))
    }

    fn sin_cos<const N: usize>(angles: [Self; N]) -> ([Self; N], [Self; N]) {
        let both = angles.map(Self::sine_and_cosine);
        (both.map(|(sine, _)| sine), both.map(|(_, cosine)| cosine))
    }

    /// One Newton step, `θ + (y cos θ − x sin θ) / r`, doubles the digits of the `f64` angle.
    fn atan2(self, x: Self) -> Self {
        let angle = Self::constant(self.high.atan2(x.high));
        let (sine, cosine) = angle.sine_and_cosine();
        angle + (self * cosine - x * sine) * (self * self + x * x).sqrt().recip()
    }

    fn greater(self, other: Self) -> bool {
        self > other
    }

    fn finite(self) -> bool {
        self.high.is_finite() && self.low.is_finite()
    }

    fn select(mask: bool, yes: Self, no: Self) -> Self {
        if mask { yes } else { no }
    }

    fn worst(self) -> Self {
        self
    }

    fn splat(value: Self) -> Self {
        value
    }
}

#[test]
fn identities_hold_to_thirty_digits() {
    for angle in [0.1, 1.0, -2.5, 3.1, 1e-9] {
        let number = DoubleDouble::constant;
        let ([sine], [cosine]) = Scalar::sin_cos([number(angle)]);
        let one = sine * sine + cosine * cosine - number(1.0);
        assert!(one.high.abs() < 1e-29, "{one:?}");
        assert!((sine.high - angle.sin()).abs() <= 1.2e-16 * angle.abs().max(1.0));
        let root = number(angle.abs() + 0.3).sqrt();
        assert!((root * root - number(angle.abs() + 0.3)).high.abs() < 1e-30);
        let back = sine.atan2(cosine) - number(angle);
        assert!(back.high.abs() < 1e-29, "{back:?}");
        assert!((root * root.recip() - number(1.0)).high.abs() < 1e-30);
        assert!(number(angle).greater(number(angle) - DoubleDouble::epsilon()));
    }
}
