//! Small linear systems, by Gaussian elimination.
//!
//! Rows are exchanged by masks and not by branches, so every lane has its own pivots.

use super::Columns;
use crate::origin::{Origin, of_argument};
use crate::{Error, Mask, Scalar};
use core::mem::take;
use core::slice::from_mut;
use nalgebra::SMatrix;

/// Returns X with A X = B, by Gaussian elimination with scaled partial pivoting.
///
/// # Errors
/// [`Error::SingularMatrix`] if A is singular up to rounding, in any lane: a pivot is not larger than N ε times the
/// largest entry of its row, or not finite. [`Error::NotFinite`] if an entry of the result is not finite: an entry of A or B is
/// not, or the result overflows.
#[doc(alias("LU", "linear system", "inverse"))]
pub fn solve<T: Scalar, const N: usize, const M: usize>(
    a: &SMatrix<T, N, N>,
    b: &SMatrix<T, N, M>,
) -> Result<SMatrix<T, N, M>, Error> {
    let (x, []) = solve_both(&a.data.0, &b.data.0, &[])?;
    checked(x.into(), a, b)
}

/// Returns X with A X = B for a symmetric positive definite A, by elimination without exchanges of rows.
///
/// Mass matrices are positive definite, and so is J M⁻¹ Jᵀ where a Jacobian J has full rank.
///
/// # Errors
/// [`Error::SingularMatrix`] if A is not positive definite up to rounding, in any lane: a pivot is not larger than N ε
/// times its diagonal entry, or not finite. [`Error::NotFinite`] if an entry of the result is not finite: an entry of A or B is
/// not, or the result overflows.
#[doc(alias("Cholesky", "LDLT", "LLT", "inverse"))]
pub fn solve_positive_definite<T: Scalar, const N: usize, const M: usize>(
    a: &SMatrix<T, N, N>,
    b: &SMatrix<T, N, M>,
) -> Result<SMatrix<T, N, M>, Error> {
    let mut rows = rows_of(&a.data.0, &b.data.0, &[]);
    for (index, row) in rows.iter_mut().enumerate() {
        row.weight = entry(&row.left, index).abs().recip();
    }
    eliminate::<false, T, N, M, 0>(&mut rows)?;
    let (x, []) = columns_of(&rows);
    checked(x.into(), a, b)
}

/// Returns X of A X = B if it is finite.
///
/// # Errors
/// [`Error::NotFinite`] of an entry of A or B, or of a result that overflows.
fn checked<T: Scalar, const N: usize, const M: usize>(
    x: SMatrix<T, N, M>,
    a: &SMatrix<T, N, N>,
    b: &SMatrix<T, N, M>,
) -> Result<SMatrix<T, N, M>, Error> {
    if x.iter().all(|entry| entry.is_finite().all()) {
        return Ok(x);
    }
    Err(Error::NotFinite(match of_argument("a", a.as_slice()) {
        Origin::Result => of_argument("b", b.as_slice()),
        of_a => of_a,
    }))
}

/// Returns A⁻¹ B and A⁻¹ C.
///
/// # Errors
/// Those of [`solve`].
pub(super) fn solve_both<T: Scalar, const N: usize, const M: usize, const K: usize>(
    a: &Columns<T, N, N>,
    b: &Columns<T, N, M>,
    c: &Columns<T, N, K>,
) -> Result<(Columns<T, N, M>, Columns<T, N, K>), Error> {
    let mut rows = rows_of(a, b, c);
    for row in &mut rows {
        row.weight = super::largest(&row.left).recip();
    }
    eliminate::<true, T, N, M, K>(&mut rows)?;
    Ok(columns_of(&rows))
}

/// A row of the matrices A, B and C in A X = B, A Y = C.
#[derive(Clone, Copy)]
struct Row<T, const N: usize, const M: usize, const K: usize> {
    left: [T; N],
    right: [T; M],
    other: [T; K],
    /// One divided by the size that pivots of the row are compared with.
    weight: T,
}

