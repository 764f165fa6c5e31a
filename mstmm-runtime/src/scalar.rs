//! The numbers a chain is computed with.

use core::fmt::Debug;
use core::ops::{Add, AddAssign, BitAnd, BitOr, Mul, MulAssign, Neg, Not, Sub, SubAssign};

/// The answer to a question asked of a [`Scalar`]: one truth value per lane.
///
/// For `f32` and `f64` it is `bool`.
pub trait Mask:
    Copy + Debug + BitAnd<Output = Self> + BitOr<Output = Self> + Not<Output = Self>
{
    /// The same truth value in every lane.
    fn splat(value: bool) -> Self;

    /// Whether every lane is true.
    fn all(self) -> bool;
}

impl Mask for bool {
    #[inline(always)]
    fn splat(value: bool) -> Self {
        value
    }

    #[inline(always)]
    fn all(self) -> bool {
        self
    }
}

/// A number that generated dynamics can be computed with.
///
/// It has arithmetic but no order, so that SIMD lanes and dual numbers fit as well as `f32` and
/// `f64`: what would be a branch on a comparison is a [`select`](Scalar::select) under a [`Mask`].
/// Nothing here is reassociated, and nothing fused without the feature `fma`, so a type's results are
/// the same bits on every target.
pub trait Scalar:
    nalgebra::Scalar
    + Copy
    + Default
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + SubAssign
    + MulAssign
{
    /// The answer to a comparison, one truth value per lane.
    type Mask: Mask;

    /// The ordered number that stands for all lanes where a single decision must be taken, such as
    /// the size of a step.
    ///
    /// It is of the same precision as the lanes; for `f32` and `f64` it is the type itself.
    type Real: Scalar<Real = Self::Real, Mask = bool> + PartialOrd;

    /// The number of lanes, which is the number of states that a chain of this scalar computes side by side.
    const LANES: usize = 1;

    /// The number nearest to `value`. For a literal it is computed while compiling.
    fn constant(value: f64) -> Self;

    /// The unit in the last place of one.
    fn epsilon() -> Self;

    /// `self · factor + addend`.
    ///
    /// It is rounded twice, after the product and after the sum, and so the same bits everywhere.
    /// With the feature `fma`, `f32` and `f64` round once where the target has an instruction for it
    /// (`fma` on x86, all of aarch64), which is faster; elsewhere nothing changes.
    #[inline(always)]
    fn mul_add(self, factor: Self, addend: Self) -> Self {
        self * factor + addend
    }

    /// `self · factor − subtrahend`, rounded as [`mul_add`](Scalar::mul_add).
    #[inline(always)]
    fn mul_sub(self, factor: Self, subtrahend: Self) -> Self {
        self * factor - subtrahend
    }

    /// `addend − self · factor`, rounded as [`mul_add`](Scalar::mul_add).
    #[inline(always)]
    fn mul_neg_add(self, factor: Self, addend: Self) -> Self {
        addend - self * factor
    }

    /// Returns `-self`.
    ///
    /// A type may have a form of the negative that compiles faster than its operator; the value is the same.
    #[inline(always)]
    fn negate(self) -> Self {
        -self
    }

    /// One divided by `self`.
    fn recip(self) -> Self;

    /// The square root, correctly rounded; NaN for negative numbers.
    fn sqrt(self) -> Self;

    /// The magnitude of `self` with the sign of `sign`.
    fn copysign(self, sign: Self) -> Self;

    /// The magnitude.
    fn abs(self) -> Self;

    /// Sines and cosines of angles in radians, in this order, all computed side by side without a
    /// branch.
    ///
    /// For `f32` and `f64` each is within one unit in the last place for angles up to 10⁴ rad; see
    /// the section on accuracy of [the crate](crate#sines-cosines-and-angles) for larger ones. NaN
    /// and infinite angles give NaN.
    fn sin_cos<const N: usize>(angles: [Self; N]) -> ([Self; N], [Self; N]);

    /// The angle in rad, within ±π, from the x axis to the point of the plane whose y is `self` and
    /// whose x is `x`, computed without a branch.
    ///
    /// For `f32` and `f64` it is within one unit in the last place; see the section on accuracy of
    /// [the crate](crate#sines-cosines-and-angles). Zeros with their signs and infinities have the
    /// angles of IEEE 754: that of the origin is zero, and ±π if x is −0. NaN gives NaN.
    fn atan2(self, x: Self) -> Self;

    /// Returns whether `self` is greater than `other`, for each lane; false where either is NaN.
    fn simd_gt(self, other: Self) -> Self::Mask;

    /// Returns whether `self` is neither infinite nor NaN, for each lane.
    fn is_finite(self) -> Self::Mask;

    /// Returns the sum of all values, in an unspecified order of additions.
    // One chain of additions: from several partial sums the compiler would build vectors, and then extract the
    // values that the sum is computed from out of their lanes.
    #[inline(always)]
    fn sum(slices: &[&[Self]]) -> Self {
        let values = slices.iter().copied().flatten().copied();
        values.reduce(|sum, value| sum + value).unwrap_or(Self::constant(0.0))
    }

    /// Returns `if_true` for each lane where `mask` is true, and `if_false` for the others.
    fn select(mask: Self::Mask, if_true: Self, if_false: Self) -> Self;

    /// Returns the largest lane, or NaN if a lane is NaN.
    ///
    /// A scalar without lanes returns its value, a dual number its real part.
    fn max_lane(self) -> Self::Real;

    /// The same number in every lane.
    fn splat(value: Self::Real) -> Self;
}
