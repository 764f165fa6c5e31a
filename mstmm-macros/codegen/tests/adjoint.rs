//! Tests the gradients of functions against dual numbers, on random functions with every kind of node, with and without
//! loops.

mod common;

use common::double_double::DoubleDouble;
use common::formulas::{evaluated, formula, random_function, random_values, unknowns};
use common::functions::{
    OF_PART, ONCE, Values, empty, looping, places, returning, symbol, through_passes, values_of,
};
use common::interpreter::Judge;
use mstmm_codegen::expr::{Edge, Expr, Graph};
use mstmm_codegen::function::{Carry, Function, Loop, Unknowns, gradient, substitute};
use mstmm_codegen::ids::{ParameterId, SymbolId};
use mstmm_codegen::math::{Dual, Scalar};
use mstmm_codegen::passes::{SetupSlots, drop_unused_carries, linearize};
use mstmm_codegen::program::{Argument, ArrayLayout};
use mstmm_reference::Random;
use std::collections::HashMap;

/// The graph folds known numbers in `f64`, so that two orders of the same operations differ by a unit in the last place of
/// `f64` for each factor that is folded, of which a formula has at most a few dozen. Everything else is computed with twice
/// that precision.
const ROUNDED: f64 = 32.0 * f64::EPSILON;

fn all_symbols(unknowns: &Unknowns) -> Vec<SymbolId> {
    (0..unknowns.count()).map(SymbolId).collect()
}

/// A gradient with its function, whose results are the value and then the derivatives.
struct Gradient<'g> {
    function: Function<'g>,
    by: Vec<SymbolId>,
}

impl<'g> Gradient<'g> {
    fn of(function: &Function<'g>, value: Edge, by: &[SymbolId]) -> Self {
        let (function, derivatives) = gradient(function.clone(), value, by);
        let unknowns = function.unknowns;
        let part = |symbol: SymbolId| unknowns.get(symbol).expect("an unknown").repeat;
        let derivatives = derivatives.iter().zip(by).map(|(&edge, &symbol)| (edge, part(symbol)));
        let results: Vec<_> = [(value, None)].into_iter().chain(derivatives).collect();
        Gradient { function: returning(function, &results), by: by.to_vec() }
    }

    /// Returns the derivative along a direction, and the sum of the magnitudes of its terms, given the results.
    fn along<S: Judge>(&self, results: &[S], direction: &Values<S>) -> (S, f64) {
        let layout = &self.function.outputs[0].layout;
        let (mut sum, mut magnitude) = (S::zero(), 0.0);
        for (entry, &symbol) in self.by.iter().enumerate() {
            let derivatives = places(layout, entry + 1).map(|place| results[place]);
            let along = values_of(self.function.unknowns, symbol, direction);
            for (derivative, along) in derivatives.zip(along) {
                sum = sum + derivative * along;
                magnitude += (derivative * along).plain().abs();
            }
        }
        (sum, magnitude)
    }
}

/// Returns random directions of some unknowns, zero for the others.
fn direction(random: &mut Random, unknowns: &Unknowns, by: &[SymbolId]) -> Values<DoubleDouble> {
    let zeros = |layout: &ArrayLayout| vec![DoubleDouble::zero(); layout.total];
    let arguments = unknowns.arguments();
    let mut all: Values<DoubleDouble> =
        arguments.map(|(argument, layout)| (argument, zeros(layout))).collect();
    for unknown in by.iter().filter_map(|&symbol| unknowns.get(symbol)) {
        let array = all.get_mut(&unknown.argument).expect("an argument");
        for place in places(&unknowns.layout(unknown.argument), unknown.entry) {
            array[place] = DoubleDouble::new(random.between(-1.0, 1.0));
        }
    }
    all
}

fn precise(values: &Values<f64>) -> Values<DoubleDouble> {
    let precise = |values: &Vec<f64>| values.iter().map(|&x| DoubleDouble::new(x)).collect();
    values.iter().map(|(&argument, values)| (argument, precise(values))).collect()
}

