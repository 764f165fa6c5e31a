//! The functions for the derivatives of inverse dynamics and of the accelerations.

use super::compiler::{ChainCompiler, Traced};
use super::outputs;
use crate::equations::{self, AXES, DenseMatrix, InverseDynamicsTangent, leaves_out_zeros};
use crate::expr::Expr;
use crate::function::{Function, Output, Written};
use crate::math::Scalar;
use crate::program::{Given, OutputId};

impl<'a> ChainCompiler<'a> {
    pub(super) fn inverse_dynamics_derivatives(&self) -> Traced<'a> {
        let given = self.given(Given::Accelerations);
        let ([by_coordinates, by_rates, by_accelerations], function) = self.traced(|_, trace| {
            let context = self.context(self.merged).with_accelerations(&given);
            let tangent = InverseDynamicsTangent::new(&context, AXES, trace);
            let by_accelerations = tangent.by_accelerations(trace);
            [tangent.by_coordinates(trace), tangent.by_rates(trace), by_accelerations]
        });
        let outputs = vec![
            self.matrix(outputs::BY_COORDINATES, &by_coordinates),
            self.matrix(outputs::BY_RATES, &by_rates),
            self.matrix(outputs::BY_ACCELERATIONS, &by_accelerations),
        ];
        Function { outputs, ..function }.into()
    }

    pub(super) fn linearization(&self) -> Traced<'a> {
        let (found, function) = self
            .traced(|_, trace| equations::linearization(&self.context(self.merged), AXES, trace));
        let outputs = vec![
            self.rates(outputs::ACCELERATIONS, &found.accelerations),
            self.matrix(outputs::INVERSE_MASS_MATRIX, &found.inverse),
            self.factor(outputs::BY_COORDINATES, &found.by_coordinates),
            self.factor(outputs::BY_RATES, &found.by_rates),
            self.matrix(outputs::BY_INPUTS, &found.by_inputs),
            self.factor(outputs::BY_PARAMETERS, &found.by_parameters),
        ];
        Function { outputs, pivots: self.pivots(&found.pivots), ..function }.into()
    }

    /// Returns the factor of a product with `−M⁻¹`. If the product leaves out entries that vanish, they are known when the
    /// factor is created.
    fn factor(&self, id: OutputId, matrix: &DenseMatrix<Expr<'a>>) -> Output {
        let output = self.matrix(id, matrix);
        let vanishing = matrix.entries().iter().filter(|entry| entry.vanishes()).count();
        match leaves_out_zeros(vanishing, output.values.len()) {
            true => Output { written: Written::ByEntryOnceIfConstant, ..output },
            false => output,
        }
    }
}
