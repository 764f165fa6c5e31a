//! What the implementations of `Answers` are made of.

use crate::{Error, Scalar};
use nalgebra::{SMatrix, SVector};

pub use crate::description::Answer as Answer_;
pub use crate::kinematics::JacobianSlice;

/// Computes a matrix and copies it to a slice; `None` if the length of the slice is another.
pub fn written<T: Scalar, const R: usize, const C: usize>(
    to: &mut [T],
    compute: impl FnOnce(&mut SMatrix<T, R, C>) -> Result<(), Error>,
) -> Option<Result<(), Error>> {
    let mut matrix = super::matrix([[T::constant(0.0); R]; C]);
    if to.len() != matrix.len() {
        return None;
    }
    Some(compute(&mut matrix).map(|()| to.copy_from_slice(matrix.as_slice())))
}

/// Copies parts to a slice, one after the other; `None` if the length of the slice is another.
pub fn write_parts<T: Scalar, const P: usize>(to: &mut [T], parts: [&[T]; P]) -> Option<()> {
    let mut rest = to;
    for part in parts {
        let (place, behind) = rest.split_at_mut_checked(part.len())?;
        place.copy_from_slice(part);
        rest = behind;
    }
    rest.is_empty().then_some(())
}

/// Copies a slice to parts, one after the other; `None` if the length of the slice is another.
pub fn read_parts<T: Scalar, const P: usize>(from: &[T], parts: [&mut [T]; P]) -> Option<()> {
    let mut rest = from;
    for part in parts {
        let (values, behind) = rest.split_at_checked(part.len())?;
        part.copy_from_slice(values);
        rest = behind;
    }
    rest.is_empty().then_some(())
}

/// Returns the vector with the entries of a slice; `None` if its length is another.
pub fn given<T: Scalar, const N: usize>(from: &[T]) -> Option<SVector<T, N>> {
    from.try_into().ok().map(super::vector)
}
