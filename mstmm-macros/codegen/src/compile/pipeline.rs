//! The pipeline from a function to a procedure: the only list of passes. `linearize` also fuses products and groups angles,
//! since both decide what a statement is.

use crate::function::Function;
use crate::passes::{
    Checks, Limbs, SetupSlots, choose_signs, drop_unused_carries, early_stores, factor, fuse_loops,
    linearize, list_schedule, lower, pack_limbs, reassociate, separate_factor,
};
use crate::program::{Procedure, Program};

/// A pass.
type Pass = for<'g> fn(Function<'g>) -> Function<'g>;

/// The passes that simplify a function. The readable text is printed after them.
const SIMPLIFY: [Pass; 2] = [drop_unused_carries, factor];

/// The passes that make it faster on processors that run several operations at once.
const ARRANGE: [Pass; 2] = [fuse_loops, reassociate];

fn run<'g>(function: Function<'g>, passes: &[Pass]) -> Function<'g> {
    passes.iter().fold(function, |function, pass| pass(function))
}

/// A function with its ordered statements, still without loads and stores.
pub(super) struct Ordered<'g> {
    /// The function.
    function: Function<'g>,
    /// Its program.
    program: Program,
}

/// The pass for a product that is computed with several vectors at a time.
const BY_COLUMNS: [Pass; 1] = [separate_factor];

/// Simplifies, arranges and orders a function; adds the slots that it reads to `setup`.
pub(super) fn order<'g>(
    function: Function<'g>,
    by_columns: bool,
    setup: &mut SetupSlots,
) -> Ordered<'g> {
    let function = run(run(function, &SIMPLIFY), &ARRANGE);
    let function = if by_columns { run(function, &BY_COLUMNS) } else { function };
    let program = list_schedule(linearize(&function, setup));
    Ordered { function, program }
}

/// Returns the program of a function in the order of its equations, without the passes for processors; adds the slots that
/// it reads to `setup`.
pub(super) fn readable(function: Function, setup: &mut SetupSlots) -> Program {
    linearize(&run(function, &SIMPLIFY), setup)
}

/// Adds loads, tests and stores, once all slots are known. Returns the procedure, and the same procedure with limbs of one
/// shape side by side if that saves operations.
pub(super) fn finish(
    ordered: Ordered,
    checks: Option<Checks>,
    setup: &SetupSlots,
    limbs: Option<&Limbs>,
) -> (Procedure, Option<Procedure>) {
    let procedure = early_stores(lower(ordered.program, &ordered.function, checks, setup));
    let packed = limbs.and_then(|limbs| pack_limbs(&procedure, limbs));
    (choose_signs(procedure), packed.map(choose_signs))
}
