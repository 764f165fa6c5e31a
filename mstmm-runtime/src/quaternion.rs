//! Checks of the quaternions of states and prescribed motions.

use crate::origin;
use crate::{Error, Mask, Scalar};

/// The smallest accepted length of a quaternion.
const SHORTEST: f64 = 0.9;

/// The largest accepted length of a quaternion.
const LONGEST: f64 = 1.1;

/// The rounding error of the square of a length, in units in the last place of one.
const ROUNDING: f64 = 8.0;

/// Returns the sum of the squares of the components.
///
/// It is a sum from one end to the other: LLVM would compute a sum of pairs in a SIMD register, from which others have to take
/// the components.
fn square<T: Scalar>(&[w, x, y, z]: &[T; 4]) -> T {
    z.mul_add(z, y.mul_add(y, x.mul_add(x, w * w)))
}

/// Returns whether all components are finite, for each lane.
fn is_finite<T: Scalar>([w, x, y, z]: &[T; 4]) -> T::Mask {
    w.is_finite() & x.is_finite() & y.is_finite() & z.is_finite()
}

/// Returns whether the length of a quaternion is between 0.9 and 1.1, for each lane.
///
/// A square that overflows is infinite, one that underflows zero.
#[inline]
fn has_valid_length<T: Scalar>(quaternion: &[T; 4]) -> T::Mask {
    let [shortest, longest] = [SHORTEST * SHORTEST, LONGEST * LONGEST];
    let largest_difference =
        T::constant((longest - shortest) / 2.0) + T::constant(ROUNDING) * T::epsilon();
    let difference = square(quaternion) - T::constant((longest + shortest) / 2.0);
    largest_difference.simd_gt(difference.abs())
}

/// Returns whether the quaternion of any lane is finite and has a length that is not between 0.9 and 1.1.
///
/// A quaternion that is not finite is found by the checks for [`Error::NotFinite`].
#[inline]
fn is_refused<T: Scalar>(quaternion: &[T; 4]) -> bool {
    let is_valid = has_valid_length(quaternion);
    !is_valid.all() && has_finite_invalid_lane(quaternion, is_valid)
}

/// Returns whether the quaternion of any lane is finite and not valid. Out of line, since it is rarely called.
#[cold]
fn has_finite_invalid_lane<T: Scalar>(quaternion: &[T; 4], is_valid: T::Mask) -> bool {
    !(is_valid | !is_finite(quaternion)).all()
}

/// Fails if the quaternion of `hinge` is finite and its length is not between 0.9 and 1.1.
///
/// # Errors
/// [`Error::InvalidQuaternion`].
#[inline]
pub fn check_quaternion<T: Scalar>(hinge: &'static str, quaternion: &[T; 4]) -> Result<(), Error> {
    if is_refused(quaternion) { Err(Error::InvalidQuaternion { hinge }) } else { Ok(()) }
}

/// The indices of the quaternions of a hinge in the coordinates.
#[derive(Clone, Copy, Debug)]
pub struct HingeQuaternions {
    /// The hinge's name.
    pub hinge: &'static str,
    /// The index of the first component of the first quaternion.
    pub first: usize,
    /// The number of coordinates from one repetition to the next.
    pub stride: usize,
    /// The number of repetitions; one for a hinge that is not repeated.
    pub count: usize,
}

/// Checks all quaternions in the coordinates `q`.
///
/// # Errors
/// [`Error::InvalidQuaternion`] with the first hinge of the table that fails [`check_quaternion`].
#[inline]
pub fn check_quaternions<T: Scalar>(q: &[T], table: &[HingeQuaternions]) -> Result<(), Error> {
    for &HingeQuaternions { hinge, first, stride, count } in table {
        let coordinates = q.get(first..).unwrap_or_default();
        for repetition in coordinates.chunks(stride.max(1)).take(count) {
            if let Some(quaternion) = repetition.first_chunk::<4>() {
                check_quaternion(hinge, quaternion)?;
            }
        }
    }
    Ok(())
}

/// Returns the quaternion, normalised to unit length.
///
/// # Errors
/// [`Error::NotFinite`] if a component is not finite, and those of [`check_quaternion`].
pub(crate) fn to_unit_length<T: Scalar>(
    hinge: &'static str,
    quaternion: [T; 4],
) -> Result<[T; 4], Error> {
    if !is_finite(&quaternion).all() {
        return Err(Error::NotFinite(origin::of_argument("quaternion", &quaternion)));
    }
    check_quaternion(hinge, &quaternion)?;
    let scale = square(&quaternion).sqrt().recip();
    Ok(quaternion.map(|component| component * scale))
}
