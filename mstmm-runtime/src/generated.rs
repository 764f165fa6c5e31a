//! Support functions for generated code: those of its parts that are the same for every chain.
//!
//! They are not part of the public interface and may change with every version.

pub mod answers;
mod checks;
mod columns;
pub mod description;
mod formats;
mod linkage;
mod not_asked;
mod packs;
mod regressor;
mod rotations;

/// The values that a loop leaves for later loops, one entry per repetition. Its memory is not initialised first.
pub use arrayvec::ArrayVec as LoopStore;

pub use crate::description::Values;
#[cfg(feature = "approx")]
pub use crate::formats::closeness;
#[cfg(feature = "serde")]
pub use crate::formats::maps;
pub use crate::formats::{Listing, ParameterRows};
pub use crate::kinematics::{RateRun, inverse_of_positive, inverse_operational_space_inertia};
pub use crate::not_asked_of_chain as not_asked;
pub use crate::point::{PointSlots, vector_at};
pub use crate::quaternion::{HingeQuaternions, check_quaternion, check_quaternions};
pub use checks::{
    PIVOT_ULPS, are_below, check_argument, check_finite, check_finite_slice, check_stored,
    or_argument, pivot_error, pivots_ok,
};
pub use columns::{MotorColumns, columns, columns_of_part, input_columns};
pub use linkage::{
    CORRECTIONS, Residual, assemble, check_rank, close, closure_error, loop_closure, rank_steps,
};
pub use not_asked::{AsksJacobianOfBody, NotAsked, Unanswered};
pub use packs::{lane, pack};
pub use regressor::{regressor_of_bodies, regressor_of_elements};
pub use rotations::{LARGEST_ROTATION, RotationCoordinates, check_rotations, limit_rotations};

#[cfg(feature = "approx")]
pub use approx;
#[cfg(feature = "defmt")]
pub use defmt;
#[cfg(feature = "serde")]
pub use serde_core as serde;

use crate::{Error, Mask, Scalar};
use core::mem::take;

/// The parameters of a chain and the values derived from them, read only.
///
/// All code in the module of the macro call can write the private fields of generated types. It cannot write the
/// fields of this type, so parameters and derived values always agree.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sealed<P, D = ()> {
    parameters: P,
    derived: D,
}

impl<P> Sealed<P> {
    /// Returns parameters without derived values.
    #[inline(always)]
    pub fn new(parameters: P) -> Self {
        Self { parameters, derived: () }
    }

    /// Adds the values derived from the parameters.
    #[inline(always)]
    pub fn with<D>(self, derived: D) -> Sealed<P, D> {
        Sealed { parameters: self.parameters, derived }
    }
}

impl<P, D> Sealed<P, D> {
    /// Returns the parameters.
    #[inline(always)]
    pub fn parameters(&self) -> &P {
        &self.parameters
    }

    /// Returns the values derived from the parameters.
    #[inline(always)]
    pub fn derived(&self) -> &D {
        &self.derived
    }
}

/// Keeps the compiler from moving stores across this point, which would occupy registers longer.
///
/// It compiles to no instruction and has no effect on values.
#[inline(always)]
pub fn store_fence() {
    core::sync::atomic::compiler_fence(core::sync::atomic::Ordering::SeqCst);
}

/// Replaces partly written results by new ones after an error.
#[cold]
#[inline(never)]
pub fn reset<W>(results: &mut W, new: impl FnOnce() -> W) {
    *results = new();
}

/// Checks that the values of a parameter are finite.
///
/// # Errors
/// [`Error::InvalidParameter`] with the reason.
#[cold]
pub fn check_parameter<T: Scalar>(name: &'static str, values: &[T]) -> Result<(), Error> {
    match are_finite(values) {
        true => Ok(()),
        false => Err(Error::InvalidParameter { name, reason: "must be a finite number" }),
    }
}

/// Checks that all values derived from a parameter are finite. The rules on values go first, because they name the cause:
/// a mass of zero has an infinite inverse.
///
/// # Errors
/// [`Error::InvalidParameter`] with the reason.
#[cold]
pub fn check_derived<T: Scalar>(name: &'static str, derived: &[&[T]]) -> Result<(), Error> {
    match derived.iter().all(|values| are_finite(values)) {
        true => Ok(()),
        false => Err(Error::InvalidParameter { name, reason: DERIVED_ARE_FINITE }),
    }
}

const DERIVED_ARE_FINITE: &str = "must leave all quantities derived from it finite";

fn are_finite<T: Scalar>(values: &[T]) -> bool {
    values.iter().all(|value| value.is_finite().all())
}

