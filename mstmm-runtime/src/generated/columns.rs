//! Matrices of long chains, column by column.

use crate::{Error, Scalar};
use nalgebra::{SMatrix, SVector};

/// Computes a matrix from its products with unit vectors. The code does not depend on the number of columns, and needs
/// two vectors beside the matrix.
///
/// # Errors
///
/// The first error of `product`. A product fails for every vector or for none, so that the matrix is then unchanged.
pub fn columns<T: Scalar, const R: usize, const C: usize>(
    matrix: &mut SMatrix<T, R, C>,
    mut product: impl FnMut(&SVector<T, C>, &mut SVector<T, R>) -> Result<(), Error>,
) -> Result<(), Error> {
    let mut unit = super::vector([T::constant(0.0); C]);
    let mut result = super::vector([T::constant(0.0); R]);
    for (number, mut column) in matrix.column_iter_mut().enumerate() {
        set(&mut unit, number, 1.0);
        product(&unit, &mut result)?;
        column.copy_from(&result);
        set(&mut unit, number, 0.0);
    }
    Ok(())
}

fn set<T: Scalar, const N: usize>(vector: &mut SVector<T, N>, number: usize, value: f64) {
    if let Some(entry) = vector.as_mut_slice().get_mut(number) {
        *entry = T::constant(value);
    }
}
