//! Tests that every pass preserves the results of a function, on random functions with loops, parameters and pivots.

mod common;

use common::difference;
use common::formulas::{NUMBERS, evaluated, random_function, random_values, unknowns};
use common::interpreter::{Arrays, Failed, run};
use mstmm_codegen::expr::{Graph, Stage};
use mstmm_codegen::function::{Function, Output, Written};
use mstmm_codegen::ids::RepeatId;
use mstmm_codegen::passes::{
    Checks, SetupSlots, drop_unused_carries, early_stores, factor, fuse_loops, linearize,
    list_schedule, lower, reassociate,
};
use mstmm_codegen::program::{
    Argument, ArrayLayout, ArrayRole, Failure, OutputId, Procedure, Program,
};
use mstmm_reference::Random;
use std::collections::HashMap;

type Values = HashMap<Argument, Vec<f64>>;
type Pass = for<'g> fn(Function<'g>) -> Function<'g>;

/// The rounding error of a few dozen operations on values of up to some thousands.
const ROUNDED: f64 = 1e-12;

/// Each pass, with the largest change of values that it may cause.
const PASSES: [(&str, Pass, f64); 4] = [
    ("drop_unused_carries", drop_unused_carries, 0.0),
    ("factor", factor, ROUNDED),
    ("fuse_loops", fuse_loops, 0.0),
    ("reassociate", reassociate, ROUNDED),
];

/// Compares results; if a pivot vanishes, it must vanish for the same hinge.
fn same(one: &Result<Vec<f64>, Failed>, other: &Result<Vec<f64>, Failed>, most: f64) -> bool {
    match (one, other) {
        (Ok(one), Ok(other)) => difference(one, other) <= most,
        (one, other) => one == other,
    }
}

/// Returns the function that derives the slots of another function.
fn setup_function<'g>(function: &Function<'g>, setup: &SetupSlots) -> Function<'g> {
    let parts = [None, Some(RepeatId(0)), Some(RepeatId(1))];
    let output = |part: Option<RepeatId>| {
        let values: Vec<_> = setup.values(part).into_iter().map(|(_, edge)| edge).collect();
        let repeated = part.map(|part| (part, function.unknowns.repetitions(part)));
        let layout = ArrayLayout::of([(values.len(), repeated)]);
        Output { id: OutputId { name: "slots", part }, layout, values, written: Written::Together }
    };
    Function {
        stage: Stage::Setup,
        loops: Vec::new(),
        pivots: Vec::new(),
        outputs: parts.map(output).into(),
        ..function.clone()
    }
}

/// Runs the setup and a procedure, and returns the results.
fn computed(
    function: &Function,
    (procedure, setup): (&Procedure, &SetupSlots),
    values: &Values,
) -> Result<Vec<f64>, Failed> {
    let mut arrays = Arrays { arguments: values.clone(), ..Arrays::default() };
    arrays.arguments.insert(Argument::Time, vec![0.0]);
    let derive = setup_function(function, setup);
    let program = linearize(&derive, &mut SetupSlots::default());
    let derive = lower(program, &derive, None, &SetupSlots::default());
    let mut derived = arrays.clone();
    run(&derive, &mut derived)?;
    for array in &derive.arrays {
        if let ArrayRole::Result(id) = array.role {
            arrays.arguments.insert(Argument::Slots(id.part), derived.result(id));
        }
    }
    run(procedure, &mut arrays).map(|()| arrays.result(NUMBERS))
}

fn lowered(
    program: Program,
    function: &Function,
    setup: &SetupSlots,
    failure: Failure,
) -> Procedure {
    lower(program, function, Some(Checks { finite: NUMBERS, failure }), setup)
}

/// Compares a function after every pass, down to the procedure. Returns whether it has results.
fn one_function(seed: u64, looped: bool) -> bool {
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
        check("early_stores of list_schedule", &early_stores(scheduled));
    }
    before.is_ok()
}

#[test]
fn functions_with_loops() {
    let done = (0..1500).filter(|&seed| one_function(seed, true)).count();
    assert!(done > 750, "{done}");
}

#[test]
fn functions_without_loops() {
    let done = (0..1000).filter(|&seed| one_function(seed, false)).count();
    assert!(done > 500, "{done}");
}
