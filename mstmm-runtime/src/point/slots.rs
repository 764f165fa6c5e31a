//! The layout in which generated code stores the results of connection points: each vector once, in the axes in which
//! it was computed.

use crate::Scalar;

/// The slots of the results of a connection point in a workspace, for generated code.
///
/// A slot is the index of the first entry of a vector, counted from one; slot 0 is a vector of zeros that is not
/// stored. Axes are the slots of the columns of the rotation matrix to inertial axes; in the plane they are the
/// slot of cosine and sine of the angle. They are 0 if the axes are inertial.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct PointSlots<const AXES: usize, const VECTORS: usize> {
    pub(super) position: u32,
    pub(super) orientation: [u32; AXES],
    pub(super) vectors: [([u32; AXES], u32); VECTORS],
}

impl<const AXES: usize, const VECTORS: usize> PointSlots<AXES, VECTORS> {
    /// Makes the table from its slots; each vector comes with the slots of its axes.
    #[must_use]
    pub const fn new(
        position: u32,
        orientation: [u32; AXES],
        vectors: [([u32; AXES], u32); VECTORS],
    ) -> Self {
        Self { position, orientation, vectors }
    }
}

/// Returns the vector in a slot.
#[doc(hidden)]
#[inline(always)]
#[must_use]
pub fn vector_at<T: Scalar, const N: usize>(values: &[T], slot: u32) -> [T; N] {
    let first = (slot as usize).checked_sub(1);
    let stored = first.and_then(|first| values.get(first..)?.first_chunk::<N>());
    stored.copied().unwrap_or([T::constant(0.0); N])
}

/// Returns the difference of two vectors.
#[inline(always)]
pub(super) fn difference<T: Scalar, const N: usize>(mut vector: [T; N], other: [T; N]) -> [T; N] {
    for (entry, other) in vector.iter_mut().zip(other) {
        *entry -= other;
    }
    vector
}
