//! The functions of the regressor.

use super::compiler::{ChainCompiler, Traced};
use super::{layouts, outputs};
use crate::equations::{self, AXES, GivenMotion};
use crate::expr::{Expr, Stage};
use crate::function::{Function, Output, Written};
use crate::math::{Motion, Scalar};
use crate::program::Given;

impl<'a> ChainCompiler<'a> {
    pub(super) fn regressor(&self) -> Traced<'a> {
        let given = self.given(Given::Accelerations);
        let (columns, function) = self.traced(|tracer, trace| {
            let context = self.context(self.merged).with_loops(tracer).with_accelerations(&given);
            equations::regressor(&context, AXES, trace)
        });
        let entries: Vec<Expr> = columns.concat();
        let output = self.once(outputs::REGRESSOR, &entries);
        let outputs = vec![Output { written: Written::ByEntry, ..output }];
        Function { outputs, ..function }.into()
    }

    pub(super) fn regressor_motions(&self) -> Traced<'a> {
        let given = self.given(Given::Accelerations);
        let (found, function) = self.traced(|tracer, trace| {
            let context = self.context(self.merged).with_loops(tracer).with_accelerations(&given);
            equations::regressor_motions(&context, AXES, trace)
        });
        let motions = found.bodies.iter().flat_map(|body| {
            let GivenMotion { position, rotation, omega, acceleration } = body;
            let Motion { linear, angular } = acceleration;
            let [x, y, z] = rotation.0;
            [position.0, x, y, z, omega.0, linear.0, angular.0].concat()
        });
        let padded = layouts::padded_rates(self.layout);
        let columns = (0..6).flat_map(|row| {
            let entries = found.columns.iter().map(move |column| column.at(row));
            entries.chain(std::iter::repeat(Expr::zero())).take(padded)
        });
        let by_entry = |id, values: Vec<Expr<'a>>| Output {
            written: Written::ByEntryOnceIfConstant,
            ..self.once(id, &values)
        };
        let outputs = vec![
            by_entry(outputs::MOTIONS, motions.collect()),
            by_entry(outputs::COLUMNS, columns.collect()),
            by_entry(outputs::PASSIVE, found.passive),
        ];
        Function { outputs, ..function }.into()
    }

    pub(super) fn regressor_times(&self) -> Traced<'a> {
        let [given, values] =
            [Given::Accelerations, Given::DynamicParameters].map(|given| self.given(given));
        let (product, function) = self.traced(|tracer, trace| {
            let context = self.context(self.merged).with_loops(tracer).with_accelerations(&given);
            equations::regressor_times(&context, &values, AXES, trace)
        });
        let outputs = vec![self.rates(outputs::PRODUCT, &product)];
        Function { outputs, ..function }.into()
    }

    pub(super) fn dynamic_parameters(&self) -> Traced<'a> {
        let values = equations::dynamic_parameters(&self.context(self.merged));
        let layout = layouts::dynamic_parameters(self.chain);
        let outputs = vec![self.output(outputs::DYNAMIC_PARAMETERS, layout, &values)];
        Function { outputs, ..self.function(Stage::State) }.into()
    }
}
