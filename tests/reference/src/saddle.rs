//! Dense saddle-point systems, also with redundant constraints.
//!
//! ```text
//! H x - Cᵀ λ = loads
//! C x        = demands
//! ```

use crate::double_double::DoubleDouble;
use nalgebra::{DMatrix, DVector, Dyn, LU};

/// Singular values of the constraints below this count as zero, relative to the largest.
const RANK_TOLERANCE: f64 = 1e-9;
/// The largest relative inconsistency of demands on redundant constraints.
const CONTRADICTION: f64 = 1e-6;

/// The largest number of refinements.
const REFINEMENTS: usize = 8;
/// A refinement below this is the last one, relative to the solution.
const REFINED: f64 = 1e-17;

/// The factorised system matrix, for any right-hand sides.
pub(crate) struct Saddle {
    /// The entries of the matrix that are not zero, column by column: the row and the entry.
    columns: Vec<Vec<(usize, f64)>>,
    factors: LU<f64, Dyn, Dyn>,
    unknowns: usize,
    /// An orthonormal basis, in columns, of the range of the constraints, if they are redundant.
    basis: Option<DMatrix<f64>>,
}

impl Saddle {
    /// Factorises a system. With `may_be_redundant`, dependent rows of the constraints are found, and
    /// the solution has the multipliers of least norm.
    pub(crate) fn new(
        inertia: &DMatrix<f64>,
        constraints: &DMatrix<f64>,
        may_be_redundant: bool,
    ) -> Saddle {
        let basis = if may_be_redundant { basis_of_redundant(constraints) } else { None };
        let independent = match &basis {
            Some(basis) => basis.transpose() * constraints,
            None => constraints.clone(),
        };
        let (unknowns, rows) = (inertia.nrows(), independent.nrows());
        let mut matrix = DMatrix::zeros(unknowns + rows, unknowns + rows);
        matrix.view_mut((0, 0), (unknowns, unknowns)).copy_from(inertia);
        matrix.view_mut((0, unknowns), (unknowns, rows)).copy_from(&-independent.transpose());
        matrix.view_mut((unknowns, 0), (rows, unknowns)).copy_from(&independent);
        let entries = |column: usize| {
            let rows = matrix.column(column);
            let entries = rows.iter().copied().enumerate().filter(|(_, entry)| *entry != 0.0);
            entries.collect()
        };
        let columns = (0..matrix.ncols()).map(entries).collect();
        Saddle { columns, factors: matrix.lu(), unknowns, basis }
    }

    /// Returns whether every multiplier is determined.
    pub(crate) fn multipliers_are_unique(&self) -> bool {
        self.basis.is_none()
    }

    /// Solves the system and returns the unknowns and the multipliers.
    ///
    /// # Panics
    ///
    /// Panics if the system is singular, or if redundant constraints contradict each other.
    pub(crate) fn solve(
        &self,
        loads: &DVector<f64>,
        demands: &DVector<f64>,
    ) -> (DVector<f64>, DVector<f64>) {
        let independent = match &self.basis {
            Some(basis) => {
                let independent = basis.transpose() * demands;
                let left_over = (demands - basis * &independent).norm();
                let allowed = CONTRADICTION * (1.0 + demands.norm());
                assert!(left_over <= allowed, "the hinges demand what they cannot: {left_over:e}");
                independent
            }
            None => demands.clone(),
        };
        let (unknowns, rows) = (self.unknowns, independent.len());
        let mut right = DVector::zeros(unknowns + rows);
        right.rows_mut(0, unknowns).copy_from(loads);
        right.rows_mut(unknowns, rows).copy_from(&independent);
        let solution = self.refined(&right);
        let multipliers = solution.rows(unknowns, rows).into_owned();
        let multipliers = match &self.basis {
            Some(basis) => basis * multipliers,
            None => multipliers,
        };
        (solution.rows(0, unknowns).into_owned(), multipliers)
    }

    /// Solves the system to full precision: the residuals of the refinements have twice the digits of
    /// the matrix, so that elimination without scaling loses none.
    fn refined(&self, right: &DVector<f64>) -> DVector<f64> {
        let rounded = |all: &[DoubleDouble]| {
            DVector::from_iterator(all.len(), all.iter().map(|number| number.high))
        };
        let mut solution = vec![DoubleDouble::default(); right.len()];
        for _ in 0..REFINEMENTS {
            let mut residual: Vec<_> = right.iter().map(|it| DoubleDouble::new(*it)).collect();
            for (column, number) in self.columns.iter().zip(&solution) {
                for (row, entry) in column {
                    residual[*row] -= DoubleDouble::new(*entry) * *number;
                }
            }
            let change = self.back_substitute(&rounded(&residual));
            for (number, change) in solution.iter_mut().zip(change.iter()) {
                *number += DoubleDouble::new(*change);
            }
            if change.norm() <= REFINED * rounded(&solution).norm() {
                break;
            }
        }
        rounded(&solution)
    }

    fn back_substitute(&self, right: &DVector<f64>) -> DVector<f64> {
        let solution = self.factors.solve(right);
        solution.expect("bodies with mass and inertia have a regular system")
    }
}

/// Returns an orthonormal basis of the range of the constraints, if their rows are dependent.
fn basis_of_redundant(constraints: &DMatrix<f64>) -> Option<DMatrix<f64>> {
    let decomposed = constraints.clone().svd(true, false);
    let greatest = decomposed.singular_values.max();
    let counts = |k: &usize| decomposed.singular_values[*k] > RANK_TOLERANCE * greatest;
    let kept: Vec<usize> = (0..decomposed.singular_values.len()).filter(counts).collect();
    if kept.len() == constraints.nrows() {
        return None;
    }
    decomposed.u.map(|u| u.select_columns(&kept))
}