/// Returns the derivative of a value of a function along a direction, by dual numbers.
fn dual_derivative(
    function: &Function,
    value: Edge,
    (at, along): (&Values<DoubleDouble>, &Values<DoubleDouble>),
) -> Option<DoubleDouble> {
    let function = returning(function.clone(), &[(value, None)]);
    let join = |(&argument, at): (&Argument, &Vec<DoubleDouble>)| {
        let pairs = at.iter().zip(&along[&argument]);
        (argument, pairs.map(|(&value, &slope)| Dual::new(value, slope)).collect())
    };
    let values: Values<Dual<DoubleDouble>> = at.iter().map(join).collect();
    Some(evaluated(&function, &values).ok()?[0].derivative())
}

/// Compares the gradient of a value with dual numbers along random directions; returns whether the value is finite.
fn compare(
    random: &mut Random,
    (function, value): (&Function, Edge),
    by: &[SymbolId],
    what: &str,
) -> bool {
    let gradient = Gradient::of(function, value, by);
    let at = precise(&random_values(random, function.unknowns));
    let Ok(direct) = evaluated(&gradient.function, &at) else { return false };
    let ordered = through_passes(&gradient.function, &at);
    for results in [direct, ordered] {
        for _ in 0..3 {
            let along = direction(random, function.unknowns, by);
            let (found, magnitude) = gradient.along(&results, &along);
            let Some(expected) = dual_derivative(function, value, (&at, &along)) else {
                return false;
            };
            let error = (found - expected).plain().abs();
            assert!(error <= ROUNDED * (1.0 + magnitude), "{what}: {found:?}, not {expected:?}");
        }
    }
    true
}

/// Adds the sums of all results of repeated parts over the repetitions, and returns a value that depends on all results and
/// on everything that loops carry.
fn objective<'g>(random: &mut Random, mut function: Function<'g>) -> (Function<'g>, Edge) {
    let graph = function.graph;
    let carries = function.loops.iter().flat_map(|loop_| &loop_.carries);
    let mut terms: Vec<Expr> = carries.map(|carry| symbol(graph, carry.exit.index())).collect();
    let mut next_symbol = function.unknowns.count() + 2 * terms.len();
    let output = function.outputs.remove(0);
    for (entry, &edge) in output.values.iter().enumerate() {
        let value = graph.expr(edge);
        let Some(repeat) = output.layout.segment_of(entry).repeat else {
            terms.push(value);
            continue;
        };
        let [phi, exit] = [next_symbol, next_symbol + 1].map(SymbolId);
        let sum = symbol(graph, phi.index()) + value;
        // A formula at the start, and a known number.
        let init = if random.chance(0.5) { terms.last().copied() } else { None };
        let init = graph.edge(init.unwrap_or(Expr::number(0.0)));
        let carries = vec![Carry { init, next: graph.edge(sum), phi, exit }];
        function.loops.push(Loop { repeat, inward: random.chance(0.5), carries });
        terms.push(symbol(graph, exit.index()));
        next_symbol += 2;
    }
    let mut weighted = Expr::number(0.0);
    for term in terms {
        weighted = weighted + term * Expr::number(random.between(-1.0, 1.0));
    }
    let value = graph.edge(weighted * weighted + weighted);
    (function, value)
}

#[test]
fn gradients_of_straight_line_functions() {
    let mut compared = 0;
    for seed in 0..400 {
        let mut random = Random::new(seed);
        let (graph, unknowns) = (Graph::default(), unknowns(false));
        let of_unknown = |number| symbol(&graph, number);
        let known: Vec<Expr> = (0..unknowns.count()).map(of_unknown).collect();
        let value = graph.edge(formula(&mut random, &known, 6));
        let function = (&empty(&graph, &unknowns), value);
        let what = format!("seed {seed}");
        compared += usize::from(compare(&mut random, function, &all_symbols(&unknowns), &what));
    }
    assert!(compared > 350, "{compared}");
}