/// Checks values that depend on a parameter: each must be positive if the first entry of its rule is true, else not
/// negative.
///
/// # Errors
/// [`Error::InvalidParameter`] with the reason of the first rule that does not hold, or for a value that overflows.
#[cold]
pub fn check_rules<T: Scalar, const N: usize>(
    name: &'static str,
    values: &[T; N],
    rules: &[(bool, &'static str); N],
) -> Result<(), Error> {
    let zero = T::constant(0.0);
    for (value, &(positive, reason)) in values.iter().zip(rules) {
        let holds = if positive { value.simd_gt(zero) } else { !zero.simd_gt(*value) };
        if !value.is_finite().all() {
            return Err(Error::InvalidParameter { name, reason: DERIVED_ARE_FINITE });
        }
        if !holds.all() {
            return Err(Error::InvalidParameter { name, reason });
        }
    }
    Ok(())
}

/// The number of units in the last place of its scale that a value must exceed to count as not zero in equations
/// that must decide it.
///
/// Linearly dependent loop constraints leave the rounding of many operations.
pub const RANK_ULPS: f64 = 1024.0;

/// Returns `1 / value` if the value exceeds what rounding can leave of `scale`, else zero.
#[inline]
pub fn recip_above<T: Scalar>(value: T, scale: T) -> T {
    let above = value.simd_gt(T::epsilon() * T::constant(RANK_ULPS) * scale);
    T::select(above, value.recip(), T::constant(0.0))
}

/// Greater than zero and smaller than any inertia: with it a pivot of zero vanishes also if its scale is zero.
const TINY: f64 = 1e-30;

/// Returns whether a pivot is a number that is not positive beyond rounding; false if it is NaN.
#[inline]
pub fn pivot_vanishes<T: Scalar>(pivot: T, scale: T) -> T::Mask {
    // One comparison, because a repeated part may have thousands of pivots.
    scale.mul_add(T::epsilon() * T::constant(PIVOT_ULPS), T::constant(TINY)).simd_gt(pivot)
}

/// Fails with the name of a repeated hinge unless all of its pivots are positive.
///
/// # Errors
/// [`Error::Singular`].
#[inline]
pub fn check_pivot<M: Mask>(pivots_ok: M, hinge: &'static str) -> Result<(), Error> {
    if pivots_ok.all() { Ok(()) } else { Err(Error::Singular { hinge }) }
}

/// Values in a row, with a length that is known at compile time.
pub trait FixedLen {
    /// The type of a value.
    type Value;
    /// The number of values.
    const LEN: usize;
    /// Returns all values.
    fn values(&self) -> &[Self::Value];
    /// Returns all values, to be written.
    fn values_mut(&mut self) -> &mut [Self::Value];
}

impl<T, const LEN: usize> FixedLen for [T; LEN] {
    type Value = T;
    const LEN: usize = LEN;
    #[inline(always)]
    fn values(&self) -> &[T] {
        self
    }
    #[inline(always)]
    fn values_mut(&mut self) -> &mut [T] {
        self
    }
}

impl<T: Scalar, const LEN: usize> FixedLen for nalgebra::SVector<T, LEN> {
    type Value = T;
    const LEN: usize = LEN;
    #[inline(always)]
    fn values(&self) -> &[T] {
        self.as_slice()
    }
    #[inline(always)]
    fn values_mut(&mut self) -> &mut [T] {
        self.as_mut_slice()
    }
}

/// Returns the `N` values from index `FIRST` on.
#[inline(always)]
pub fn segment<A: FixedLen<Value: Copy>, const N: usize, const FIRST: usize>(
    array: &A,
) -> [A::Value; N] {
    chunks::<A, N, FIRST, 1>(array)[0]
}

/// Returns the values of a repeated part from index `FIRST` on, `N` for each of `COUNT` repetitions.
///
/// ```
/// mstmm_runtime::generated::chunks::<_, 2, 0, 2>(&[0.0; 4]);
/// ```
/// ```compile_fail
/// mstmm_runtime::generated::chunks::<_, 2, 1, 2>(&[0.0; 4]);
/// ```
#[inline(always)]
pub fn chunks<A: FixedLen, const N: usize, const FIRST: usize, const COUNT: usize>(
    array: &A,
) -> &[[A::Value; N]] {
    const { assert!(FIRST + N * COUNT <= A::LEN, "mstmm bug: chunks beyond the end of their array") };
    array.values()[FIRST..FIRST + N * COUNT].as_chunks().0
}

/// Returns the same values as [`chunks`], to be written.
#[inline(always)]
pub fn chunks_mut<A: FixedLen, const N: usize, const FIRST: usize, const COUNT: usize>(
    array: &mut A,
) -> &mut [[A::Value; N]] {
    const { assert!(FIRST + N * COUNT <= A::LEN, "mstmm bug: chunks beyond the end of their array") };
    array.values_mut()[FIRST..FIRST + N * COUNT].as_chunks_mut().0
}

/// Takes the repetitions of a segment, each of `N` values, from the rest of an array, and skips the values before it. It is
/// for loops that write to several segments of an array.
#[inline(always)]
pub fn take_chunks<'a, V, const N: usize, const SKIPPED: usize, const COUNT: usize>(
    rest: &mut &'a mut [V],
) -> &'a mut [[V; N]] {
    let (_, values) = take(rest).split_at_mut_checked(SKIPPED).unwrap_or_default();
    let (values, behind) = values.split_at_mut_checked(N * COUNT).unwrap_or_default();
    *rest = behind;
    values.as_chunks_mut().0
}

