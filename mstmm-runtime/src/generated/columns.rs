//! Matrices of long chains, column by column.

use crate::{Columns, Error, Scalar};
use nalgebra::{SMatrix, SVector};

/// Computes a matrix from its products with unit vectors, as many columns at a time as [`Scalar::Columns`] has. The code
/// does not depend on the number of columns, and needs two vectors of these beside the matrix.
///
/// # Errors
///
/// The first error of `product`. A product fails for every vector or for none, so that the matrix is then unchanged.
pub fn columns<T: Scalar, const R: usize, const C: usize>(
    matrix: &mut SMatrix<T, R, C>,
    mut product: impl FnMut(&Units<T, C>, &mut SVector<T::Columns, R>) -> Result<(), Error>,
) -> Result<(), Error> {
    let zero = T::Columns::constant(0.0);
    let mut units = super::vector([zero; C]);
    let mut products = super::vector([zero; R]);
    let count = <T::Columns as Columns<T>>::COUNT;
    for (block, columns) in matrix.data.0.chunks_mut(count).enumerate() {
        let first = block * count;
        for (number, unit) in units.iter_mut().skip(first).take(count).enumerate() {
            *unit = T::Columns::from_fn(|column| T::constant(f64::from(column == number)));
        }
        product(&units, &mut products)?;
        for (row, &values) in products.iter().enumerate() {
            for (column, value) in columns.iter_mut().zip(values.values()) {
                if let Some(entry) = column.get_mut(row) {
                    *entry = value;
                }
            }
        }
        units.iter_mut().skip(first).take(count).for_each(|unit| *unit = zero);
    }
    Ok(())
}

/// Unit vectors of `C` entries, one in each column.
pub type Units<T, const C: usize> = SVector<<T as Scalar>::Columns, C>;
