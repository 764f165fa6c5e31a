//! Tests the substitution of formulas for symbols, on random functions with loops.

mod common;

use common::difference;
use common::formulas::{evaluated, formula, random_function, random_values, unknowns};
use common::functions::{OF_PART, ONCE, Values, empty, looping, places, returning, symbol};
use mstmm_codegen::expr::{Expr, Graph};
use mstmm_codegen::function::{Function, substitute};
use mstmm_codegen::ids::SymbolId;
use mstmm_codegen::math::Scalar;
use mstmm_reference::Random;
use std::collections::HashMap;

/// Returns the values with those of a formula for one unknown in all repetitions.
fn with_formula(
    function: &Function,
    (unknown, formula): (SymbolId, Expr),
    values: &Values<f64>,
) -> Values<f64> {
    let unknowns = function.unknowns;
    let it = unknowns.get(unknown).expect("an unknown");
    let formula = returning(function.clone(), &[(function.graph.edge(formula), it.repeat)]);
    let formula = Function { loops: Vec::new(), ..formula };
    let replaced = evaluated(&formula, values).expect("a finite formula");
    let layout = unknowns.layout(it.argument);
    let mut values = values.clone();
    let array = values.get_mut(&it.argument).expect("an argument");
    for (place, value) in places(&layout, it.entry).zip(replaced) {
        array[place] = value;
    }
    values
}

#[test]
fn substituted_formulas_give_what_their_values_give() {
    let mut compared = 0;
    for seed in 0..1000 {
        let mut random = Random::new(seed);
        let (graph, unknowns) = (Graph::default(), unknowns(true));
        let mut function = random_function(&mut random, &graph, &unknowns);
        function.pivots.clear();
        // One unknown outside of parts or of the first part.
        let (replaced, kept) = *random.choose(&[(ONCE[0], ONCE[1]), (OF_PART[0], OF_PART[1])]);
        let of = [ONCE[1], kept].map(|number| symbol(&graph, number));
        let formula = match random.below(3) {
            0 => Expr::number(*random.choose(&[0.0, 1.0, -2.0])),
            _ => formula(&mut random, &of, 2),
        };
        let replaced = SymbolId(replaced);
        let values = random_values(&mut random, &unknowns);
        let instead = with_formula(&function, (replaced, formula), &values);
        let Ok(expected) = evaluated(&function, &instead) else { continue };
        let function = substitute(function, &HashMap::from([(replaced, formula)]));
        let found = evaluated(&function, &values).expect("finite results");
        // As for other passes: the rounding error of a few dozen operations on values of up to some thousands.
        let error = difference(&found, &expected);
        assert!(error <= 1e-12, "seed {seed}: {found:?}, not {expected:?}");
        compared += 1;
    }
    assert!(compared > 900, "{compared}");
}

fn substituted<'g>(function: &Function<'g>, by: &[(usize, Expr<'g>)]) -> Function<'g> {
    let formulas = by.iter().map(|&(number, formula)| (SymbolId(number), formula)).collect();
    substitute(function.clone(), &formulas)
}

#[test]
fn substituted_zeros_end_the_loops_that_they_started() {
    let (graph, unknowns) = (Graph::default(), unknowns(true));
    let [a, b] = ONCE.map(|number| symbol(&graph, number));
    let [p, q] = OF_PART.map(|number| symbol(&graph, number));
    let zero = Expr::number(0.0);
    let mut function = empty(&graph, &unknowns);
    // x is zero if b is, y if q is, too; z is not.
    let [x, y, z] = looping(&mut function, false, [zero; 3], |[x, y, z]| {
        [a * x + b * p, q * y + x * p, x + z * a + p]
    });
    let [w] = looping(&mut function, true, [x * a], |[w]| [w.sin_cos().0 + p * y]);
    let last = unknowns.count() - 1;
    let value = graph.edge(w + z + symbol(&graph, last));
    let function = returning(function, &[(value, None)]);
    let carried = |by: &[(usize, Expr)]| {
        let loops = substituted(&function, by).loops;
        loops.iter().map(|loop_| loop_.carries.len()).collect::<Vec<usize>>()
    };
    assert_eq!(carried(&[]), [3, 1]);
    assert_eq!(carried(&[(ONCE[1], zero)]), [1]);
    assert_eq!(carried(&[(ONCE[0], zero)]), [3, 1]);
    assert_eq!(carried(&[(OF_PART[0], zero)]), [0; 0]);
    assert_eq!(carried(&[(ONCE[1], a - a), (OF_PART[0], zero)]), [0; 0]);
    // A formula may read a value that is folded.
    let result = substituted(&function, &[(OF_PART[0], zero), (last, y)]).outputs[0].values[0];
    assert_eq!(graph.expr(result).known(), Some(0.0));
}
