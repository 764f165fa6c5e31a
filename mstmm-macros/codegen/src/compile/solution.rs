//! The functions for everything that `results` names: at the accelerations of forward dynamics, and at given ones. Both
//! write the same workspace.

use super::compiler::{ChainCompiler, Traced};
use super::{layouts, outputs, point_storage};
use crate::equations::{
    self, AXES, Energy, EvalContext, ForwardDynamics, Report, SpringReport, SweepResult, Trace,
};
use crate::expr::Expr;
use crate::function::{Function, Output, Written};
use crate::model::Request;
use crate::program::Given;

/// Everything that `results` names.
struct Solved<'a> {
    dynamics: ForwardDynamics<Expr<'a>>,
    report: Report<Expr<'a>>,
    energy: Option<Energy<Expr<'a>>>,
    springs: Vec<SpringReport<Expr<'a>>>,
}

impl<'a> ChainCompiler<'a> {
    pub(super) fn solution(&self) -> Traced<'a> {
        let (solved, function) = self.solved_forward();
        match self.has_inverse_solution() {
            true => self.in_workspace(0, (solved, function), vec![self.solved_inverse().0.report]),
            false => self.in_workspace(0, (solved, function), Vec::new()),
        }
    }

    pub(super) fn inverse_solution(&self) -> Traced<'a> {
        self.in_workspace(1, self.solved_inverse(), vec![self.solved_forward().0.report])
    }

    /// Returns whether the chain has the function at given accelerations. A closed chain has none.
    pub(super) fn has_inverse_solution(&self) -> bool {
        let is_open = self.layout.loop_hinges.is_empty();
        is_open && self.chain.requests.contains(&Request::InverseDynamics)
    }

    fn solved_forward(&self) -> (Solved<'a>, Function<'a>) {
        self.with_results(None, |context, trace| {
            equations::forward_dynamics_with_wrenches(context, self.method(), AXES, trace)
        })
    }

    fn solved_inverse(&self) -> (Solved<'a>, Function<'a>) {
        let given = self.given(Given::Accelerations);
        self.with_results(Some(&given), |context, trace| {
            equations::inverse_dynamics_with_wrenches(context, AXES, trace)
        })
    }

    /// Returns everything that `results` names, from the accelerations and wrenches that `solve` returns, where the
    /// accelerations are given if `accelerations` has them.
    fn with_results(
        &self,
        accelerations: Option<&[Expr<'a>]>,
        solve: impl for<'b> Fn(
            &EvalContext<'b, Expr<'a>>,
            &mut Trace<Expr<'a>>,
        ) -> (ForwardDynamics<Expr<'a>>, SweepResult<Expr<'a>>),
    ) -> (Solved<'a>, Function<'a>) {
        let results = self.chain.results;
        self.traced(|tracer, trace| {
            let context_of = |layout| {
                let mut context = self.context(layout).with_loops(tracer);
                context.accelerations = accelerations;
                context
            };
            let merged = context_of(self.merged);
            let (dynamics, swept) = solve(&merged, trace);
            let context = context_of(self.layout);
            let report = equations::report(&context, (&dynamics, &swept), trace);
            let energy = results.energies.then(|| equations::energy(&context, trace));
            let springs = results.z.then(|| equations::spring_report(&merged, AXES, trace));
            Solved { dynamics, report, energy, springs: springs.unwrap_or_default() }
        })
    }

    /// Returns the function that writes a workspace. `others` are the reports of the functions that write the same
    /// workspace; the function is number `own` among them all.
    fn in_workspace(
        &self,
        own: usize,
        (solved, function): (Solved<'a>, Function<'a>),
        others: Vec<Report<Expr<'a>>>,
    ) -> Traced<'a> {
        let Solved { dynamics, report, energy, springs } = solved;
        let pivots = self.pivots(&dynamics.pivots);
        let mut reports = others;
        reports.insert(own, report);
        let (storage, numbers) =
            point_storage::allocate(self.chain, self.graph, &reports, &self.numbers);
        let report = &reports[own];
        let all_rates = || layouts::all_rates(self.chain, self.layout);
        let written = match reports.len() {
            1 => Written::ByEntryOnceIfConstant,
            _ => Written::ByEntry,
        };
        let by_entry = |output: Output| Output { written, ..output };
        let mut outputs = vec![self.rates(outputs::ACCELERATIONS, &dynamics.accelerations)];
        if self.chain.has_prescribed_hinges() {
            let id = outputs::ALL_ACCELERATIONS;
            outputs.push(self.output(id, all_rates(), &report.accelerations));
        }
        outputs.push(self.output(outputs::EFFORTS, all_rates(), &report.efforts));
        if let Some(energy) = energy {
            let energies = [energy.kinetic, energy.potential];
            outputs.push(by_entry(self.once(outputs::ENERGIES, &energies)));
        }
        if let Some(reaction) = dynamics.reaction {
            let wrenches = reaction.undetermined.into_iter();
            let numbers = wrenches.flat_map(|w| w.force.0.into_iter().chain(w.moment.0));
            outputs.push(self.once(outputs::UNDETERMINED, &numbers.collect::<Vec<_>>()));
        }
        let layout = layouts::numbers_of_points(self.chain, &storage);
        outputs.push(by_entry(self.output(outputs::POINT_NUMBERS, layout, &numbers[own])));
        let felt = |&axis: &usize| {
            if self.chain.results.z { report.base_acceleration[axis] } else { Expr::Number(0.0) }
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
