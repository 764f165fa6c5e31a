//! Matrices of any size, by columns.

use crate::math::Scalar;

/// A matrix of any size, by columns.
#[derive(Clone, Debug, PartialEq)]
pub struct DenseMatrix<S> {
    rows: usize,
    entries: Vec<S>,
}

impl<S: Scalar> DenseMatrix<S> {
    /// Returns a matrix of zeros.
    pub fn zero(rows: usize, columns: usize) -> Self {
        DenseMatrix { rows, entries: vec![S::zero(); rows * columns] }
    }

    /// Returns entry (i, j).
    pub fn at(&self, i: usize, j: usize) -> S {
        self.entries[self.rows * j + i]
    }

    /// Sets entry (i, j).
    pub fn set(&mut self, i: usize, j: usize, value: S) {
        self.entries[self.rows * j + i] = value;
    }

    /// Sets column `j`.
    pub fn set_column(&mut self, j: usize, values: &[S]) {
        self.entries[self.rows * j..self.rows * (j + 1)].copy_from_slice(values);
    }

    /// Returns column `j`.
    pub fn column(&self, j: usize) -> &[S] {
        &self.entries[self.rows * j..self.rows * (j + 1)]
    }

    /// Returns the product with a vector.
    pub fn times(&self, vector: &[S]) -> Vec<S> {
        let row = |i: usize| {
            vector.iter().enumerate().fold(S::zero(), |sum, (j, &x)| sum + self.at(i, j) * x)
        };
        (0..self.rows).map(row).collect()
    }

    /// Returns all entries, by columns.
    pub fn entries(&self) -> &[S] {
        &self.entries
    }
}
