//! Decides whether the results of a function are tested only if its arguments are large.

use crate::function::{Function, Written};
use crate::program::{Failure, Finiteness, OutputId, Program, ValueBound};

/// The smallest number of results that are not tested if the arguments are within bounds. With fewer, LLVM makes vectors of
/// the arguments for their test, and of what is computed from them: the Jacobian of three balls, with 27 results, then takes
/// 1.15 times as long.
const MIN_RESULTS: usize = 32;

/// Returns bounds of unknowns and slots within which the results are finite, if there are many more results.
///
/// The results that are tested, `finite`, must be written entry by entry before.
pub(super) fn bounds(
    program: &Program,
    function: &Function,
    (finite, failure): (&[OutputId], Failure),
    finiteness: &Finiteness,
) -> Option<Vec<ValueBound>> {
    let mut tested = function.outputs.iter().filter(|output| finite.contains(&output.id));
    let is_written = failure == Failure::PartlyWritten
        && tested.all(|output| output.written == Written::ByEntry);
    let has_loops = program.loops().next().is_some();
    let arguments = program.unknowns.len() + program.slots.len();
    let has_many = finiteness.witnesses.len() >= MIN_RESULTS.max(arguments);
    if !is_written || has_loops || !function.pivots.is_empty() || arguments == 0 || !has_many {
        return None;
    }
    program.bounds(|symbol| function.unknowns.quaternion(symbol))
}