#[test]
fn gradients_of_functions_with_loops() {
    let (mut compared, mut looped) = (0, 0);
    for seed in 0..400 {
        let mut random = Random::new(seed);
        let (graph, unknowns) = (Graph::default(), unknowns(true));
        let function = random_function(&mut random, &graph, &unknowns);
        let (function, value) = objective(&mut random, function);
        // Some unknowns are held.
        let by: Vec<SymbolId> =
            all_symbols(&unknowns).into_iter().filter(|_| random.chance(0.8)).collect();
        let what = format!("seed {seed}");
        compared += usize::from(compare(&mut random, (&function, value), &by, &what));
        looped += usize::from(
            gradient(function.clone(), value, &by).0.loops.len() > function.loops.len(),
        );
    }
    assert!(compared > 350, "{compared}");
    assert!(looped > 300, "{looped}");
}

#[test]
fn derivatives_of_each_operation() {
    let (graph, unknowns) = (Graph::default(), unknowns(false));
    let [x, y] = [1, 2].map(|number| symbol(&graph, number));
    let operations = [
        x + y,
        x - y,
        x * y,
        x * x,
        x.recip(),
        (x * x).sqrt(),
        x.sin_cos().0,
        x.sin_cos().1,
        x.copysign(y),
        Scalar::abs(x),
        x.atan2(y),
        y.atan2(x * x),
        x.recip_above(y),
        (y * y).recip_above(x),
    ];
    for (number, operation) in operations.into_iter().enumerate() {
        for seed in 0..8 {
            let function = (&empty(&graph, &unknowns), graph.edge(operation));
            let what = format!("operation {number}, seed {seed}");
            let done = compare(&mut Random::new(seed), function, &all_symbols(&unknowns), &what);
            assert!(done, "{what}");
        }
    }
}

/// Returns the number of values that the loops of the gradient carry, by loop.
fn carried_by_gradient(function: &Function, value: Expr, by: &[usize]) -> Vec<usize> {
    let by: Vec<SymbolId> = by.iter().copied().map(SymbolId).collect();
    let before = function.loops.len();
    let (gradient, _) = gradient(function.clone(), function.graph.edge(value), &by);
    gradient.loops[before..].iter().map(|loop_| loop_.carries.len()).collect()
}

#[test]
fn the_gradient_of_a_recursion_is_its_closed_form() {
    for inward in [false, true] {
        let (graph, unknowns) = (Graph::default(), unknowns(true));
        let [start, factor] = ONCE.map(|number| symbol(&graph, number));
        let term = symbol(&graph, OF_PART[0]);
        let mut function = empty(&graph, &unknowns);
        let [last] = looping(&mut function, inward, [start], |[x]| [factor * x + term]);
        let by = [ONCE[0], ONCE[1], OF_PART[0]].map(SymbolId);
        let gradient = Gradient::of(&function, graph.edge(last), &by);
        // Powers of two, so that nothing is rounded.
        let (start, factor, mut terms) = (8.0, 0.5, [1.0, 2.0, -4.0]);
        let mut of_all = vec![start, factor];
        of_all.extend(terms.iter().flat_map(|&term| [term, 0.0]).chain([0.0, 0.0]));
        let of_part = Argument::Parameter(ParameterId(1));
        let shared = Argument::Parameter(ParameterId(0));
        let values = HashMap::from([
            (shared, vec![0.0]),
            (of_part, vec![0.0; 3]),
            (Argument::Coordinates, of_all),
        ]);
        let mut powers = [factor * factor, factor, 1.0];
        if inward {
            terms.reverse();
            powers.reverse();
        }
        let value = factor * (factor * (factor * start + terms[0]) + terms[1]) + terms[2];
        let by_factor = 3.0 * factor * factor * start + 2.0 * factor * terms[0] + terms[1];
        let expected = [&[value, factor * factor * factor, by_factor][..], &powers].concat();
        assert_eq!(through_passes(&gradient.function, &values), expected);
    }
}

