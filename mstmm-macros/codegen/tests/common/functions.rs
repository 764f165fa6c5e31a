//! Functions that are built by hand, with loops, and their evaluation.

use super::formulas::NUMBERS;
use super::interpreter::Judge;
use super::slots::computed;
use mstmm_codegen::expr::{Edge, Expr, Graph, Stage};
use mstmm_codegen::function::{Carry, Function, Loop, Output, Unknowns, Written};
use mstmm_codegen::ids::{RepeatId, SymbolId};
use mstmm_codegen::math::Scalar;
use mstmm_codegen::passes::{
    Checks, SetupSlots, drop_unused_carries, factor, fuse_loops, linearize, lower, reassociate,
};
use mstmm_codegen::program::{Argument, ArrayLayout, Failure};
use std::collections::HashMap;

/// The values of all arguments.
pub type Values<S> = HashMap<Argument, Vec<S>>;

/// Returns the symbol of an unknown or of a carried value.
pub fn symbol(graph: &Graph, number: usize) -> Expr<'_> {
    graph.symbol(SymbolId(number), Stage::State)
}

/// Returns a function without loops and results.
pub fn empty<'g>(graph: &'g Graph, unknowns: &'g Unknowns) -> Function<'g> {
    let (stage, headings, pivots) = (Stage::State, Vec::new(), Vec::new());
    let (loops, outputs) = (Vec::new(), Vec::new());
    Function { graph, unknowns, stage, headings, loops, loops_before_factor: 0, outputs, pivots }
}

/// Returns the function with these results, each with its part.
pub fn returning<'g>(function: Function<'g>, results: &[(Edge, Option<RepeatId>)]) -> Function<'g> {
    let repetitions = |part| (part, function.unknowns.repetitions(part));
    let item = |part: Option<RepeatId>| (1, part.map(repetitions));
    let layout = ArrayLayout::of(results.iter().map(|&(_, part)| item(part)));
    let values = results.iter().map(|&(edge, _)| edge).collect();
    let outputs = vec![Output { id: NUMBERS, layout, values, written: Written::Together }];
    Function { outputs, pivots: Vec::new(), ..function }
}

/// Returns the indices in an array of an entry in all repetitions.
pub fn places(layout: &ArrayLayout, entry: usize) -> impl Iterator<Item = usize> {
    let it = *layout.segment_of(entry);
    (0..it.repetitions).map(move |repetition| it.offset + repetition * it.count + entry - it.first)
}

/// Returns the values of an unknown in all repetitions.
pub fn values_of<S: Scalar>(unknowns: &Unknowns, symbol: SymbolId, values: &Values<S>) -> Vec<S> {
    let unknown = unknowns.get(symbol).expect("an unknown");
    let array = &values[&unknown.argument];
    places(&unknowns.layout(unknown.argument), unknown.entry).map(|place| array[place]).collect()
}

/// Two symbols of random functions with loops that are outside of parts.
pub const ONCE: [usize; 2] = [2, 3];
/// Two symbols of the first part, which has three repetitions.
pub const OF_PART: [usize; 2] = [4, 5];

/// Adds a loop over the first part that carries values from `init` to `next`, and returns the values after the last
/// repetition.
pub fn looping<'g, const N: usize>(
    function: &mut Function<'g>,
    inward: bool,
    init: [Expr<'g>; N],
    next: impl Fn([Expr<'g>; N]) -> [Expr<'g>; N],
) -> [Expr<'g>; N] {
    let graph = function.graph;
    let carries = function.loops.iter().map(|loop_| loop_.carries.len());
    let first = function.unknowns.count() + 2 * carries.sum::<usize>();
    let [phi, exit] =
        [0, 1].map(|part| std::array::from_fn(|k| symbol(graph, first + 2 * k + part)));
    let pairs = init.into_iter().zip(next(phi)).enumerate();
    let carry = |(k, (init, next)): (usize, (Expr<'g>, Expr<'g>))| {
        let [phi, exit] = [0, 1].map(|part| SymbolId(first + 2 * k + part));
        Carry { init: graph.edge(init), next: graph.edge(next), phi, exit }
    };
    let carries = pairs.map(carry).collect();
    function.loops.push(Loop { repeat: RepeatId(0), inward, carries });
    exit
}

/// Evaluates a function by the procedure that the passes make of it.
pub fn through_passes<S: Judge>(function: &Function, values: &Values<S>) -> Vec<S> {
    let function = reassociate(fuse_loops(factor(drop_unused_carries(function.clone()))));
    let mut setup = SetupSlots::default();
    let program = linearize(&function, &mut setup);
    let checks = Checks { finite: &[NUMBERS], failure: Failure::Untouched, unread: true };
    let procedure = lower(program, &function, Some(checks), &setup);
    computed(&function, (&procedure, &setup), values).expect("finite results")
}
