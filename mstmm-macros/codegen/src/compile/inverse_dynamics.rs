//! The functions of inverse dynamics.

use super::compiler::{ChainCompiler, Traced};
use super::outputs;
use crate::equations::{self, AXES, EvalContext, OpenChain, Trace};
use crate::expr::Expr;
use crate::function::Function;
use crate::program::{Argument, Given, OutputId};

/// Returns efforts in a context.
type Efforts<'a> =
    fn(&EvalContext<Expr<'a>>, equations::Axes, &mut Trace<Expr<'a>>) -> Vec<Expr<'a>>;

impl<'a> ChainCompiler<'a> {
    /// Returns a vector that the caller gives.
    pub(super) fn given(&self, given: Given) -> Vec<Expr<'a>> {
        self.symbols(Argument::Given(given))
    }

    pub(super) fn inverse_dynamics(&self) -> Traced<'a> {
        let given = self.given(Given::Accelerations);
        self.efforts(outputs::EFFORTS, Some(&given), equations::inverse_dynamics)
    }

    pub(super) fn bias_efforts(&self) -> Traced<'a> {
        self.efforts(outputs::BIAS_EFFORTS, None, equations::inverse_dynamics)
    }

    pub(super) fn gravity_efforts(&self) -> Traced<'a> {
        self.efforts(outputs::EFFORTS, None, equations::gravity_efforts)
    }

    pub(super) fn passive_efforts(&self) -> Traced<'a> {
        self.efforts(outputs::EFFORTS, None, equations::passive_efforts)
    }

    pub(super) fn mass_matrix_times(&self) -> Traced<'a> {
        let given = self.given(Given::Vector);
        self.efforts(outputs::PRODUCT, Some(&given), equations::mass_matrix_times)
    }

    pub(super) fn coriolis_matrix_times(&self) -> Traced<'a> {
        let given = self.given(Given::Vector);
        self.efforts(outputs::PRODUCT, Some(&given), equations::coriolis_matrix_times)
    }

    /// Returns the function for one effort at each rate.
    fn efforts(
        &self,
        id: OutputId,
        accelerations: Option<&[Expr<'a>]>,
        efforts: Efforts<'a>,
    ) -> Traced<'a> {
        let (efforts, function) = self.traced(|tracer, trace| {
            let mut context = self.context(self.merged).with_loops(tracer);
            context.accelerations = accelerations;
            efforts(&context, AXES, trace)
        });
        let outputs = vec![self.rates(id, &efforts)];
        Function { outputs, ..function }.into()
    }

    pub(super) fn inverse_mass_matrix_times(&self) -> Traced<'a> {
        let given = self.given(Given::Vector);
        let ((product, pivots), function) = self.traced(|tracer, trace| {
            let context = self.context(self.merged).with_loops(tracer);
            OpenChain::new(&context, AXES, trace).inverse_mass_matrix_times(&given, trace)
        });
        let outputs = vec![self.rates(outputs::PRODUCT, &product)];
        Function { outputs, pivots: self.pivots(&pivots), ..function }.into()
    }
}
