//! The functions for momentum.

use super::compiler::{ChainCompiler, Traced};
use super::{layouts, outputs};
use crate::equations;
use crate::expr::Expr;
use crate::function::Function;

impl<'a> ChainCompiler<'a> {
    pub(super) fn momentum(&self) -> Traced<'a> {
        let (found, function) = self.traced(|tracer, trace| {
            equations::momentum(&self.context(self.merged).with_loops(tracer), trace)
        });
        let translations = self.chain.dimension.translations();
        let mut values = vec![found.mass];
        values.extend(translations.iter().map(|&k| found.center_of_mass[k]));
        values.extend(self.numbers_of_column(&found.momentum));
        let outputs = vec![self.once(outputs::MOMENTUM, &values)];
        Function { outputs, ..function }.into()
    }

    pub(super) fn momentum_matrix(&self) -> Traced<'a> {
        let (columns, function) = self.traced(|tracer, trace| {
            equations::momentum_matrix(&self.context(self.merged).with_loops(tracer), trace)
        });
        let values = columns.iter().flat_map(|column| self.numbers_of_column(column));
        let values: Vec<Expr> = values.collect();
        let layout = layouts::columns(self.chain, self.layout);
        let outputs = vec![self.output(outputs::MOMENTUM, layout, &values)];
        Function { outputs, ..function }.into()
    }
}
