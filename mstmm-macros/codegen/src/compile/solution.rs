//! The functions for everything that `results` names.

use super::compiler::{ChainCompiler, Traced};
use super::{layouts, outputs, point_storage};
use crate::equations::{
    self, AXES, EvalContext, ForwardDynamics, SpringReport, SweepResult, Trace,
};
use crate::expr::Expr;
use crate::function::{Function, Output};

impl<'a> ChainCompiler<'a> {
    pub(super) fn solution(&self) -> Traced<'a> {
        self.with_results(None, |merged, trace| {
            equations::forward_dynamics_with_wrenches(merged, self.method(), AXES, trace)
        })
    }

    /// Returns the function for everything that `results` names, from the accelerations and wrenches that
    /// `solve` returns, where the accelerations are given if `accelerations` has them.
    pub(super) fn with_results(
        &self,
        accelerations: Option<&[Expr<'a>]>,
        solve: impl for<'b> Fn(
            &EvalContext<'b, Expr<'a>>,
            &mut Trace<Expr<'a>>,
        ) -> (ForwardDynamics<Expr<'a>>, SweepResult<Expr<'a>>),
    ) -> Traced<'a> {
        let results = self.chain.results;
        let ((solved, report, energy, springs), function) = self.traced(|tracer, trace| {
            let context_of = |layout| {
                let mut context = self.context(layout).with_loops(tracer);
                context.accelerations = accelerations;
                context
            };
            let merged = context_of(self.merged);
            let (solved, swept) = solve(&merged, trace);
            let context = context_of(self.layout);
            let report = equations::report(&context, (&solved, &swept), trace);
            let energy = results.energies.then(|| equations::energy(&context, trace));
            let springs = results.z.then(|| equations::spring_report(&merged, AXES, trace));
            (solved, report, energy, springs.unwrap_or_default())
        });
        let pivots = self.pivots(&solved.pivots);
        let (storage, numbers) =
            point_storage::allocate(self.chain, self.graph, &report, &self.numbers);
        let all_rates = || layouts::all_rates(self.chain, self.layout);
        let by_entry = |output: Output| Output { by_entry: true, ..output };
        let mut outputs = vec![self.rates(outputs::ACCELERATIONS, &solved.accelerations)];
        if self.chain.has_prescribed_hinges() {
            let id = outputs::ALL_ACCELERATIONS;
            outputs.push(self.output(id, all_rates(), &report.accelerations));
        }
        outputs.push(self.output(outputs::EFFORTS, all_rates(), &report.efforts));
        if let Some(energy) = energy {
            let energies = [energy.kinetic, energy.potential];
            outputs.push(by_entry(self.once(outputs::ENERGIES, &energies)));
        }
        if let Some(reaction) = solved.reaction {
            let wrenches = reaction.undetermined.into_iter();
            let numbers = wrenches.flat_map(|w| w.force.0.into_iter().chain(w.moment.0));
            outputs.push(self.once(outputs::UNDETERMINED, &numbers.collect::<Vec<_>>()));
        }
        let layout = layouts::numbers_of_points(self.chain, &storage);
        outputs.push(by_entry(self.output(outputs::POINT_NUMBERS, layout, &numbers)));
        let felt = |&axis: &usize| {
            if results.z { report.base_acceleration[axis] } else { Expr::Number(0.0) }
        };
        let base_acceleration: Vec<Expr> =
            self.chain.dimension.translations().iter().map(felt).collect();
        outputs.push(by_entry(self.once(outputs::BASE_ACCELERATION, &base_acceleration)));
        if !springs.is_empty() {
            outputs.push(by_entry(self.springs(&springs)));
        }
        Traced { function: Function { outputs, pivots, ..function }, storage: Some(storage) }
    }

    fn springs(&self, springs: &[SpringReport<Expr<'a>>]) -> Output {
        let translations = self.chain.dimension.translations();
        let of_spring = |spring: &SpringReport<Expr<'a>>| {
            let force = translations.iter().map(|&axis| spring.force[axis]);
            [spring.length, spring.length_rate, spring.tension].into_iter().chain(force).collect()
        };
        let values: Vec<Vec<Expr>> = springs.iter().map(of_spring).collect();
        self.output(outputs::SPRINGS, layouts::springs(self.chain), &values.concat())
    }
}
