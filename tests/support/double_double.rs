//! Numbers of twice the precision of `f64`: the unevaluated sum of two. Relative error about
//! 1e-31 an operation, by the exact sum and product of two floats (Dekker 1971, Knuth).
//!
//! The compiler and the generated code have a trait of scalars each. Their tests include this file and
//! implement the trait.
#![allow(dead_code)] // No test calls all of it.

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
    /// The relative error of an operation.
    pub const EPSILON: Self = Self::new(f64::EPSILON * f64::EPSILON);

    pub const fn new(high: f64) -> Self {
        DoubleDouble { high, low: 0.0 }
    }

    /// Two Newton steps double the digits of the `f64` quotient twice.
    pub fn recip(self) -> Self {
        let two = Self::new(2.0);
        let start = Self::new(1.0 / self.high);
        let better = start * (two - self * start);
        better * (two - self * better)
    }

    pub fn sqrt(self) -> Self {
        if self.high == 0.0 {
            return self;
        }
        let step = |root: Self| (root + self * root.recip()) * Self::new(0.5);
        step(step(Self::new(self.high.sqrt())))
    }

    pub fn sin_cos(self) -> (Self, Self) {
        // Taylor series of the angle over 64, then the double-angle formulas six times.
        let small = self * Self::new(1.0 / 64.0);
        let square = small * small;
        let (mut sine, mut versine) = (Self::new(0.0), Self::new(0.0));
        let (mut odd, mut even) = (small, square * Self::new(0.5));
        for k in 0..14 {
            (sine, versine) = (sine + odd, versine + even);
            let next = |term: Self, a: f64| -(term * square * Self::new(a * (a + 1.0)).recip());
            (odd, even) = (next(odd, 2.0 * k as f64 + 2.0), next(even, 2.0 * k as f64 + 3.0));
        }
        // 1 − cos rather than cos keeps all digits of small angles.
        let (one, two) = (Self::new(1.0), Self::new(2.0));
        for _ in 0..6 {
            (sine, versine) = (sine * (one - versine) * two, sine * sine * two);
        }
        (sine, one - versine)
    }

    /// One Newton step, `θ + (y cos θ − x sin θ) / r`, doubles the digits of the `f64` angle.
    pub fn atan2(self, x: Self) -> Self {
        let angle = Self::new(self.high.atan2(x.high));
        let (sine, cosine) = angle.sin_cos();
        angle + (self * cosine - x * sine) * (self * self + x * x).sqrt().recip()
    }

    pub fn copysign(self, sign: Self) -> Self {
        let same = self.high.is_sign_negative() == sign.high.is_sign_negative();
        if same { self } else { -self }
    }

    pub fn is_finite(self) -> bool {
        self.high.is_finite() && self.low.is_finite()
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
