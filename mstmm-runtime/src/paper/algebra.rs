//! Products and equations of small matrices for any [`Scalar`]; nalgebra's own products ask for
//! more than its arithmetic.

use nalgebra::{Matrix3, SMatrix, Vector3};

use crate::Scalar;

/// A product of matrices, written between its factors.
pub(super) trait Times<const K: usize, const C: usize, T> {
    /// What has as many rows as `self` and as many columns as `right`.
    type Product;

    /// `self` times `right`.
    fn times(&self, right: &SMatrix<T, K, C>) -> Self::Product;
}

impl<T: Scalar, const R: usize, const K: usize, const C: usize> Times<K, C, T>
    for SMatrix<T, R, K>
{
    type Product = SMatrix<T, R, C>;

    #[inline]
    fn times(&self, right: &SMatrix<T, K, C>) -> SMatrix<T, R, C> {
        SMatrix::from_fn(|row, column| sum((0..K).map(|k| self[(row, k)] * right[(k, column)])))
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
    SMatrix::from_fn(|i, j| matrix[(row + i, column + j)])
}

/// `matrix` with `block` in place of what begins at `row` and `column`.
pub(super) fn with<T: Scalar, const R: usize, const C: usize, const M: usize, const N: usize>(
    mut matrix: SMatrix<T, M, N>,
    (row, column): (usize, usize),
    block: &SMatrix<T, R, C>,
) -> SMatrix<T, M, N> {
    for i in 0..R {
        for j in 0..C {
            matrix[(row + i, column + j)] = block[(i, j)];
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
    let zero = T::default();
    let mut diagonal = [zero; K];
    for (k, pivot) in diagonal.iter_mut().enumerate() {
        let square = sum((k..M).map(|row| a[(row, k)] * a[(row, k)]));
        *pivot = -square.sqrt().copysign(a[(k, k)]);
        // The mirror is at right angles to v = a_k − pivot e_k, and v · v / 2 is `half`.
        let half = square - *pivot * a[(k, k)];
        let factor = T::select(half.greater(zero), half.recip(), zero);
        a[(k, k)] -= *pivot;
        for column in k + 1..K {
            let along = sum((k..M).map(|row| a[(row, k)] * a[(row, column)])) * factor;
            for row in k..M {
                let part = a[(row, k)] * along;
                a[(row, column)] -= part;
            }
        }
        for column in 0..C {
            let along = sum((k..M).map(|row| a[(row, k)] * b[(row, column)])) * factor;
            for row in k..M {
                let part = a[(row, k)] * along;
                b[(row, column)] -= part;
            }
        }
    }
    let mut x = zeros::<T, K, C>();
    for column in 0..C {
        for k in (0..K).rev() {
            let known = sum((k + 1..K).map(|later| a[(k, later)] * x[(later, column)]));
            x[(k, column)] = (b[(k, column)] - known) * diagonal[k].recip();
        }
    }
    x
}
