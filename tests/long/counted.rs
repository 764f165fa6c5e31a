//! Numbers that count the operations on them.

use mstmm::Scalar;
use std::cell::Cell;
use std::ops::{Add, AddAssign, Mul, MulAssign, Neg, Sub, SubAssign};

thread_local! {
    static COUNT: Cell<u64> = const { Cell::new(0) };
}

/// Returns the number of operations of a function, on this thread.
pub fn operations(of: impl FnOnce()) -> u64 {
    let before = COUNT.get();
    of();
    COUNT.get() - before
}

/// A number that counts additions, multiplications, reciprocals, roots, sines with cosines and
/// arctangents. Signs, comparisons and copies are not counted.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub struct Counted(f64);

fn counted(value: f64) -> Counted {
    COUNT.set(COUNT.get() + 1);
    Counted(value)
}

impl Add for Counted {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        counted(self.0 + other.0)
    }
}

impl Sub for Counted {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        counted(self.0 - other.0)
    }
}

impl Mul for Counted {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        counted(self.0 * other.0)
    }
}

impl Neg for Counted {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl AddAssign for Counted {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl SubAssign for Counted {
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

impl MulAssign for Counted {
    fn mul_assign(&mut self, other: Self) {
        *self = *self * other;
    }
}

impl Scalar for Counted {
    type Mask = bool;
    type Real = Self;
    type Columns = Self;
    type Pack = Self;

    fn constant(value: f64) -> Self {
        Self(value)
    }

    fn epsilon() -> Self {
        Self(f64::EPSILON)
    }

    fn recip(self) -> Self {
        counted(1.0 / self.0)
    }

    fn sqrt(self) -> Self {
        counted(self.0.sqrt())
    }

    fn copysign(self, sign: Self) -> Self {
        Self(self.0.copysign(sign.0))
    }

    fn abs(self) -> Self {
        Self(self.0.abs())
    }

    fn sin_cos<const N: usize>(angles: [Self; N]) -> ([Self; N], [Self; N]) {
        let (sines, cosines) = <f64 as Scalar>::sin_cos(angles.map(|angle| angle.0));
        (sines.map(counted), cosines.map(Self))
    }

    fn atan2(self, x: Self) -> Self {
        counted(self.0.atan2(x.0))
    }

    fn simd_gt(self, other: Self) -> bool {
        self > other
    }

    fn is_finite(self) -> bool {
        self.0.is_finite()
    }

    fn select(mask: bool, yes: Self, no: Self) -> Self {
        if mask { yes } else { no }
    }

    fn max_lane(self) -> Self {
        self
    }

    fn splat(value: Self) -> Self {
        value
    }
}
