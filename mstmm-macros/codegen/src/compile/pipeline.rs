//! The way of a function from formulas to a procedure: the only list of passes. Products are fused and angles put side
//! by side within `linearize`, since both decide what a statement is.

use crate::function::Function;
use crate::passes::{
    Checks, SetupSlots, drop_unused_carries, early_stores, factor, fuse_loops, linearize,
    list_schedule, lower, reassociate,
};
use crate::program::{Procedure, Program};

/// A pass.
type Pass = for<'g> fn(Function<'g>) -> Function<'g>;

/// What makes a function shorter. Its text is printed behind them.
const SIMPLIFY: [Pass; 2] = [drop_unused_carries, factor];

/// What makes it faster on processors that run several operations at once.
const ARRANGE: [Pass; 2] = [fuse_loops, reassociate];

fn run<'g>(function: Function<'g>, passes: &[Pass]) -> Function<'g> {
    passes.iter().fold(function, |function, pass| pass(function))
}

/// A function whose statements are in order and that waits for its reading and writing.
pub(super) struct Ordered<'g> {
    /// The function.
    function: Function<'g>,
    /// Its program in the order in which it runs.
    program: Program,
}

/// Simplifies, arranges and orders a function; `setup` gets the slots that it reads.
pub(super) fn order<'g>(function: Function<'g>, setup: &mut SetupSlots) -> Ordered<'g> {
    let function = run(run(function, &SIMPLIFY), &ARRANGE);
    let program = list_schedule(linearize(&function, setup));
    Ordered { function, program }
}

/// The program of a function in the order of its equations, without what is done for processors; `setup` gets the
/// slots that it reads.
pub(super) fn readable(function: Function, setup: &mut SetupSlots) -> Program {
    linearize(&run(function, &SIMPLIFY), setup)
}

/// Adds reading, tests and writing, once all slots are known.
pub(super) fn finish(ordered: Ordered, checks: Option<Checks>, setup: &SetupSlots) -> Procedure {
    early_stores(lower(ordered.program, &ordered.function, checks, setup))
}
