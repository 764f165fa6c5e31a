//! Which quaternions are accepted where a state or a prescribed motion is given.

use crate::{Error, Mask, Scalar};

/// The shortest length of a quaternion that is accepted.
const SHORTEST: f64 = 0.9;

/// The longest length of a quaternion that is accepted.
const LONGEST: f64 = 1.1;

/// How many units in the last place of one the square of a length may be off by rounding.
const ROUNDING: f64 = 8.0;

/// The sum of the squares of the components.
fn square<T: Scalar>([w, x, y, z]: [T; 4]) -> T {
    (w * w + x * x) + (y * y + z * z)
}

/// Whether all components are finite, in every lane.
fn is_finite<T: Scalar>([w, x, y, z]: [T; 4]) -> T::Mask {
    w.is_finite() & x.is_finite() & y.is_finite() & z.is_finite()
}

/// Whether the quaternion is finite and its length is not between 0.9 and 1.1, in any lane.
///
/// A quaternion that is not finite is left to the checks for [`Error::NotFinite`].
#[inline]
fn is_refused<T: Scalar>(quaternion: [T; 4]) -> bool {
    let square = square(quaternion);
    let rounding = T::constant(ROUNDING) * T::epsilon();
    // A square that overflows is infinite, one that underflows zero.
    let short = (T::constant(SHORTEST * SHORTEST) - rounding).simd_gt(square);
    let long = square.simd_gt(T::constant(LONGEST * LONGEST) + rounding);
    !(!((short | long) & is_finite(quaternion))).all()
}

/// Fails if the quaternion of `hinge` is finite and its length is not between 0.9 and 1.1.
///
/// # Errors
/// [`Error::InvalidQuaternion`].
#[inline]
pub fn check_quaternion<T: Scalar>(hinge: &'static str, quaternion: [T; 4]) -> Result<(), Error> {
    if is_refused(quaternion) { Err(Error::InvalidQuaternion { hinge }) } else { Ok(()) }
}

/// Where the coordinates have the quaternions of a hinge.
#[derive(Clone, Copy, Debug)]
pub struct QuaternionsOf {
    /// The hinge's name.
    pub hinge: &'static str,
    /// The place of the first component of the first quaternion.
    pub first: usize,
    /// The distance from one repetition to the next.
    pub stride: usize,
    /// The number of repetitions; one for a hinge that is not repeated.
    pub count: usize,
}

/// Checks all quaternions in the coordinates `q`.
///
/// # Errors
/// [`Error::InvalidQuaternion`] with the first hinge of the table that fails
/// [`check_quaternion`].
#[inline]
pub fn check_quaternions<T: Scalar>(q: &[T], table: &[QuaternionsOf]) -> Result<(), Error> {
    for &QuaternionsOf { hinge, first, stride, count } in table {
        let own = q.get(first..).unwrap_or_default();
        for repetition in own.chunks(stride.max(1)).take(count) {
            if let Some(&quaternion) = repetition.first_chunk::<4>() {
                check_quaternion(hinge, quaternion)?;
            }
        }
    }
    Ok(())
}

/// The quaternion brought to unit length.
///
/// # Errors
/// [`Error::NotFinite`] if a component is not finite, and those of [`check_quaternion`].
pub(crate) fn to_unit_length<T: Scalar>(
    hinge: &'static str,
    quaternion: [T; 4],
) -> Result<[T; 4], Error> {
    if !is_finite(quaternion).all() {
        return Err(Error::NotFinite);
    }
    check_quaternion(hinge, quaternion)?;
    let scale = square(quaternion).sqrt().recip();
    Ok(quaternion.map(|component| component * scale))
}
