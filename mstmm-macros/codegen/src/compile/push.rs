//! The function for the derivative of the accelerations along a direction.

use super::compiler::{ChainCompiler, Traced};
use super::outputs;
use crate::equations::{self, AXES, Direction};
use crate::expr::Expr;
use crate::function::{Function, share_carries};
use crate::program::Given;

impl<'a> ChainCompiler<'a> {
    pub(super) fn push(&self) -> Traced<'a> {
        let direction: Direction<Expr<'a>> = Direction {
            coordinates: self.given(Given::CoordinateDirection),
            rates: self.given(Given::RateDirection),
            accelerations: Vec::new(),
            inputs: self.given(Given::InputDirection),
            parameters: self.given(Given::ParameterDirection),
        };
        let (pushed, function) = self.traced(|tracer, trace| {
            let context = self.context(self.merged).with_loops(tracer);
            equations::push(&context, &direction, AXES, trace)
        });
        let outputs = vec![
            self.rates(outputs::ACCELERATIONS, &pushed.accelerations),
            self.rates(outputs::CHANGE, &pushed.change),
        ];
        share_carries(Function { outputs, pivots: self.pivots(&pushed.pivots), ..function }).into()
    }
}
