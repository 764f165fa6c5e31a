//! Runs the procedure of a random function after its setup, which derives the slots.

use super::formulas::NUMBERS;
use super::interpreter::{Arrays, Failed, Judge, run};
use mstmm_codegen::expr::Stage;
use mstmm_codegen::function::{Function, Output, Written};
use mstmm_codegen::ids::RepeatId;
use mstmm_codegen::passes::{SetupSlots, linearize, lower};
use mstmm_codegen::program::{Argument, ArrayLayout, ArrayRole, OutputId, Procedure};
use std::collections::HashMap;

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
pub fn computed<S: Judge>(
    function: &Function,
    (procedure, setup): (&Procedure, &SetupSlots),
    values: &HashMap<Argument, Vec<S>>,
) -> Result<Vec<S>, Failed> {
    let mut arrays = Arrays { arguments: values.clone(), ..Arrays::default() };
    arrays.arguments.insert(Argument::Time, vec![S::zero()]);
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
