//! The scalar types of chains.

use core::fmt::Debug;
use core::ops::{Add, AddAssign, BitAnd, BitOr, Mul, MulAssign, Neg, Not, Sub, SubAssign};

/// The result of a comparison of [`Scalar`]s: one truth value per lane.
///
/// For `f32` and `f64` it is `bool`.
pub trait Mask:
    Copy + Debug + BitAnd<Output = Self> + BitOr<Output = Self> + Not<Output = Self>
{
    /// Returns the same truth value in every lane.
    fn splat(value: bool) -> Self;

    /// Returns whether every lane is true.
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

/// A scalar type that generated dynamics can use: `f32`, `f64`, SIMD lanes, dual numbers.
///
/// It has arithmetic but no order, because lanes have none: comparisons return a [`Mask`], and
/// [`select`](Scalar::select) replaces branches. Operations are not reassociated, and without the feature `fma` not
/// fused, so the results of a type have the same bits on every target.
///
/// # Sines, cosines and angles
///
/// [`sin_cos`](Scalar::sin_cos) of `f32` and `f64` is implemented in the crate `mstmm-runtime`: without branches, several
/// angles at once, `f32` in single precision only. Errors in units in the last place of the exact value, measured over
/// samples and near multiples of π/2:
///
/// | angle in rad | `f32` | `f64` |
/// |---|---|---|
/// | up to 10⁴ | below 0.85 | below 0.8 |
/// | up to 10⁶ | absolute error below ε · angle | below 1.8 |
/// | larger | the same | absolute error below ε · angle |
/// | NaN | from 3.3·10⁶ on | from 1.8·10¹⁵ on |
///
/// ε is [`epsilon`](Scalar::epsilon). For such large angles the error is that of the angle itself, whose last place is
/// then a large part of a full rotation. NaN and infinite angles give NaN.
///
/// [`atan2`](Scalar::atan2) is implemented in the same way. Its error, measured over samples of all directions and near
/// the limits of its approximations, is below 0.85 units in the last place for `f32` and below 0.75 for `f64`, over the
/// whole range of both types.
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
    /// The result of a comparison, one truth value per lane.
    type Mask: Mask;

    /// The ordered type of decisions that are the same for all lanes, such as the size of a step.
    ///
    /// It has the precision of the lanes; for `f32` and `f64` it is the type itself.
    type Real: Scalar<Real = Self::Real, Mask = bool> + PartialOrd;

    /// The type of several columns of a matrix: matrices of long chains are computed as many columns at a time as this
    /// type has.
    ///
    /// For `f32` and `f64` these are the native lanes of the feature `wide`. A type without lanes for its columns uses
    /// itself.
    type Columns: Columns<Self>;

    /// The type of packs: values of limbs of one shape, such as the legs of a robot, are computed side by side, one in
    /// each of its four columns.
    ///
    /// For `f32` and `f64` these are four lanes of the feature `wide`. A type with a single column, such as itself,
    /// computes one limb after the other.
    type Pack: Columns<Self>;

    /// The number of lanes: a chain of this scalar type computes as many states at once.
    const LANES: usize = 1;

    /// The order of the derivatives that a number carries: 0 without derivatives, 1 for a dual number, 2 for a dual number
    /// of dual numbers.
    ///
    /// [`assemble`](crate::GeneratedChain::assemble) makes as many further corrections when the values are closed.
    const DERIVATIVE_ORDER: usize = 0;

    /// Returns the number nearest to `value`. For a literal it is computed at compile time.
    fn constant(value: f64) -> Self;

    /// Returns the unit in the last place of one.
    fn epsilon() -> Self;

    /// Returns `self · factor + addend`.
    ///
    /// It is rounded twice, after the product and after the sum, so it has the same bits on all targets. With the
    /// feature `fma`, `f32` and `f64` are rounded once if the target has an instruction for it (`fma` on x86, all of
    /// aarch64), which is faster.
    #[inline(always)]
    fn mul_add(self, factor: Self, addend: Self) -> Self {
        self * factor + addend
    }

    /// Returns `self · factor − subtrahend`, rounded as [`mul_add`](Scalar::mul_add).
    #[inline(always)]
    fn mul_sub(self, factor: Self, subtrahend: Self) -> Self {
        self * factor - subtrahend
    }

    /// Returns `addend − self · factor`, rounded as [`mul_add`](Scalar::mul_add).
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

    /// Returns one divided by `self`.
    fn recip(self) -> Self;

    /// Returns the square root, correctly rounded; NaN for negative numbers.
    fn sqrt(self) -> Self;

    /// Returns the magnitude of `self` with the sign of `sign`.
    fn copysign(self, sign: Self) -> Self;

    /// Returns the magnitude.
    fn abs(self) -> Self;

    /// Returns the sines and the cosines of angles in rad, computed together and without branches.
    ///
    /// For `f32` and `f64` each is within one unit in the last place for angles up to 10⁴ rad; see
    /// [the table](Scalar#sines-cosines-and-angles) for larger ones. NaN and infinite angles give NaN.
    fn sin_cos<const N: usize>(angles: [Self; N]) -> ([Self; N], [Self; N]);

    /// Returns the angle in rad, within ±π, from the x axis to the point (`x`, `self`), computed without branches.
    ///
    /// For `f32` and `f64` it is within one unit in the last place; see
    /// [the errors](Scalar#sines-cosines-and-angles). Zeros with their signs and infinities have the
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

    /// Returns `self` with the derivatives of `other`; `self` for a type without derivatives.
    #[inline(always)]
    fn with_derivatives_of(self, _other: Self) -> Self {
        self
    }

    /// Returns the largest lane, or NaN if a lane is NaN.
    ///
    /// A scalar without lanes returns its value, a dual number its real part.
    fn max_lane(self) -> Self::Real;

    /// Returns the same number in every lane.
    fn splat(value: Self::Real) -> Self;
}

/// Values of type `T`, one for each of several columns of a matrix.
///
/// A scalar type is a single column of itself.
pub trait Columns<T>: Scalar {
    /// The number of columns.
    const COUNT: usize;

    /// Returns the same value in every column.
    fn repeated(value: T) -> Self;

    /// Returns the values that `value` returns for the index of each column.
    fn from_fn(value: impl Fn(usize) -> T) -> Self;

    /// Iterates over the values of the columns.
    fn values(self) -> impl Iterator<Item = T>;

    /// Writes the columns of a matrix of which `rows` has the rows.
    #[inline(always)]
    fn write_columns<const R: usize>(rows: &[Self; R], columns: &mut [[T; R]]) {
        for (row, &values) in rows.iter().enumerate() {
            for (column, value) in columns.iter_mut().zip(values.values()) {
                if let Some(entry) = column.get_mut(row) {
                    *entry = value;
                }
            }
        }
    }

    /// Returns the value of a column; of a column that is not there, the default value.
    #[inline(always)]
    fn column(self, column: usize) -> T
    where
        T: Scalar,
    {
        self.values().nth(column).unwrap_or_default()
    }
}

impl<T: Scalar> Columns<T> for T {
    const COUNT: usize = 1;

    #[inline(always)]
    fn repeated(value: T) -> Self {
        value
    }

    #[inline(always)]
    fn from_fn(value: impl Fn(usize) -> T) -> Self {
        value(0)
    }

    #[inline(always)]
    fn values(self) -> impl Iterator<Item = T> {
        core::iter::once(self)
    }
}
