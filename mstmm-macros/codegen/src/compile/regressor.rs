//! The functions of the regressor.

use super::compiler::{ChainCompiler, Traced};
use super::{layouts, outputs};
use crate::equations::{self, AXES};
use crate::expr::{Expr, Stage};
use crate::function::{Function, Output, Written};
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
