//! How generated code keeps what connection points share: every vector once, whichever its sign, in the
//! axes that it was computed in.

use crate::Scalar;

/// Where a connection point has its numbers, for generated code.
///
/// A place tells where a vector begins: with `n` at number n − 1, with `-n` the opposite vector there,
/// with 0 nowhere, as it is zero. Axes are the places of the columns of the matrix that leads to inertial
/// ones, in the plane of cosine and sine of the angle; all of them 0 where they are inertial.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Places<const AXES: usize, const VECTORS: usize> {
    pub(super) position: i32,
    pub(super) orientation: [i32; AXES],
    pub(super) vectors: [([i32; AXES], i32); VECTORS],
}

impl<const AXES: usize, const VECTORS: usize> Places<AXES, VECTORS> {
    /// Puts places together; vectors come with the axes that they are seen in.
    #[must_use]
    pub const fn new(
        position: i32,
        orientation: [i32; AXES],
        vectors: [([i32; AXES], i32); VECTORS],
    ) -> Self {
        Self { position, orientation, vectors }
    }
}

/// The entries of the vector at a place.
#[inline(always)]
pub(super) fn entries<T: Scalar, const N: usize>(numbers: &[T], place: i32) -> [T; N] {
    let first = (place.unsigned_abs() as usize).checked_sub(1);
    let found = first.and_then(|first| numbers.get(first..)?.first_chunk::<N>());
    let Some(&(mut entries)) = found else { return [T::constant(0.0); N] };
    if place < 0 {
        for entry in &mut entries {
            *entry = -*entry;
        }
    }
    entries
}

/// The difference of two vectors.
#[inline(always)]
pub(super) fn less<T: Scalar, const N: usize>(mut vector: [T; N], other: [T; N]) -> [T; N] {
    for (entry, other) in vector.iter_mut().zip(other) {
        *entry -= other;
    }
    vector
}
