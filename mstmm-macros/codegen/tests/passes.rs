//! Tests that every pass preserves the results of a function, on random functions with loops, parameters and pivots.

mod common;

use common::difference;
use common::formulas::{NUMBERS, evaluated, random_function, random_values, unknowns};
use common::interpreter::Failed;
use common::slots::computed;
use mstmm_codegen::expr::Graph;
use mstmm_codegen::function::Function;
use mstmm_codegen::passes::{
    Checks, SetupSlots, choose_signs, drop_unused_carries, early_stores, factor, fuse_loops,
    linearize, list_schedule, lower, negate, reassociate, separate_factor,
};
use mstmm_codegen::program::{Failure, Operand, Procedure, Program, Statement, Step};
use mstmm_reference::Random;

type Pass = for<'g> fn(Function<'g>) -> Function<'g>;

/// The rounding error of a few dozen operations on values of up to some thousands.
const ROUNDED: f64 = 1e-12;

/// Each pass, with the largest change of values that it may cause.
const PASSES: [(&str, Pass, f64); 5] = [
    ("drop_unused_carries", drop_unused_carries, 0.0),
    ("factor", factor, ROUNDED),
    ("fuse_loops", fuse_loops, 0.0),
    ("reassociate", reassociate, ROUNDED),
    ("separate_factor", separate_factor, 0.0),
];

/// Compares results; if a pivot vanishes, it must vanish for the same hinge.
fn same(one: &Result<Vec<f64>, Failed>, other: &Result<Vec<f64>, Failed>, most: f64) -> bool {
    match (one, other) {
        (Ok(one), Ok(other)) => difference(one, other) <= most,
        (one, other) => one == other,
    }
}

fn lowered(
    program: Program,
    function: &Function,
    setup: &SetupSlots,
    failure: Failure,
) -> Procedure {
    lower(program, function, Some(Checks { finite: &[NUMBERS], failure, unread: true }), setup)
}

/// Returns the number of negated operands of a procedure.
fn negations(procedure: &Procedure) -> usize {
    let of_step = |step: &Step| match step {
        Step::Compute(section) => {
            let operands = section.statements.iter().flat_map(Statement::operands);
            operands.filter(|operand| matches!(operand, Operand::Minus(_))).count()
        }
        Step::Store { values, .. } => {
            values.iter().flatten().filter(|operand| matches!(operand, Operand::Minus(_))).count()
        }
        _ => 0,
    };
    let in_loops = |step: &Step| match step {
        Step::Loop(loop_) => loop_.body.iter().map(of_step).sum(),
        _ => of_step(step),
    };
    procedure.body.iter().map(in_loops).sum()
}

/// Compares a function after every pass, down to the procedure. Returns whether it has results. Adds to `saved` the
/// negations that signs save, and all negations before.
fn one_function(seed: u64, looped: bool, saved: &mut (usize, usize)) -> bool {
    let mut random = Random::new(seed);
    let graph = Graph::default();
    let unknowns = unknowns(looped);
    let mut function = random_function(&mut random, &graph, &unknowns);
    let values = random_values(&mut random, &unknowns);
    let mut before = evaluated(&function, &values);
    for (name, pass, most) in PASSES {
        function = pass(function);
        let after = evaluated(&function, &values);
        assert!(same(&after, &before, most), "seed {seed}, {name}: {before:?}, now {after:?}");
        before = after;
    }
    let mut setup = SetupSlots::default();
    let program = linearize(&function, &mut setup);
    for failure in [Failure::Untouched, Failure::Reset] {
        let check = |name: &str, procedure: &Procedure| {
            let after = computed(&function, (procedure, &setup), &values);
            let what = format!("seed {seed}, {failure:?}, {name}: {before:?}, now {after:?}");
            assert!(same(&after, &before, 0.0), "{what}");
        };
        let linear = lowered(program.clone(), &function, &setup, failure);
        check("linearize", &linear);
        check("early_stores", &early_stores(linear));
        let scheduled = lowered(list_schedule(program.clone()), &function, &setup, failure);
        check("list_schedule", &scheduled);
        let stored = early_stores(scheduled);
        check("early_stores of list_schedule", &stored);
        let some = (0..stored.values.count()).map(|_| random.chance(0.5)).collect();
        check("negate", &negate(stored.clone(), some));
        let signed = choose_signs(stored.clone());
        check("choose_signs", &signed);
        let [before, after] = [&stored, &signed].map(negations);
        assert!(after <= before, "seed {seed}: {before} negations, now {after}");
        saved.0 += before - after;
        saved.1 += before;
    }
    before.is_ok()
}

#[test]
fn functions_with_loops() {
    let mut saved = (0, 0);
    let done = (0..1500).filter(|&seed| one_function(seed, true, &mut saved)).count();
    assert!(done > 750, "{done}");
    println!("signs save {} of {} negations", saved.0, saved.1);
    assert!(4 * saved.0 > saved.1, "{saved:?}");
}

#[test]
fn functions_without_loops() {
    let mut saved = (0, 0);
    let done = (0..1000).filter(|&seed| one_function(seed, false, &mut saved)).count();
    assert!(done > 500, "{done}");
    println!("signs save {} of {} negations", saved.0, saved.1);
    assert!(4 * saved.0 > saved.1, "{saved:?}");
}
