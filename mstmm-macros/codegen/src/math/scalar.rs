//! The scalars that the equations are generic over.

use super::RANK_ULPS;
use std::ops::{Add, Mul, Neg, Sub};

/// A number or a formula. Scalars have no ordering: equations cannot branch on values.
pub trait Scalar:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Neg<Output = Self>
    + std::fmt::Debug
{
    /// A known value.
    fn number(value: f64) -> Self;
    /// `1 / self`
    fn recip(self) -> Self;
    /// `√self`
    fn sqrt(self) -> Self;
    /// Sine and cosine of an angle in rad.
    fn sin_cos(self) -> (Self, Self);
    /// The magnitude of `self` with the sign of `sign`.
    fn copysign(self, sign: Self) -> Self;
    /// The angle in rad of the point with the ordinate `self` and the abscissa `x`.
    fn atan2(self, x: Self) -> Self;
    /// `1 / self` if `self` exceeds the rounding error of `scale`, zero otherwise.
    fn recip_above(self, scale: Self) -> Self;
    /// Whether the value is zero in every state of the chain. It is false for every plain number,
    /// since the structure of a computation must not depend on values.
    fn vanishes(self) -> bool;

    /// Zero.
    fn zero() -> Self {
        Self::number(0.0)
    }

    /// One.
    fn one() -> Self {
        Self::number(1.0)
    }

    /// The magnitude.
    fn abs(self) -> Self {
        self.copysign(Self::one())
    }

    /// `√(self + 10⁻³⁰)`: the length of a vector from its square, such that one can divide by it. Above 10⁻⁷ it is the length, to
    /// rounding.
    fn divisible_root(self) -> Self {
        (self + Self::number(1e-30)).sqrt()
    }

    /// `self` if it is positive, zero otherwise.
    fn positive_part(self) -> Self {
        (self + Scalar::abs(self)) * Self::number(0.5)
    }

    /// One if `self` is positive or zero, zero otherwise.
    fn is_positive(self) -> Self {
        self.sides().1
    }

    /// One and zero if `self` is negative, zero and one otherwise.
    fn sides(self) -> (Self, Self) {
        let half = Self::number(0.5);
        let side = Scalar::copysign(half, self);
        (half - side, half + side)
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
            fn atan2(self, x: Self) -> Self {
                <$float>::atan2(self, x)
            }
            fn recip_above(self, scale: Self) -> Self {
                let vanishes = self <= RANK_ULPS as $float * <$float>::EPSILON * scale;
                if vanishes { 0.0 } else { <$float>::recip(self) }
            }
            fn vanishes(self) -> bool {
                false
            }
        }
    )* };
}

plain_number!(f32, f64);