impl<T: Scalar, const N: usize, const M: usize, const K: usize> Row<T, N, M, K> {
    /// Subtracts factor · row.
    fn subtract(&mut self, factor: T, row: &Self) {
        fn subtract<T: Scalar, const N: usize>(from: &mut [T; N], factor: T, row: &[T; N]) {
            let both = from.iter_mut().zip(row);
            both.for_each(|(from, &entry)| *from = factor.mul_neg_add(entry, *from));
        }
        subtract(&mut self.left, factor, &row.left);
        subtract(&mut self.right, factor, &row.right);
        subtract(&mut self.other, factor, &row.other);
    }

    /// Exchanges both rows in the lanes where `row` has the larger pivot in this column, relative to its size.
    fn exchange_if_smaller(&mut self, row: &mut Self, column: usize) {
        fn exchange<T: Scalar>(mask: T::Mask, a: &mut [T], b: &mut [T]) {
            for (a, b) in a.iter_mut().zip(b) {
                (*a, *b) = (T::select(mask, *b, *a), T::select(mask, *a, *b));
            }
        }
        let size = |row: &Self| entry(&row.left, column).abs() * row.weight;
        let mask = size(row).simd_gt(size(self));
        exchange(mask, &mut self.left, &mut row.left);
        exchange(mask, &mut self.right, &mut row.right);
        exchange(mask, &mut self.other, &mut row.other);
        exchange(mask, from_mut(&mut self.weight), from_mut(&mut row.weight));
    }
}

/// Reduces A to the unit matrix, so that B and C become A⁻¹ B and A⁻¹ C. Without exchanges pivots must be positive.
///
/// # Errors
/// [`Error::SingularMatrix`] if a pivot is not larger than N ε times the size of its row, or not finite.
fn eliminate<const EXCHANGE: bool, T: Scalar, const N: usize, const M: usize, const K: usize>(
    rows: &mut [Row<T, N, M, K>; N],
) -> Result<(), Error> {
    let smallest = T::constant(N as f64) * T::epsilon();
    let mut rest = rows.as_mut_slice();
    for column in 0..N {
        let Some((row, below)) = take(&mut rest).split_first_mut() else { break };
        if EXCHANGE {
            below.iter_mut().for_each(|other| row.exchange_if_smaller(other, column));
        }
        let pivot = entry(&row.left, column);
        let size = if EXCHANGE { pivot.abs() } else { pivot } * row.weight;
        if !(size.simd_gt(smallest) & size.is_finite()).all() {
            return Err(Error::SingularMatrix);
        }
        let inverse = pivot.recip();
        for other in below.iter_mut() {
            other.subtract(entry(&other.left, column) * inverse, row);
        }
        rest = below;
    }
    let mut rest = rows.as_mut_slice();
    while let Some((row, above)) = take(&mut rest).split_last_mut() {
        let column = above.len();
        let inverse = entry(&row.left, column).recip();
        row.right.iter_mut().chain(&mut row.other).for_each(|entry| *entry *= inverse);
        // The other columns of the left side have been used.
        row.left = [T::constant(0.0); N];
        above.iter_mut().for_each(|other| other.subtract(entry(&other.left, column), row));
        rest = above;
    }
    Ok(())
}

/// Returns an entry, or zero beyond the end.
#[inline(always)]
fn entry<T: Scalar>(row: &[T], index: usize) -> T {
    row.get(index).copied().unwrap_or_default()
}

fn rows_of<T: Scalar, const N: usize, const M: usize, const K: usize>(
    a: &Columns<T, N, N>,
    b: &Columns<T, N, M>,
    c: &Columns<T, N, K>,
) -> [Row<T, N, M, K>; N] {
    fn row<T: Scalar, const N: usize, const M: usize>(
        a: &Columns<T, N, M>,
        index: usize,
    ) -> [T; M] {
        core::array::from_fn(|column| a.get(column).map_or(T::default(), |a| entry(a, index)))
    }
    core::array::from_fn(|index| Row {
        left: row(a, index),
        right: row(b, index),
        other: row(c, index),
        weight: T::constant(1.0),
    })
}

/// Returns the columns of the right sides.
fn columns_of<T: Scalar, const N: usize, const M: usize, const K: usize>(
    rows: &[Row<T, N, M, K>; N],
) -> (Columns<T, N, M>, Columns<T, N, K>) {
    let column = |index: usize| rows.each_ref().map(|row| entry(&row.right, index));
    let other = |index: usize| rows.each_ref().map(|row| entry(&row.other, index));
    (core::array::from_fn(column), core::array::from_fn(other))
}
