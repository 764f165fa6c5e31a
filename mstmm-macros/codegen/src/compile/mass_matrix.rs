//! The functions for the mass matrix and its inverse, and for the Coriolis matrix.

use super::compiler::{ChainCompiler, Traced};
use super::outputs;
use crate::equations::{self, AXES, DenseMatrix};
use crate::expr::Expr;
use crate::function::{Function, Output, Written};
use crate::program::OutputId;

impl<'a> ChainCompiler<'a> {
    pub(super) fn mass_matrix(&self) -> Traced<'a> {
        let (matrix, function) =
            self.traced(|_, trace| equations::mass_matrix(&self.context(self.merged), AXES, trace));
        let outputs = vec![self.matrix(outputs::MATRIX, &matrix)];
        Function { outputs, ..function }.into()
    }

    pub(super) fn inverse_mass_matrix(&self) -> Traced<'a> {
        let ((matrix, pivots), function) = self.traced(|_, trace| {
            equations::inverse_mass_matrix(&self.context(self.merged), AXES, trace)
        });
        let outputs = vec![self.matrix(outputs::MATRIX, &matrix)];
        Function { outputs, pivots: self.pivots(&pivots), ..function }.into()
    }

    pub(super) fn coriolis_matrix(&self) -> Traced<'a> {
        let (matrix, function) = self
            .traced(|_, trace| equations::coriolis_matrix(&self.context(self.merged), AXES, trace));
        let outputs = vec![self.matrix(outputs::MATRIX, &matrix)];
        Function { outputs, ..function }.into()
    }

    /// Returns an output for a matrix, whose entries are written one by one.
    pub(super) fn matrix(&self, id: OutputId, matrix: &DenseMatrix<Expr<'a>>) -> Output {
        Output { written: Written::ByEntry, ..self.once(id, matrix.entries()) }
    }
}