/// Returns the array with some entries set, each by its index.
#[must_use]
pub fn with_constants<T: Scalar, const N: usize>(
    mut array: [T; N],
    constants: &[(usize, T)],
) -> [T; N] {
    for &(index, value) in constants {
        if let Some(entry) = array.get_mut(index) {
            *entry = value;
        }
    }
    array
}

/// Returns the index of a connection point in the model, and the values of its segment and repetition.
///
/// Each segment is given by six integers: the first point in the model, the number of its points per repetition, the
/// first of all points, the number of all points, the first value, and the number of values per repetition.
#[inline]
pub fn locate_point<'a, T>(
    values: &'a [T],
    segments: &[[usize; 6]],
    index: usize,
) -> (usize, &'a [T]) {
    for &[model, per_repetition, first, all, place, count] in segments {
        if (first..first + all).contains(&index) {
            let (repetition, point) =
                ((index - first) / per_repetition, (index - first) % per_repetition);
            let rest = values.get(place + repetition * count..).unwrap_or_default();
            return (model + point, rest);
        }
    }
    (usize::MAX, &[])
}

/// Returns the square root of a number in a chain's description.
pub fn sqrt(value: f64) -> f64 {
    Scalar::sqrt(value)
}

/// Returns the sine of an angle in rad in a chain's description.
pub fn sin(value: f64) -> f64 {
    let ([sine], _) = <f64 as Scalar>::sin_cos([value]);
    sine
}

/// Returns the cosine of an angle in rad in a chain's description.
pub fn cos(value: f64) -> f64 {
    let (_, [cosine]) = <f64 as Scalar>::sin_cos([value]);
    cosine
}

/// Returns the sine of an angle in rad.
pub fn scalar_sin<T: Scalar>(angle: T) -> T {
    let ([sine], _) = T::sin_cos([angle]);
    sine
}

/// Returns the cosine of an angle in rad.
pub fn scalar_cos<T: Scalar>(angle: T) -> T {
    let (_, [cosine]) = T::sin_cos([angle]);
    cosine
}

/// Returns an entry of an array, zero beyond its end.
pub fn entry<T: Scalar>(array: &[T], index: usize) -> T {
    array.get(index).copied().unwrap_or_default()
}

/// Returns an entry of a parameter after one of them is set.
pub fn with_entry<T: Scalar>(before: &[T], index: usize, set: (usize, T)) -> T {
    if index == set.0 { set.1 } else { entry(before, index) }
}

/// Returns nalgebra's vector with these entries.
#[inline]
pub fn vector<T: Scalar, const N: usize>(entries: [T; N]) -> nalgebra::SVector<T, N> {
    nalgebra::SVector::from(entries)
}

/// Returns nalgebra's matrix with these columns.
#[inline]
pub fn matrix<T: Scalar, const R: usize, const C: usize>(
    columns: [[T; R]; C],
) -> nalgebra::SMatrix<T, R, C> {
    nalgebra::SMatrix::from_array_storage(nalgebra::ArrayStorage(columns))
}

/// Multiplies columns by `−M⁻¹`, of which `inverse` has the columns.
#[inline]
pub fn multiply_by_negative<T: Scalar, const N: usize>(
    inverse: &nalgebra::SMatrix<T, N, N>,
    columns: &mut [[T; N]],
) {
    for column in columns {
        let mut product = [T::constant(0.0); N];
        for (of_inverse, &factor) in inverse.data.0.iter().zip(&*column) {
            for (sum, &entry) in product.iter_mut().zip(of_inverse) {
                *sum = entry.mul_neg_add(factor, *sum);
            }
        }
        *column = product;
    }
}
