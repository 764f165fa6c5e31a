//! What the equations need of a number.

use std::ops::{Add, Mul, Neg, Sub};

/// A number or a formula. There is no ordering: equations cannot branch on values.
pub trait Scalar:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Neg<Output = Self>
    + std::fmt::Debug
{
    /// A known number.
    fn number(value: f64) -> Self;
    /// `1 / self`
    fn recip(self) -> Self;
    /// `√self`
    fn sqrt(self) -> Self;
    /// Sine and cosine of an angle in rad.
    fn sin_cos(self) -> (Self, Self);
    /// The magnitude of `self` with the sign of `sign`.
    fn copysign(self, sign: Self) -> Self;
    /// Whether it vanishes for every state of the chain. A plain number never says so, however
    /// small it is: the structure of a computation must not depend on values.
    fn vanishes(self) -> bool;

    /// Zero.
    fn zero() -> Self {
        Self::number(0.0)
    }

    /// One.
    fn one() -> Self {
        Self::number(1.0)
    }
}

macro_rules! plain_number {
    ($($float:ty),*) => { $(
        impl Scalar for $float {
            fn number(value: f64) -> Self {
                value as $float
            }
            fn recip(self) -> Self {
                <$float>::recip(self)
            }
            fn sqrt(self) -> Self {
                <$float>::sqrt(self)
            }
            fn sin_cos(self) -> (Self, Self) {
                <$float>::sin_cos(self)
            }
            fn copysign(self, sign: Self) -> Self {
                <$float>::copysign(self, sign)
            }
            fn vanishes(self) -> bool {
                false
            }
        }
    )* };
}

plain_number!(f32, f64);
