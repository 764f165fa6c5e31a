//! Bounds on how far a correction of a closed chain rotates its hinges.
//!
//! Near a pose where its links are in line, Newton's method asks for rotations by many turns. What it finds there is
//! closed, and nowhere near the start.

use crate::{Error, Mask, Scalar};

/// The largest rotation of a hinge by one correction, in rad.
pub const LARGEST_ROTATION: f64 = 0.5;

/// Consecutive coordinates that are angles of a hinge or its quaternion.
#[derive(Clone, Copy, Debug)]
pub struct RotationCoordinates {
    /// The index of the first coordinate.
    pub first: usize,
    /// The number of consecutive coordinates.
    pub entries: usize,
    /// The number of coordinates from one repetition to the next.
    pub stride: usize,
    /// The number of repetitions; one for a hinge that is not repeated.
    pub count: usize,
    /// Whether they are a quaternion, whose components change by half the angle.
    pub quaternion: bool,
}

/// Returns the largest change of the coordinates in the table, in rad.
#[inline]
fn largest_rotation<T: Scalar>(before: &[T], after: &[T], table: &[RotationCoordinates]) -> T {
    let mut largest = T::default();
    for &RotationCoordinates { first, entries, stride, count, quaternion } in table {
        let factor = T::constant(if quaternion { 2.0 } else { 1.0 });
        for first in (first..).step_by(stride.max(1)).take(count) {
            let of = |q: &[T], entry: usize| q.get(first + entry).copied().unwrap_or_default();
            for entry in 0..entries {
                let change = ((of(after, entry) - of(before, entry)) * factor).abs();
                largest = T::select(change.simd_gt(largest), change, largest);
            }
        }
    }
    largest
}

/// Shortens the change of the coordinates from `before` to `after` until no hinge rotates by more than half a rad.
/// Returns whether it did: quaternions are then to be normalised.
pub fn limit_rotations<T: Scalar>(
    before: &[T],
    after: &mut [T],
    table: &[RotationCoordinates],
) -> bool {
    let limit = T::constant(LARGEST_ROTATION);
    let largest = largest_rotation(before, after, table);
    let exceeds = largest.simd_gt(limit);
    if (!exceeds).all() {
        return false;
    }
    let scale = limit * largest.recip();
    for (after, &before) in after.iter_mut().zip(before) {
        let nearer = (*after - before).mul_add(scale, before);
        *after = T::select(exceeds, nearer, *after);
    }
    true
}

/// Fails if a hinge rotates by more than half a rad from `before` to `after`.
///
/// # Errors
/// [`Error::NotAssembled`].
#[inline]
pub fn check_rotations<T: Scalar>(
    before: &[T],
    after: &[T],
    table: &[RotationCoordinates],
) -> Result<(), Error> {
    let exceeds = largest_rotation(before, after, table).simd_gt(T::constant(LARGEST_ROTATION));
    if (!exceeds).all() { Ok(()) } else { Err(Error::NotAssembled) }
}
