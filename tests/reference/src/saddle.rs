//! Dense saddle-point systems, also with redundant constraints.
//!
//! ```text
//! H x - Cᵀ λ = loads
//! C x        = demands
//! ```

use nalgebra::{DMatrix, DVector, Dyn, LU};

/// Singular values of the constraints below this count as zero, relative to the largest.
const RANK_TOLERANCE: f64 = 1e-9;
/// The largest relative inconsistency of demands on redundant constraints.
const CONTRADICTION: f64 = 1e-6;

/// The factorised system matrix, for any right-hand sides.
pub(crate) struct Saddle {
    matrix: DMatrix<f64>,
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
        let factors = matrix.clone().lu();
        Saddle { matrix, factors, unknowns, basis }
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
        let mut solution = self.back_substitute(&right);
        // One step of iterative refinement recovers the digits that elimination without scaling loses.
        let residual = &right - &self.matrix * &solution;
        solution += self.back_substitute(&residual);
        let multipliers = solution.rows(unknowns, rows).into_owned();
        let multipliers = match &self.basis {
            Some(basis) => basis * multipliers,
            None => multipliers,
        };
        (solution.rows(0, unknowns).into_owned(), multipliers)
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
