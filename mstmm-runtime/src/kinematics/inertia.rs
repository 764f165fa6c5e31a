//! The inertia of a chain as a point feels it.

use nalgebra::{SMatrix, SVector};

use super::space::zeros;
use crate::{Error, Mask, Scalar};

/// Returns J M⁻¹ Jᵀ, from a function that writes the product of M⁻¹ with a vector; for generated code.
///
/// # Errors
///
/// Those of the function.
#[inline]
pub fn inverse_operational_space_inertia<T: Scalar, const R: usize, const N: usize>(
    jacobian: &SMatrix<T, R, N>,
    mut solve: impl FnMut(&SVector<T, N>, &mut SVector<T, N>) -> Result<(), Error>,
) -> Result<SMatrix<T, R, R>, Error> {
    let columns = &jacobian.data.0;
    let (mut row, mut solved) = (zeros::<T, N, 1>(), zeros::<T, N, 1>());
    let mut product = zeros::<T, R, R>();
    for (k, sums) in product.data.0.iter_mut().enumerate() {
        for (entry, column) in row.as_mut_slice().iter_mut().zip(columns) {
            *entry = column.get(k).copied().unwrap_or_default();
        }
        solve(&row, &mut solved)?;
        for (column, &rate) in columns.iter().zip(solved.as_slice()) {
            for (sum, &unit) in sums.iter_mut().zip(column) {
                *sum = unit.mul_add(rate, *sum);
            }
        }
    }
    Ok(product)
}

/// The part of a diagonal entry, in units in the last place for each row, that a pivot must exceed.
///
/// The entries of J M⁻¹ Jᵀ carry the rounding of M⁻¹, which amplifies that of the mass matrix.
const PIVOT_ULPS: f64 = 1024.0;

/// Returns the inverse of a symmetric matrix that is positive definite, by its Cholesky decomposition `L Lᵀ`; for
/// generated code. Only the lower triangle is read.
///
/// # Errors
///
/// `Error::SingularMatrix` if a pivot is not positive beyond rounding, in any lane.
#[inline]
pub fn inverse_of_positive<T: Scalar, const R: usize>(
    matrix: &SMatrix<T, R, R>,
) -> Result<SMatrix<T, R, R>, Error> {
    let rounding = T::epsilon() * T::constant(PIVOT_ULPS);
    // `lower[i][j]` is row i, column j; its diagonal has the reciprocals.
    let mut lower = [[T::constant(0.0); R]; R];
    let mut regular = <T::Mask as Mask>::splat(true);
    for j in 0..R {
        for i in j..R {
            let mut entry = matrix.data.0[j][i];
            let (one, other) = (lower[i], lower[j]);
            for (&factor, &pivot) in one.iter().zip(&other).take(j) {
                entry = factor.mul_neg_add(pivot, entry);
            }
            if i == j {
                regular = regular & entry.simd_gt(rounding * matrix.data.0[j][j].abs());
                lower[j][j] = entry.sqrt().recip();
            } else {
                lower[i][j] = entry * lower[j][j];
            }
        }
    }
    if !regular.all() {
        return Err(Error::SingularMatrix);
    }
    // The inverse of L, lower triangular as well: column by column.
    let mut inverse_of_lower = [[T::constant(0.0); R]; R];
    for j in 0..R {
        inverse_of_lower[j][j] = lower[j][j];
        for i in j + 1..R {
            let mut entry = T::constant(0.0);
            for k in j..i {
                entry = lower[i][k].mul_neg_add(inverse_of_lower[k][j], entry);
            }
            inverse_of_lower[i][j] = entry * lower[i][i];
        }
    }
    let mut inverse = zeros::<T, R, R>();
    for i in 0..R {
        for j in 0..=i {
            let mut entry = T::constant(0.0);
            for row in &inverse_of_lower[i..] {
                entry = row[i].mul_add(row[j], entry);
            }
            (inverse.data.0[i][j], inverse.data.0[j][i]) = (entry, entry);
        }
    }
    Ok(inverse)
}
