//! Products and linear equations of small matrices for any [`Scalar`]; nalgebra's own products require more traits.

use nalgebra::{Matrix3, SMatrix, Vector3};

use crate::Scalar;

/// A product of matrices, written between its factors.
pub(super) trait Times<const K: usize, const C: usize, T> {
    /// The product, with the rows of `self` and the columns of `right`.
    type Product;

    /// Returns `self` times `right`.
    fn times(&self, right: &SMatrix<T, K, C>) -> Self::Product;
}

impl<T: Scalar, const R: usize, const K: usize, const C: usize> Times<K, C, T>
    for SMatrix<T, R, K>
{
    type Product = SMatrix<T, R, C>;

    #[inline]
    fn times(&self, right: &SMatrix<T, K, C>) -> SMatrix<T, R, C> {
        SMatrix::from_fn(|row, column| {
            sum((0..K).map(|k| entry(self, (row, k)) * entry(right, (k, column))))
        })
    }
}

/// Returns an entry of a matrix, or zero outside; no index can panic.
pub(super) fn entry<T: Scalar, const R: usize, const C: usize>(
    matrix: &SMatrix<T, R, C>,
    at: (usize, usize),
) -> T {
    matrix.get(at).copied().unwrap_or_default()
}

/// Replaces an entry of a matrix.
pub(super) fn set<T: Scalar, const R: usize, const C: usize>(
    matrix: &mut SMatrix<T, R, C>,
    at: (usize, usize),
    value: T,
) {
    if let Some(place) = matrix.get_mut(at) {
        *place = value;
    }
}

/// The sum of all `terms`.
pub(super) fn sum<T: Scalar>(terms: impl Iterator<Item = T>) -> T {
    terms.fold(T::default(), |sum, term| sum + term)
}

/// A matrix of zeros.
pub(super) fn zeros<T: Scalar, const R: usize, const C: usize>() -> SMatrix<T, R, C> {
    SMatrix::from_fn(|_, _| T::default())
}

/// The identity I.
pub(super) fn identity<T: Scalar, const D: usize>() -> SMatrix<T, D, D> {
    SMatrix::from_fn(|row, column| T::constant(if row == column { 1.0 } else { 0.0 }))
}

/// r̃, the matrix of the cross product r × ….
pub(super) fn tilde<T: Scalar>(r: &Vector3<T>) -> Matrix3<T> {
    let ([x, y, z], o) = ((*r).into(), T::default());
    Matrix3::new(o, -z, y, z, o, -x, -y, x, o)
}

/// The block of R rows and C columns that begins at `row` and `column` of `matrix`.
pub(super) fn block<T: Scalar, const R: usize, const C: usize, const M: usize, const N: usize>(
    matrix: &SMatrix<T, M, N>,
    (row, column): (usize, usize),
) -> SMatrix<T, R, C> {
    SMatrix::from_fn(|i, j| entry(matrix, (row + i, column + j)))
}

/// Returns the rows and columns of `matrix` whose indices are in `entries`.
pub(super) fn pick<T: Scalar, const D: usize, const N: usize>(
    matrix: &SMatrix<T, N, N>,
    entries: &[usize; D],
) -> SMatrix<T, D, D> {
    let place = |k: usize| entries.get(k).copied().unwrap_or_default();
    SMatrix::from_fn(|row, column| entry(matrix, (place(row), place(column))))
}

/// `matrix` with `block` in place of what begins at `row` and `column`.
pub(super) fn with<T: Scalar, const R: usize, const C: usize, const M: usize, const N: usize>(
    mut matrix: SMatrix<T, M, N>,
    (row, column): (usize, usize),
    block: &SMatrix<T, R, C>,
) -> SMatrix<T, M, N> {
    for i in 0..R {
        for j in 0..C {
            set(&mut matrix, (row + i, column + j), entry(block, (i, j)));
        }
    }
    matrix
}

/// The x that makes ‖a x − b‖ least, for at least as many rows as unknowns, by Householder's
/// reflections: no choice depends on the numbers. Not finite where a zero is divided by.
pub(super) fn solve<T: Scalar, const M: usize, const K: usize, const C: usize>(
    mut a: SMatrix<T, M, K>,
    mut b: SMatrix<T, M, C>,
) -> SMatrix<T, K, C> {
    let mut diagonal = [T::default(); K];
    for (k, pivot) in diagonal.iter_mut().enumerate() {
        let square = sum((k..M).map(|row| entry(&a, (row, k)) * entry(&a, (row, k))));
        let first = entry(&a, (k, k));
        *pivot = -square.sqrt().copysign(first);
        // The mirror is at right angles to v = a_k − pivot e_k, and v · v / 2 is `half`.
        let half = square - *pivot * first;
        let zero = T::default();
        let factor = T::select(half.simd_gt(zero), half.recip(), zero);
        set(&mut a, (k, k), first - *pivot);
        let mirror = block::<T, M, 1, M, K>(&a, (0, k));
        reflect(&mut a, (k, k + 1), &mirror, factor);
        reflect(&mut b, (k, 0), &mirror, factor);
    }
    let mut x = zeros::<T, K, C>();
    for column in 0..C {
        for (k, pivot) in diagonal.iter().enumerate().rev() {
            let later = (k + 1..K).map(|j| entry(&a, (k, j)) * entry(&x, (j, column)));
            let value = (entry(&b, (k, column)) - sum(later)) * pivot.recip();
            set(&mut x, (k, column), value);
        }
    }
    x
}

/// Reflects the columns of a matrix from one on, and of these the rows from one on, at the plane at
/// right angles to `mirror`; `factor` is 2 over its square.
fn reflect<T: Scalar, const M: usize, const C: usize>(
    matrix: &mut SMatrix<T, M, C>,
    (first, from): (usize, usize),
    mirror: &SMatrix<T, M, 1>,
    factor: T,
) {
    for column in from..C {
        let along = (first..M).map(|row| entry(mirror, (row, 0)) * entry(matrix, (row, column)));
        let along = sum(along) * factor;
        for row in first..M {
            let value = entry(matrix, (row, column)) - entry(mirror, (row, 0)) * along;
            set(matrix, (row, column), value);
        }
    }
}
