//! Numbers of twice the precision of `f64`: the unevaluated sum of two. Relative error about
//! 1e-31 an operation, by the exact sum and product of two floats (Dekker 1971, Knuth).

use mstmm_codegen::math::Scalar;
use std::ops::{Add, Mul, Neg, Sub};

/// `high + low`, with `low` at most half a unit in the last place of `high`.
#[derive(Clone, Copy, Debug)]
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

impl Add for DoubleDouble {
    type Output = Self;
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
    fn mul(self, other: Self) -> Self {
        let product = exact_product(self.high, other.high);
        let cross = self.high * other.low + self.low * other.high;
        exact_sum(product.high, product.low + cross)
    }
}

impl Scalar for DoubleDouble {
    fn number(value: f64) -> Self {
        DoubleDouble { high: value, low: 0.0 }
    }

    /// Two Newton steps double the digits of the `f64` quotient twice.
    fn recip(self) -> Self {
        let two = Self::number(2.0);
        let start = Self::number(1.0 / self.high);
        let better = start * (two - self * start);
        better * (two - self * better)
    }

    fn sqrt(self) -> Self {
        if self.high == 0.0 {
            return self;
        }
        let half = Self::number(0.5);
        let step = |root: Self| (root + self * root.recip()) * half;
        step(step(Self::number(self.high.sqrt())))
    }

    /// Taylor series of the angle over 64, then the double-angle formulas six times.
    fn sin_cos(self) -> (Self, Self) {
        let small = self * Self::number(1.0 / 64.0);
        let square = small * small;
        let (mut sin, mut versine) = (Self::number(0.0), Self::number(0.0));
        let (mut odd, mut even) = (small, square * Self::number(0.5));
        for k in 0..14 {
            (sin, versine) = (sin + odd, versine + even);
            let next = |term: Self, a: f64| -(term * square * Self::number(a * (a + 1.0)).recip());
            (odd, even) = (next(odd, 2.0 * k as f64 + 2.0), next(even, 2.0 * k as f64 + 3.0));
        }
        // 1 − cos rather than cos keeps all digits of small angles.
        for _ in 0..6 {
            let cos = Self::number(1.0) - versine;
            (sin, versine) = (sin * cos * Self::number(2.0), (sin * sin) * Self::number(2.0));
        }
        (sin, Self::number(1.0) - versine)
    }

    fn copysign(self, sign: Self) -> Self {
        if (self.high < 0.0) == sign.high.is_sign_negative() { self } else { -self }
    }

    /// One Newton step, `θ + (y cos θ − x sin θ) / r`, doubles the digits of the `f64` angle.
    fn atan2(self, x: Self) -> Self {
        let angle = Self::number(self.high.atan2(x.high));
        let (sin, cos) = angle.sin_cos();
        angle + (self * cos - x * sin) * (self * self + x * x).sqrt().recip()
    }

    fn recip_above(self, scale: Self) -> Self {
        let vanishes = self.high <= 1e-24 * scale.high;
        if vanishes { Self::number(0.0) } else { self.recip() }
    }

    fn vanishes(self) -> bool {
        false
    }
}

#[test]
fn identities_hold_to_thirty_digits() {
    for angle in [0.1, 1.0, -2.5, 3.1, 1e-9] {
        let (sin, cos) = DoubleDouble::number(angle).sin_cos();
        let one = sin * sin + cos * cos - DoubleDouble::number(1.0);
        assert!(one.high.abs() < 1e-29, "{one:?}");
        assert!((sin.high - angle.sin()).abs() <= 1.2e-16 * angle.abs().max(1.0));
        let root = DoubleDouble::number(angle.abs() + 0.3).sqrt();
        let back = root * root - DoubleDouble::number(angle.abs() + 0.3);
        assert!(back.high.abs() < 1e-30);
        let back = sin.atan2(cos) - DoubleDouble::number(angle);
        assert!(back.high.abs() < 1e-29, "{back:?}");
        let unit = root * root.recip() - DoubleDouble::number(1.0);
        assert!(unit.high.abs() < 1e-30);
    }
}
