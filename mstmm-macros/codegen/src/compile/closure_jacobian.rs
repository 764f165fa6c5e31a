//! The function for the product of a closed chain's constraint Jacobian with a vector.

use super::compiler::{ChainCompiler, Traced};
use super::outputs;
use crate::equations;
use crate::expr::Expr;
use crate::function::Function;
use crate::program::Given;

impl<'a> ChainCompiler<'a> {
    pub(super) fn closure_jacobian_times(&self) -> Traced<'a> {
        let given = self.given(Given::Vector);
        let (gap, function) = self.traced(|tracer, trace| {
            let context = self.context(self.merged).with_loops(tracer);
            let gap = equations::closure_jacobian_times(&context, &given);
            let Some(gap) = gap else { bug!("an open chain has no constraint Jacobian") };
            trace.section("closure", "Velocity across the open closing hinge", "");
            trace.motion("gap", gap);
            gap
        });
        let axes = self.chain.dimension.axes();
        let entries: Vec<Expr> = axes.iter().map(|&k| gap.at(k)).collect();
        let outputs = vec![self.once(outputs::PRODUCT, &entries)];
        Function { outputs, ..function }.into()
    }
}
