//! The function for the derivative of the accelerations along a direction.

use super::compiler::{ChainCompiler, Traced};
use super::outputs;
use crate::equations::{self, AXES, Direction};
use crate::expr::Expr;
use crate::function::{Function, share_carries};
use crate::program::Given;

impl<'a> ChainCompiler<'a> {
    fn direction(&self) -> Direction<Expr<'a>> {
        Direction {
            coordinates: self.given(Given::CoordinateDirection),
            rates: self.given(Given::RateDirection),
            accelerations: Vec::new(),
            inputs: self.given(Given::InputDirection),
            parameters: self.given(Given::ParameterDirection),
        }
    }

    /// Returns the function for the change of inverse dynamics along a direction, at given accelerations.
    pub(super) fn efforts_change(&self) -> Traced<'a> {
        let (direction, given) = (self.direction(), self.given(Given::Accelerations));
        let (change, function) = self.traced(|tracer, trace| {
            let context = self.context(self.merged).with_loops(tracer).with_accelerations(&given);
            let missing = equations::missing_efforts(&context, &direction, AXES);
            trace.section("change", "Change of the efforts", "");
            missing.into_iter().map(|effort| -effort).collect::<Vec<Expr>>()
        });
        let outputs = vec![self.rates(outputs::CHANGE, &change)];
        Function { outputs, ..function }.into()
    }

    pub(super) fn push(&self) -> Traced<'a> {
        let direction = self.direction();
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
