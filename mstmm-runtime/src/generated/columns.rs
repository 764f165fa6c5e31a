//! Matrices of long chains, column by column.

use crate::{Columns, Error, Scalar};
use core::ops::Range;
use nalgebra::{SMatrix, SVector};

/// Computes a matrix from its products with unit vectors, as many columns at a time as [`Scalar::Columns`] has. The code
/// does not depend on the number of columns, and needs two vectors of these beside the matrix.
///
/// # Errors
///
/// The first error of `product`. A product fails for every vector or for none, so that the matrix is then unchanged.
pub fn columns<T: Scalar, const R: usize, const C: usize>(
    matrix: &mut SMatrix<T, R, C>,
    product: impl FnMut(&Units<T, C>, &mut SVector<T::Columns, R>) -> Result<(), Error>,
) -> Result<(), Error> {
    let mut units = super::vector([T::Columns::constant(0.0); C]);
    columns_where(matrix, |_| true, (&mut units, |units| units), product)
}

/// Computes a matrix as [`columns`] does, from products with a factor of several parts, of which one has the unit vectors.
/// The factor must be zero, and is zero afterwards.
///
/// # Errors
///
/// Those of [`columns`]. The factor may then have unit vectors.
pub fn columns_of_part<T: Scalar, F, const R: usize, const C: usize>(
    matrix: &mut SMatrix<T, R, C>,
    factor: (&mut F, fn(&mut F) -> &mut Units<T, C>),
    product: impl FnMut(&F, &mut SVector<T::Columns, R>) -> Result<(), Error>,
) -> Result<(), Error> {
    columns_where(matrix, |_| true, factor, product)
}

/// Computes the columns that are wanted, and may compute neighbours of them.
fn columns_where<T: Scalar, F, const R: usize, const C: usize>(
    matrix: &mut SMatrix<T, R, C>,
    is_wanted: impl Fn(usize) -> bool,
    (factor, part): (&mut F, fn(&mut F) -> &mut Units<T, C>),
    mut product: impl FnMut(&F, &mut SVector<T::Columns, R>) -> Result<(), Error>,
) -> Result<(), Error> {
    let zero = T::Columns::constant(0.0);
    let mut products = super::vector([zero; R]);
    let count = <T::Columns as Columns<T>>::COUNT;
    for (block, columns) in matrix.data.0.chunks_mut(count).enumerate() {
        let range = block * count..block * count + columns.len();
        if !range.clone().any(&is_wanted) {
            continue;
        }
        for (number, unit) in ones(part(factor), range.clone()).iter_mut().enumerate() {
            *unit = T::Columns::from_fn(|column| T::constant(f64::from(column == number)));
        }
        product(factor, &mut products)?;
        let [rows] = &products.data.0;
        T::Columns::write_columns(rows, columns);
        ones(part(factor), range).fill(zero);
    }
    Ok(())
}

/// Returns the entries of the unit vectors that are one in some column.
fn ones<S: Scalar, const C: usize>(units: &mut SVector<S, C>, range: Range<usize>) -> &mut [S] {
    units.data.0.as_flattened_mut().get_mut(range).unwrap_or_default()
}

/// Unit vectors of `C` entries, one in each column.
pub type Units<T, const C: usize> = SVector<<T as Scalar>::Columns, C>;

/// Columns of inputs that are columns of the inverse mass matrix, since the inputs are efforts of motors.
#[derive(Clone, Copy, Debug)]
pub struct MotorColumns {
    /// The first column of the inputs.
    pub input: usize,
    /// The first column of the inverse mass matrix.
    pub rate: usize,
    /// The distances to the columns of the next repetition.
    pub strides: [usize; 2],
    /// The number of repetitions.
    pub repetitions: usize,
}

impl MotorColumns {
    /// Returns the number of the repetition to which a column of the inputs belongs; none if it is another column.
    fn repetition(&self, column: usize) -> Option<usize> {
        let [stride, _] = self.strides;
        let distance = column.checked_sub(self.input)?;
        let (repetition, rest) = (distance.checked_div(stride)?, distance.checked_rem(stride)?);
        (rest == 0 && repetition < self.repetitions).then_some(repetition)
    }
}

/// Computes the columns of inputs: those of motors are columns of `inverse`, the inverse mass matrix, and the others are
/// computed as [`columns_of_part`] does.
///
/// # Errors
///
/// The first error of `product`.
pub fn input_columns<T: Scalar, F, const R: usize, const C: usize>(
    matrix: &mut SMatrix<T, R, C>,
    (inverse, motors): (&SMatrix<T, R, R>, &[MotorColumns]),
    factor: (&mut F, fn(&mut F) -> &mut Units<T, C>),
    product: impl FnMut(&F, &mut SVector<T::Columns, R>) -> Result<(), Error>,
) -> Result<(), Error> {
    let of_motor = |column| {
        let mut found = motors
            .iter()
            .filter_map(|motor| Some(motor.rate + motor.repetition(column)? * motor.strides[1]));
        found.next()
    };
    columns_where(matrix, |column| of_motor(column).is_none(), factor, product)?;
    for (column, entries) in matrix.data.0.iter_mut().enumerate() {
        if let Some(from) = of_motor(column).and_then(|rate| inverse.data.0.get(rate)) {
            *entries = *from;
        }
    }
    Ok(())
}
