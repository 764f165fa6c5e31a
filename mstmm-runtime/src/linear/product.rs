//! Products of matrices as loops over columns.
//!
//! A column of the result is a sum of columns of the left factor. So the lanes of a register are rows, which are side by
//! side in memory, and every column is loaded and stored once.

use super::Columns;
use crate::Scalar;
use core::ops::Range;
use nalgebra::SMatrix;

/// Computes −A D into `out`.
///
/// This is the last stage of a linearisation: with the inverse mass matrix A = M⁻¹ and the derivatives D of inverse
/// dynamics by coordinates, rates and parameters, −M⁻¹ D are those of the accelerations. Sums are in the order of the
/// columns of A for every size.
#[inline]
pub fn negative_product<T: Scalar, const N: usize, const M: usize>(
    a: &SMatrix<T, N, N>,
    d: &SMatrix<T, N, M>,
    out: &mut SMatrix<T, N, M>,
) {
    let (a, d, out) = (&a.data.0, &d.data.0, &mut out.data.0);
    if N <= 4 {
        for (out, d) in out.iter_mut().zip(d) {
            *out = negative_combination(a, d);
        }
    } else if N < 8 && T::LANES == 1 {
        // Columns of 5 to 7 numbers fill registers badly.
        padded::<T, 8, N, M>(a, d, out);
    } else {
        padded::<T, N, N, M>(a, d, out);
    }
}

/// Computes −A D into `out` for a matrix D that has zeros.
///
/// Robots that branch have such derivatives D, since a rate of one limb does not change the efforts in another. `pattern` has
/// the numbers of neighbouring columns of D, each with the rows where they may have other numbers than zero. Other rows
/// are not read. Ranges that exceed N are left out, and columns beyond those of the pattern stay unchanged. Sums are in the
/// order of [`negative_product`].
pub fn negative_product_of_rows<T: Scalar, const N: usize, const M: usize>(
    a: &SMatrix<T, N, N>,
    d: &SMatrix<T, N, M>,
    pattern: &[(usize, &[Range<usize>])],
    out: &mut SMatrix<T, N, M>,
) {
    let a = &a.data.0;
    let mut columns = out.data.0.iter_mut().zip(&d.data.0);
    for &(count, rows) in pattern {
        for (out, d) in columns.by_ref().take(count) {
            let mut sum = [T::constant(0.0); N];
            for rows in rows {
                if let (Some(a), Some(d)) = (a.get(rows.clone()), d.get(rows.clone())) {
                    add_negative_combination(&mut sum, a, d);
                }
            }
            *out = sum;
        }
    }
}

/// Computes −A D with the columns of A and of the result padded to P numbers, for N up to P.
///
/// The loop writes to the rest of the result and not to its columns, also if P is N: over an iterator of columns LLVM
/// vectorises the loop over the columns, and collects their entries one by one. For N = 9 that costs 2.5 times the time.
#[inline(always)]
fn padded<T: Scalar, const P: usize, const N: usize, const M: usize>(
    a: &Columns<T, N, N>,
    d: &Columns<T, N, M>,
    out: &mut Columns<T, N, M>,
) {
    let mut columns = [[T::default(); P]; N];
    for (padded, column) in columns.iter_mut().zip(a) {
        padded.iter_mut().zip(column).for_each(|(entry, &a)| *entry = a);
    }
    // Each column is written together with its padding, and the next column is written over the padding.
    let mut rest = out.as_flattened_mut();
    for d in d {
        let sum = negative_combination(&columns, d);
        match rest.first_chunk_mut::<P>() {
            Some(column) => *column = sum,
            None => rest.iter_mut().zip(sum).for_each(|(entry, sum)| *entry = sum),
        }
        rest = rest.split_at_mut_checked(N).map_or(&mut [], |(_, rest)| rest);
    }
}

/// Returns −Σ factor · column.
#[inline(always)]
fn negative_combination<T: Scalar, const R: usize, const K: usize>(
    columns: &Columns<T, R, K>,
    factors: &[T; K],
) -> [T; R] {
    let mut sum = [T::constant(0.0); R];
    add_negative_combination(&mut sum, columns, factors);
    sum
}

/// Adds −Σ factor · column to `sum`.
#[inline(always)]
fn add_negative_combination<T: Scalar, const R: usize>(
    sum: &mut [T; R],
    columns: &[[T; R]],
    factors: &[T],
) {
    for (column, &factor) in columns.iter().zip(factors) {
        for (sum, &entry) in sum.iter_mut().zip(column) {
            *sum = entry.mul_neg_add(factor, *sum);
        }
    }
}

/// Adds A B to `sum`.
pub(super) fn add_product<T: Scalar, const R: usize, const K: usize, const C: usize>(
    sum: &mut Columns<T, R, C>,
    a: &Columns<T, R, K>,
    b: &Columns<T, K, C>,
) {
    for (sum, factors) in sum.iter_mut().zip(b) {
        for (column, &factor) in a.iter().zip(factors) {
            let terms = sum.iter_mut().zip(column);
            terms.for_each(|(sum, &entry)| *sum = entry.mul_add(factor, *sum));
        }
    }
}

/// Returns A B.
pub(super) fn product<T: Scalar, const R: usize, const K: usize, const C: usize>(
    a: &Columns<T, R, K>,
    b: &Columns<T, K, C>,
) -> Columns<T, R, C> {
    let mut result = [[T::constant(0.0); R]; C];
    add_product(&mut result, a, b);
    result
}

/// Returns the transpose.
pub(super) fn transposed<T: Scalar, const R: usize, const C: usize>(
    a: &Columns<T, R, C>,
) -> Columns<T, C, R> {
    let mut result = [[T::constant(0.0); C]; R];
    for (index, column) in a.iter().enumerate() {
        for (row, &entry) in result.iter_mut().zip(column) {
            row.iter_mut().skip(index).take(1).for_each(|to| *to = entry);
        }
    }
    result
}
