//! How generated code keeps what connection points share: every vector once, whichever the signs of its
//! entries, in the axes that it was computed in.

use crate::Scalar;

/// Where a connection point has its numbers, for generated code.
///
/// A place tells where a vector begins and of which entries the opposite lies there: with `10 n + s` at
/// number n − 1, with the first, second and third entry turned round where 1, 2 and 4 are in s; with 0
/// nowhere, as it is zero. Axes are the places of the columns of the matrix that leads to inertial
/// ones, in the plane of cosine and sine of the angle; all of them 0 where they are inertial.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Places<const AXES: usize, const VECTORS: usize> {
    pub(super) position: u32,
    pub(super) orientation: [u32; AXES],
    pub(super) vectors: [([u32; AXES], u32); VECTORS],
}

impl<const AXES: usize, const VECTORS: usize> Places<AXES, VECTORS> {
    /// Puts places together; vectors come with the axes that they are seen in.
    #[must_use]
    pub const fn new(
        position: u32,
        orientation: [u32; AXES],
        vectors: [([u32; AXES], u32); VECTORS],
    ) -> Self {
        Self { position, orientation, vectors }
    }
}

/// The entries of the vector at a place.
#[doc(hidden)]
#[inline(always)]
#[must_use]
pub fn entries<T: Scalar, const N: usize>(numbers: &[T], place: u32) -> [T; N] {
    let (first, signs) = ((place as usize / 10).checked_sub(1), place % 10);
    let found = first.and_then(|first| numbers.get(first..)?.first_chunk::<N>());
    let Some(&(mut entries)) = found else { return [T::constant(0.0); N] };
    for (k, entry) in entries.iter_mut().enumerate() {
        if signs >> k & 1 == 1 {
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
