//! The null space of a matrix: the rates that satisfy linear constraints.

use crate::Scalar;
use nalgebra::{SMatrix, SVector};

/// Returns a basis of the null space of a matrix G with R rows and N columns, and its dimension D: the first D columns of the
/// result are orthonormal with G b = 0, the others are zero.
///
/// With the constraint Jacobian of a closed chain, the columns span the rates that keep it closed; with a basis B of them, the
/// mass matrix on this tangent space is Bᵀ M B, and efforts act on it as Bᵀ τ.
///
/// A row counts as dependent on others if less than `tolerance` of its length is left when they are removed from it. The basis is
/// found by Gram-Schmidt orthogonalisation, twice for each vector, with the longest remaining vector first. It has no lanes,
/// since the dimension is the same for all of them.
///
/// Entries are not tested. A row with an entry that is not finite, or with a squared length that overflows or vanishes, counts
/// as dependent: the result is then the null space of the other rows. Scale rows with entries beyond 1e150 or below 1e-150, in
/// `f32` 1e18 and 1e-18.
#[doc(alias("kernel", "tangent space", "constraint null space", "QR"))]
pub fn null_space<T, const R: usize, const N: usize>(
    matrix: &SMatrix<T, R, N>,
    tolerance: T,
) -> (SMatrix<T, N, N>, usize)
where
    T: Scalar<Real = T, Mask = bool> + PartialOrd,
{
    let zero = crate::generated::vector([T::constant(0.0); N]);
    let mut found = [zero; N];
    let mut rank = 0;
    let mut rows = [zero; R];
    for (row, vector) in rows.iter_mut().enumerate() {
        vector.iter_mut().zip(matrix.row(row).iter()).for_each(|(to, &from)| *to = from);
    }
    let lengths = rows.map(|row| length(&row));
    rank = extend(&mut found, rank, rows, lengths, tolerance);
    let units = core::array::from_fn(|k| unit::<T, N>(k));
    // Of the unit vectors at least one keeps 1/√N of its length until the basis is complete.
    let count = T::constant(4.0 * N as f64).sqrt().recip();
    let complete = extend(&mut found, rank, units, [T::constant(1.0); N], count);
    let mut basis = SMatrix::from_array_storage(nalgebra::ArrayStorage([[T::constant(0.0); N]; N]));
    for (mut column, vector) in basis.column_iter_mut().zip(found.iter().take(complete).skip(rank))
    {
        column.copy_from(vector);
    }
    (basis, complete.saturating_sub(rank))
}

/// Adds to orthonormal vectors those of `vectors` that are independent of them, the longest rest first. Returns the new number.
fn extend<T, const N: usize, const K: usize>(
    found: &mut [SVector<T, N>; N],
    mut count: usize,
    mut vectors: [SVector<T, N>; K],
    lengths: [T; K],
    tolerance: T,
) -> usize
where
    T: Scalar<Real = T, Mask = bool> + PartialOrd,
{
    let mut left = [true; K];
    for _ in 0..K {
        let mut best: Option<(usize, T)> = None;
        for (index, vector) in vectors.iter_mut().enumerate() {
            remove(vector, found.iter().take(count));
            let rest = length(vector);
            let is_independent = lengths.get(index).is_some_and(|&whole| rest > tolerance * whole);
            let is_longer = best.is_none_or(|(_, longest)| rest > longest);
            if is_independent && is_longer && left.get(index) == Some(&true) {
                best = Some((index, rest));
            }
        }
        let Some((index, _)) = best else { return count };
        let (Some(vector), Some(left)) = (vectors.get(index), left.get_mut(index)) else {
            return count;
        };
        let mut direction = *vector * length(vector).recip();
        remove(&mut direction, found.iter().take(count));
        let Some(place) = found.get_mut(count) else { return count };
        *place = direction * length(&direction).recip();
        *left = false;
        count += 1;
    }
    count
}

/// Removes the parts along orthonormal vectors.
fn remove<'a, T: Scalar, const N: usize>(
    vector: &mut SVector<T, N>,
    along: impl Iterator<Item = &'a SVector<T, N>>,
) {
    for direction in along {
        let amount = dot(direction, vector);
        vector.iter_mut().zip(direction.iter()).for_each(|(x, &d)| *x = amount.mul_neg_add(d, *x));
    }
}

fn dot<T: Scalar, const N: usize>(a: &SVector<T, N>, b: &SVector<T, N>) -> T {
    a.iter().zip(b.iter()).fold(T::constant(0.0), |sum, (&a, &b)| a.mul_add(b, sum))
}

fn length<T: Scalar, const N: usize>(vector: &SVector<T, N>) -> T {
    dot(vector, vector).sqrt()
}

fn unit<T: Scalar, const N: usize>(number: usize) -> SVector<T, N> {
    let entry = |k: usize| T::constant(if k == number { 1.0 } else { 0.0 });
    crate::generated::vector(core::array::from_fn(entry))
}

#[cfg(test)]
mod tests {
    use super::null_space;
    use nalgebra::SMatrix;

    /// The rows that remain are independent, so the null space has one dimension more for each row that does not count.
    #[test]
    fn rows_that_overflow_vanish_or_are_not_numbers_do_not_count() {
        let first = SMatrix::<f64, 1, 3>::new(0.0, 1.0, 2.0);
        for entry in [f64::NAN, f64::INFINITY, 1e200, 1e-200] {
            let mut matrix = SMatrix::<f64, 2, 3>::zeros();
            matrix.set_row(0, &first);
            matrix[(1, 0)] = entry;
            let (basis, dimension) = null_space(&matrix, 1e-9);
            assert_eq!(dimension, 2, "{entry}");
            // Sums of three products of numbers up to two.
            assert!((first * basis).amax() < 1e-15, "{entry}: {basis}");
            let square = basis.transpose() * basis;
            let unit = SMatrix::<f64, 3, 3>::from_fn(|i, j| f64::from(u8::from(i == j && i < 2)));
            assert!((square - unit).amax() < 1e-15, "{entry}: {basis}");
        }
    }
}
