//! Traces a chain's equations: runs them on formulas.

use super::point_storage::PointStorage;
use super::{layouts, outputs};
use crate::equations::{self, AXES, EvalContext, HingePivot, SymbolValues, Trace};
use crate::examine::Findings;
use crate::expr::{Edge, Expr, Graph, Stage};
use crate::function::{Function, Heading, LoopTracer, NamedPivot, Output, Unknowns, Written};
use crate::math::PIVOT_ULPS;
use crate::model::{Chain, Check, ClosureRank, Hinge, HingeKind, Layout, SolutionMethod, Value};
use crate::passes::SetupSlots;
use crate::program::{Argument, ArrayLayout, OutputId};

/// A traced function, and the storage of connection points if the function computes them.
pub(super) struct Traced<'g> {
    /// The function.
    pub function: Function<'g>,
    /// The storage of connection points.
    pub storage: Option<PointStorage>,
}

impl<'g> From<Function<'g>> for Traced<'g> {
    fn from(function: Function<'g>) -> Self {
        Traced { function, storage: None }
    }
}

/// A chain with a symbolic state.
pub(super) struct ChainCompiler<'a> {
    pub(super) chain: &'a Chain,
    pub(super) findings: &'a Findings,
    pub(super) layout: &'a Layout,
    /// The layout with welded bodies merged, whose hinges have the same ids.
    pub(super) merged: &'a Layout,
    pub(super) unknowns: &'a Unknowns,
    pub(super) graph: &'a Graph,
    pub(super) numbers: SymbolValues<Expr<'a>>,
    pub(super) q: Vec<Expr<'a>>,
    pub(super) v: Vec<Expr<'a>>,
    pub(super) inputs: Vec<Expr<'a>>,
    step: Expr<'a>,
}

impl<'a> ChainCompiler<'a> {
    pub(super) fn new(
        (chain, findings): (&'a Chain, &'a Findings),
        (layout, merged): (&'a Layout, &'a Layout),
        unknowns: &'a Unknowns,
        graph: &'a Graph,
    ) -> Self {
        let symbols = |argument, stage| symbols(unknowns, graph, (argument, stage));
        let parameters = chain.parameters.ids().into_iter();
        let inputs = layout.inputs.ids().into_iter();
        ChainCompiler {
            chain,
            findings,
            layout,
            merged,
            unknowns,
            graph,
            numbers: SymbolValues {
                parameters: parameters
                    .flat_map(|parameter| symbols(Argument::Parameter(parameter), Stage::Setup))
                    .collect(),
                constants: symbols(Argument::Constants, Stage::Setup),
                closure_steps: symbols(Argument::ClosureSteps, Stage::Setup),
            },
            q: symbols(Argument::Coordinates, Stage::State),
            v: symbols(Argument::Rates, Stage::State),
            inputs: inputs.flat_map(|it| symbols(Argument::Input(it), Stage::State)).collect(),
            step: symbols(Argument::Step, Stage::State)[0],
        }
    }

