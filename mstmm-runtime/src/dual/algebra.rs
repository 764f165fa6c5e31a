//! What vectors and matrices of `nalgebra` and formulas of users need of dual numbers beyond [`Scalar`]: zero and one,
//! quotients, operations with numbers, sines and cosines.

use core::ops::{Add, Div, DivAssign, Mul, Sub};

use num_traits::{One, Zero};

use super::Dual;
use crate::Scalar;

impl<T: Scalar + Zero, const K: usize> Zero for Dual<T, K> {
    #[inline]
    fn zero() -> Self {
        Self::from(T::zero())
    }

    #[inline]
    fn is_zero(&self) -> bool {
        self.value.is_zero() && self.derivatives.iter().all(T::is_zero)
    }
}

impl<T: Scalar + One, const K: usize> One for Dual<T, K> {
    #[inline]
    fn one() -> Self {
        Self::from(T::one())
    }
}

/// (a/b)' = (a' − (a/b) b')/b.
impl<T: Scalar + Div<Output = T>, const K: usize> Div for Dual<T, K> {
    type Output = Self;

    #[inline]
    fn div(self, other: Self) -> Self {
        let (value, divisor) = (self.value / other.value, other.value);
        Self::joined(value, self, other, |a, b| value.mul_neg_add(b, a) / divisor)
    }
}

impl<T: Scalar + Div<Output = T>, const K: usize> DivAssign for Dual<T, K> {
    #[inline]
    fn div_assign(&mut self, other: Self) {
        *self = *self / other;
    }
}

impl<T: Scalar, const K: usize> Add<T> for Dual<T, K> {
    type Output = Self;

    #[inline]
    fn add(self, number: T) -> Self {
        Self { value: self.value + number, ..self }
    }
}

impl<T: Scalar, const K: usize> Sub<T> for Dual<T, K> {
    type Output = Self;

    #[inline]
    fn sub(self, number: T) -> Self {
        Self { value: self.value - number, ..self }
    }
}

impl<T: Scalar, const K: usize> Mul<T> for Dual<T, K> {
    type Output = Self;

    #[inline]
    fn mul(self, number: T) -> Self {
        self.chained(self.value * number, number)
    }
}

impl<T: Scalar + Div<Output = T>, const K: usize> Div<T> for Dual<T, K> {
    type Output = Self;

    #[inline]
    fn div(self, number: T) -> Self {
        let derivatives = self.derivatives.map(|derivative| derivative / number);
        Self { value: self.value / number, derivatives }
    }
}

/// Implements the operations of a number and a dual number.
macro_rules! numbers {
    ($($number:ty)*) => { $(
        impl<const K: usize> Add<Dual<$number, K>> for $number {
            type Output = Dual<$number, K>;

            #[inline]
            fn add(self, other: Dual<$number, K>) -> Self::Output {
                other + self
            }
        }

        impl<const K: usize> Sub<Dual<$number, K>> for $number {
            type Output = Dual<$number, K>;

            #[inline]
            fn sub(self, other: Dual<$number, K>) -> Self::Output {
                Dual::from(self) - other
            }
        }

        impl<const K: usize> Mul<Dual<$number, K>> for $number {
            type Output = Dual<$number, K>;

            #[inline]
            fn mul(self, other: Dual<$number, K>) -> Self::Output {
                other * self
            }
        }

        impl<const K: usize> Div<Dual<$number, K>> for $number {
            type Output = Dual<$number, K>;

            #[inline]
            fn div(self, other: Dual<$number, K>) -> Self::Output {
                Dual::from(self) / other
            }
        }
    )* };
}

numbers!(f64 f32);

impl<T: Scalar, const K: usize> Dual<T, K> {
    /// Returns the sine of an angle in rad.
    #[inline]
    #[must_use]
    pub fn sin(self) -> Self {
        let ([sine], _) = <Self as Scalar>::sin_cos([self]);
        sine
    }

    /// Returns the cosine of an angle in rad.
    #[inline]
    #[must_use]
    pub fn cos(self) -> Self {
        let (_, [cosine]) = <Self as Scalar>::sin_cos([self]);
        cosine
    }
}
