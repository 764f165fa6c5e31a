//! How generated code stores what connection points share: every vector once, in the axes that it was
//! computed in.

use crate::Scalar;

/// Where a connection point has its numbers, for generated code.
///
/// A place is the number of a vector's first entry, counted from one; place 0 is a vector of zeros that is not
/// stored. Axes are the places of the columns of the matrix that leads to inertial axes, in the plane
/// the place of cosine and sine of the angle; all of them are 0 if they are inertial.
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
    let first = (place as usize).checked_sub(1);
    let found = first.and_then(|first| numbers.get(first..)?.first_chunk::<N>());
    found.copied().unwrap_or([T::constant(0.0); N])
}

/// The difference of two vectors.
#[inline(always)]
pub(super) fn less<T: Scalar, const N: usize>(mut vector: [T; N], other: [T; N]) -> [T; N] {
    for (entry, other) in vector.iter_mut().zip(other) {
        *entry -= other;
    }
    vector
}
