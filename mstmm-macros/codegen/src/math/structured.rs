//! Plain numbers with the compiler's knowledge of constants.

use super::Scalar;
use std::ops::{Add, Mul, Neg, Sub};

/// A plain number that may be known while compiling. Known zeros and ones fold as in formulas, so
/// the equations take the same branches with plain numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Structured<S> {
    value: S,
    known: Option<f64>,
}

impl<S: Scalar> Structured<S> {
    /// A value that depends on the state.
    pub fn variable(value: S) -> Self {
        Structured { value, known: None }
    }

    /// Returns the plain number.
    pub fn value(self) -> S {
        self.value
    }

    fn of(value: S, known: Option<f64>) -> Self {
        Structured { value, known }
    }

    fn unary(self, value: S, known: impl Fn(f64) -> f64) -> Self {
        Structured::of(value, self.known.map(known))
    }

    fn both(self, other: Self, fold: impl Fn(f64, f64) -> f64) -> Option<f64> {
        self.known.zip(other.known).map(|(a, b)| fold(a, b))
    }
}

impl<S: Scalar> Neg for Structured<S> {
    type Output = Self;
    fn neg(self) -> Self {
        self.unary(-self.value, |x| -x)
    }
}

impl<S: Scalar> Add for Structured<S> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        match (self.vanishes(), other.vanishes()) {
            (true, _) => other,
            (_, true) => self,
            _ => Structured::of(self.value + other.value, self.both(other, |a, b| a + b)),
        }
    }
}

impl<S: Scalar> Sub for Structured<S> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<S: Scalar> Mul for Structured<S> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        if self.vanishes() || other.vanishes() {
            return Structured::number(0.0);
        }
        Structured::of(self.value * other.value, self.both(other, |a, b| a * b))
    }
}

impl<S: Scalar> Scalar for Structured<S> {
    fn number(value: f64) -> Self {
        Structured::of(S::number(value), Some(value))
    }
    fn recip(self) -> Self {
        self.unary(self.value.recip(), f64::recip)
    }
    fn sqrt(self) -> Self {
        self.unary(self.value.sqrt(), f64::sqrt)
    }
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.value.sin_cos();
        (self.unary(sin, f64::sin), self.unary(cos, f64::cos))
    }
    fn copysign(self, sign: Self) -> Self {
        Structured::of(self.value.copysign(sign.value), self.both(sign, f64::copysign))
    }
    fn atan2(self, x: Self) -> Self {
        Structured::of(self.value.atan2(x.value), self.both(x, f64::atan2))
    }
    fn recip_above(self, scale: Self) -> Self {
        let known = self.both(scale, Scalar::recip_above);
        Structured::of(self.value.recip_above(scale.value), known)
    }
    fn vanishes(self) -> bool {
        self.known == Some(0.0)
    }
}