#[test]
fn gradients_carry_only_what_changes() {
    let (graph, unknowns) = (Graph::default(), unknowns(true));
    let [a, b] = ONCE.map(|number| symbol(&graph, number));
    let [p, q] = OF_PART.map(|number| symbol(&graph, number));
    let zero = Expr::number(0.0);
    let mut function = empty(&graph, &unknowns);
    // The adjoint of a sum is the same in every repetition.
    let [sum, _] =
        looping(&mut function, false, [zero, a], |[sum, x]| [sum + p.sin_cos().0 * a, x * q]);
    assert_eq!(carried_by_gradient(&function, sum * b, &OF_PART), [0; 0]);
    assert_eq!(carried_by_gradient(&function, sum, &[ONCE[1]]), [0; 0]);
    assert_eq!(carried_by_gradient(&function, sum, &ONCE), [1]);
    // Terms that are the same in every repetition need no loop.
    let mut function = empty(&graph, &unknowns);
    let [sum] = looping(&mut function, false, [b], |[sum]| [sum + a]);
    assert_eq!(carried_by_gradient(&function, sum, &ONCE), [0; 0]);
    // Equal sums are one.
    let mut function = empty(&graph, &unknowns);
    let [sum] = looping(&mut function, false, [zero], |[sum]| [sum + p * a - q + b * p]);
    assert_eq!(carried_by_gradient(&function, sum, &ONCE), [1]);
    // The adjoint of a value that does not reach the result is zero.
    let mut function = empty(&graph, &unknowns);
    let [x, y] = looping(&mut function, true, [a, b], |[x, y]| [x * p, y * x]);
    assert_eq!(carried_by_gradient(&function, x, &OF_PART), [1]);
    assert_eq!(carried_by_gradient(&function, y, &OF_PART), [2]);
    assert_eq!(carried_by_gradient(&function, y, &ONCE[1..]), [1]);
}

/// Returns the number of operations of a function.
fn operations(function: &Function) -> usize {
    linearize(function, &mut SetupSlots::default()).cost().arithmetic()
}

#[test]
fn all_derivatives_of_a_product_cost_three_times_the_product() {
    let factors = 20;
    let mut unknowns = Unknowns::new(Vec::new().into());
    let names = (0..factors).map(|k| format!("x{k}")).collect();
    unknowns.add(Argument::Coordinates, ArrayLayout::once(factors), names);
    let graph = Graph::default();
    let product = (1..factors).fold(symbol(&graph, 0), |product, k| product * symbol(&graph, k));
    let value = graph.edge(product);
    let itself = returning(empty(&graph, &unknowns), &[(value, None)]);
    let gradient = Gradient::of(&itself, value, &all_symbols(&unknowns));
    let (one, all) = (operations(&itself), operations(&gradient.function));
    assert_eq!(one, factors - 1);
    assert!(all <= 3 * one, "{all} for {one}");
}

#[test]
fn derivatives_at_zero_fold() {
    let (graph, unknowns) = (Graph::default(), unknowns(true));
    let [a, b] = ONCE.map(|number| symbol(&graph, number));
    let [p, q] = OF_PART.map(|number| symbol(&graph, number));
    let mut function = empty(&graph, &unknowns);
    // The derivative of Σ (cos(q) p + a) by q is zero at q = 0; the square of the carried sine needs no loop.
    let [sum, square] = looping(&mut function, false, [b, Expr::number(0.0)], |[sum, square]| {
        let (sine, cosine) = q.sin_cos();
        [sum + cosine * p + a, square + sine * sine * sum]
    });
    let value = graph.edge(sum + square);
    let by = [OF_PART[1], OF_PART[0]].map(SymbolId);
    let gradient = Gradient::of(&function, value, &by);
    let zero = HashMap::from([(by[0], Expr::number(0.0))]);
    let at_zero = substitute(gradient.function, &zero);
    let results = at_zero.outputs[0].values.iter().map(|&edge| graph.expr(edge).known());
    assert_eq!(results.collect::<Vec<_>>(), [None, Some(0.0), Some(1.0)]);
    assert_eq!(drop_unused_carries(at_zero).loops.len(), 1);
}