    /// Returns the symbols of an argument of all evaluations.
    pub(super) fn symbols(&self, argument: Argument) -> Vec<Expr<'a>> {
        symbols(self.unknowns, self.graph, (argument, Stage::State))
    }

    pub(super) fn context<'b>(&'b self, layout: &'b Layout) -> EvalContext<'b, Expr<'a>> {
        self.context_with(layout, &self.numbers)
    }

    fn context_with<'b>(
        &'b self,
        layout: &'b Layout,
        numbers: &'b SymbolValues<Expr<'a>>,
    ) -> EvalContext<'b, Expr<'a>> {
        let &Findings { held_by_closure, closure_rank, .. } = self.findings;
        let state = (&self.q[..], &self.v[..], &self.inputs[..]);
        EvalContext::new(self.chain, layout, numbers, state)
            .with_closure(held_by_closure, closure_rank)
    }

    /// Returns the unknowns of the chain's functions.
    pub(super) fn unknowns(&self) -> &'a Unknowns {
        self.unknowns
    }

    /// Returns the method for the accelerations.
    pub(super) fn method(&self) -> SolutionMethod {
        self.chain.method.unwrap_or(SolutionMethod::Riccati)
    }

    /// Runs equations with repeated parts as loops; returns their result and a function without outputs.
    pub(super) fn traced<R>(
        &self,
        equations: impl Fn(&LoopTracer<'a>, &mut Trace<Expr<'a>>) -> R,
    ) -> (R, Function<'a>) {
        let tracer = LoopTracer::new(self.graph, self.unknowns.count());
        let ((result, trace), loops) = tracer.trace(|tracer| {
            let mut trace = Trace::new();
            let result = equations(tracer, &mut trace);
            (result, trace)
        });
        let headings = trace.sections.iter().map(heading).collect();
        (result, Function { loops, headings, ..self.function(Stage::State) })
    }

    pub(super) fn function(&self, stage: Stage) -> Function<'a> {
        Function {
            graph: self.graph,
            unknowns: self.unknowns,
            stage,
            headings: Vec::new(),
            loops: Vec::new(),
            loops_before_factor: 0,
            outputs: Vec::new(),
            pivots: Vec::new(),
        }
    }

    pub(super) fn output(&self, id: OutputId, layout: ArrayLayout, values: &[Expr<'a>]) -> Output {
        let values = values.iter().map(|&value| self.graph.edge(value)).collect();
        Output { id, layout, values, written: Written::Together }
    }

    /// Returns an output outside of repeated parts.
    pub(super) fn once(&self, id: OutputId, values: &[Expr<'a>]) -> Output {
        self.output(id, ArrayLayout::once(values.len()), values)
    }

    fn coordinates(&self, id: OutputId, values: &[Expr<'a>]) -> Output {
        let layout = layouts::coordinates(self.chain, self.layout);
        self.output(id, layout, values)
    }

    pub(super) fn rates(&self, id: OutputId, values: &[Expr<'a>]) -> Output {
        self.output(id, layouts::rates(self.chain, self.layout), values)
    }

    /// Returns the pivots that are not known to be positive.
    pub(super) fn pivots(&self, pivots: &[HingePivot<Expr<'a>>]) -> Vec<NamedPivot> {
        let unsure = pivots.iter().filter(|pivot| !is_positive(pivot));
        let pivot = |pivot: &HingePivot<Expr<'a>>| {
            let hinge = self.merged.links[pivot.link].hinge;
            NamedPivot {
                hinge: self.chain.hinges[hinge].path.clone(),
                value: self.graph.edge(pivot.value),
                scale: self.graph.edge(pivot.scale),
            }
        };
        unsure.map(pivot).collect()
    }

    pub(super) fn accelerations(&self) -> Traced<'a> {
        self.solved(|context| context)
    }

    pub(super) fn implicit_accelerations(&self) -> Traced<'a> {
        self.solved(|context| context.with_implicit_step(self.step))
    }

    fn solved(
        &self,
        set: impl for<'b> Fn(EvalContext<'b, Expr<'a>>) -> EvalContext<'b, Expr<'a>>,
    ) -> Traced<'a> {
        let (solved, function) = self.traced(|tracer, trace| {
            let context = set(self.context(self.merged)).with_loops(tracer);
            equations::forward_dynamics(&context, self.method(), AXES, trace)
        });
        let outputs = vec![self.rates(outputs::ACCELERATIONS, &solved.accelerations)];
        Function { outputs, pivots: self.pivots(&solved.pivots), ..function }.into()
    }

    pub(super) fn energy(&self) -> Traced<'a> {
        let (energy, function) = self.traced(|tracer, trace| {
            equations::energy(&self.context(self.layout).with_loops(tracer), trace)
        });
        let outputs = vec![self.once(outputs::ENERGIES, &[energy.kinetic, energy.potential])];
        Function { outputs, ..function }.into()
    }

    pub(super) fn coordinate_rates(&self) -> Traced<'a> {
        let map = equations::hinge::coordinate_rates;
        self.of_hinges(outputs::COORDINATE_RATES, map)
    }

    pub(super) fn normalized(&self) -> Traced<'a> {
        self.of_hinges(outputs::COORDINATES, |kind, q, _| equations::hinge::normalized(kind, q))
    }

    /// Returns the function that maps coordinates and rates of each hinge to values in the layout of the coordinates.
    fn of_hinges(
        &self,
        id: OutputId,
        map: impl Fn(&HingeKind, &[Expr<'a>], &[Expr<'a>]) -> Vec<Expr<'a>>,
    ) -> Traced<'a> {
        let layout = self.layout;
        let free = self.chain.hinges.enumerate().filter(|(_, hinge)| !hinge.is_prescribed());
        let values = free.flat_map(|(index, hinge)| {
            map(&hinge.kind, &self.q[layout.q[index].clone()], &self.v[layout.v[index].clone()])
        });
        let outputs = vec![self.coordinates(id, &values.collect::<Vec<_>>())];
        Function { outputs, ..self.function(Stage::State) }.into()
    }

    pub(super) fn correction(&self) -> Traced<'a> {
        let (correction, function) = self.traced(|tracer, trace| {
            equations::project(&self.context(self.merged).with_loops(tracer), trace)
        });
        let Some(correction) = correction else {
            bug!("an open chain has no projection onto a loop closure")
        };
        let q = equations::displace(self.chain, self.layout, &self.q, &correction.coordinates);
        let v: Vec<Expr> =
            self.v.iter().zip(correction.rates).map(|(&v, change)| v + change).collect();
        let residual = [correction.residual, correction.relative, correction.excess];
        let outputs = vec![
            self.coordinates(outputs::COORDINATES, &q),
            self.rates(outputs::RATES, &v),
            self.once(outputs::RESIDUAL, &residual),
        ];
        Function { outputs, ..function }.into()
    }

    pub(super) fn closure_pivots(&self) -> Traced<'a> {
        let ClosureRank::FoundAtRunTime(directions) = self.findings.closure_rank else {
            bug!("the rank of this loop closure is not found at run time")
        };
        let numbers = SymbolValues { closure_steps: Vec::new(), ..self.numbers.clone() };
        let (solved, function) = self.traced(|tracer, trace| {
            let context = self.context_with(self.merged, &numbers).with_loops(tracer);
            equations::forward_dynamics(&context, SolutionMethod::Riccati, AXES, trace)
        });
        let Some(reaction) = solved.reaction else {
            bug!("the rank of a loop closure is to be found, and the chain is open")
        };
        // Directions that are unconstrained in every state have no pivot.
        let mut pivots = reaction.pivots;
        if pivots.len() > directions {
            bug!("a loop closure has more pivots than directions")
        }
        pivots.resize(directions, Expr::Number(0.0));
        let outputs = vec![self.once(outputs::CLOSURE_PIVOTS, &pivots)];
        Function { outputs, ..function }.into()
    }

    pub(super) fn start(&self) -> Traced<'a> {
        let values = |all: fn(&Hinge) -> &Vec<Value>| {
            let values =
                self.chain.hinges.iter().filter(|hinge| !hinge.is_prescribed()).flat_map(all);
            values.map(|value| self.numbers.scalar(value)).collect::<Vec<_>>()
        };
        let outputs = vec![
            self.coordinates(outputs::COORDINATES, &values(|hinge| &hinge.start)),
            self.rates(outputs::RATES, &values(|hinge| &hinge.start_rate)),
        ];
        Function { outputs, ..self.function(Stage::State) }.into()
    }

    /// Returns the function that derives the slots of all other functions and the values to be checked.
    pub(super) fn setup(&self, setup: &SetupSlots, checks: &[Check]) -> Function<'a> {
        let mut outputs = Vec::new();
        let mut named = Vec::new();
        let parts = self.chain.repeats.ids().into_iter().map(Some);
        for part in std::iter::once(None).chain(parts) {
            let slots = setup.values(part);
            let layout = layouts::of(self.chain, [(slots.len(), part)]);
            let values: Vec<Edge> = slots.iter().map(|(_, edge)| *edge).collect();
            outputs.push(Output {
                id: outputs::slots(part),
                layout,
                values,
                written: Written::Together,
            });
            named.extend(slots.into_iter().map(|(name, edge)| (name.to_owned(), edge)));
        }
        let checked: Vec<Expr> =
            checks.iter().map(|check| self.numbers.scalar(&check.value)).collect();
        let layout = layouts::of(self.chain, checks.iter().map(|check| (1, check.part)));
        outputs.push(self.output(outputs::CHECKED, layout, &checked));
        let heading = Heading {
            prefix: "setup".into(),
            title: "Quantities derived from parameters and constants".into(),
            source: "".into(),
            values: named,
        };
        Function { outputs, headings: vec![heading], ..self.function(Stage::Setup) }
    }
}

/// Returns the symbols of an argument that is known at a stage.
fn symbols<'g>(
    unknowns: &Unknowns,
    graph: &'g Graph,
    (argument, stage): (Argument, Stage),
) -> Vec<Expr<'g>> {
    unknowns.of(argument).into_iter().map(|symbol| graph.symbol(symbol, stage)).collect()
}

/// Converts a section of a trace to edges; known numbers need no name.
fn heading(section: &equations::TraceSection<Expr>) -> Heading {
    let formula = |(name, expr): &(String, Expr)| match expr {
        Expr::Formula(_, edge) => Some((name.clone(), *edge)),
        Expr::Number(_) => None,
    };
    Heading {
        prefix: section.prefix.as_str().into(),
        title: section.title.as_str().into(),
        source: section.source.into(),
        values: section.values.iter().filter_map(formula).collect(),
    }
}

/// Returns whether a pivot is a known number that is positive beyond rounding, so that it needs no test at run time.
fn is_positive(pivot: &HingePivot<Expr>) -> bool {
    match (pivot.value.known(), pivot.scale.known()) {
        (Some(value), Some(scale)) => value > PIVOT_ULPS * f64::EPSILON * scale,
        _ => false,
    }
}
