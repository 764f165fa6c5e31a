//! Dual numbers: values with their derivative along one direction.

use super::Scalar;
use std::ops::{Add, Mul, Neg, Sub};

/// A value and its derivative.
#[derive(Clone, Copy, Debug)]
pub struct Dual<S> {
    value: S,
    derivative: S,
}

impl<S: Scalar> Dual<S> {
    /// Returns a dual number.
    pub fn new(value: S, derivative: S) -> Self {
        Dual { value, derivative }
    }

    /// Returns the value.
    pub fn value(self) -> S {
        self.value
    }

    /// Returns the derivative.
    pub fn derivative(self) -> S {
        self.derivative
    }
}

impl<S: Scalar> Neg for Dual<S> {
    type Output = Self;
    fn neg(self) -> Self {
        Dual::new(-self.value, -self.derivative)
    }
}

impl<S: Scalar> Add for Dual<S> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Dual::new(self.value + other.value, self.derivative + other.derivative)
    }
}

impl<S: Scalar> Sub for Dual<S> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<S: Scalar> Mul for Dual<S> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let derivative = self.derivative * other.value + self.value * other.derivative;
        Dual::new(self.value * other.value, derivative)
    }
}

impl<S: Scalar> Scalar for Dual<S> {
    fn number(value: f64) -> Self {
        Dual::new(S::number(value), S::zero())
    }
    fn recip(self) -> Self {
        let value = self.value.recip();
        Dual::new(value, -(value * value * self.derivative))
    }
    fn sqrt(self) -> Self {
        let value = self.value.sqrt();
        Dual::new(value, self.derivative * S::number(0.5) * value.recip())
    }
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.value.sin_cos();
        (Dual::new(sin, cos * self.derivative), Dual::new(cos, -(sin * self.derivative)))
    }
    fn copysign(self, sign: Self) -> Self {
        let flip = S::one().copysign(self.value) * S::one().copysign(sign.value);
        Dual::new(self.value.copysign(sign.value), self.derivative * flip)
    }
    fn atan2(self, x: Self) -> Self {
        let square = (self.value * self.value + x.value * x.value).recip();
        let derivative = (x.value * self.derivative - self.value * x.derivative) * square;
        Dual::new(self.value.atan2(x.value), derivative)
    }
    fn recip_above(self, scale: Self) -> Self {
        let value = self.value.recip_above(scale.value);
        Dual::new(value, -(value * value * self.derivative))
    }
    fn vanishes(self) -> bool {
        self.value.vanishes() && self.derivative.vanishes()
    }
}
