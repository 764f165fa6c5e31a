//! The gradient of a value by reverse-mode differentiation, through loops over repeated parts.
//!
//! The adjoint of a value `x` is `∂L/∂x` for the differentiated value `L`. Each node adds `adjoint · ∂node/∂operand` to the
//! adjoints of its operands, the users of a node before the node (Griewank and Walther, Evaluating Derivatives, 2nd ed.,
//! SIAM 2008, section 3.2).
//!
//! The adjoint of a loop is a loop over the same part in the opposite direction. The adjoint of a carried value starts as the
//! adjoint of its exit; a repetition turns the adjoint of `next` into that of `phi`; at the end it is the adjoint of `init`.
//! A value that is the same in every repetition collects the sum over the repetitions. A value that belongs to one repetition
//! keeps its adjoint for the loop that computes it.

mod active;
mod adjoints;
mod sweep;

use super::Function;
use crate::expr::Edge;
use crate::ids::SymbolId;
use sweep::ReverseSweep;

/// Differentiates a value, which must be known outside of loops, by some unknowns of a function. Returns the function with
/// the loops of the adjoints, and the derivative by each unknown; for an unknown of a repeated part it is the formula for all
/// repetitions.
///
/// Only what depends on the unknowns is differentiated, so that other unknowns are held. The symbols of the added
/// loop-carried values follow all symbols in the graph.
pub fn gradient<'g>(
    mut function: Function<'g>,
    of: Edge,
    by: &[SymbolId],
) -> (Function<'g>, Vec<Edge>) {
    let mut sweep = ReverseSweep::new(&function, by);
    sweep.start(of);
    for (number, loop_) in function.loops.iter().enumerate().rev() {
        sweep.outside_after(number + 1);
        sweep.through_loop(number, loop_);
    }
    sweep.outside_after(0);
    let derivatives = by.iter().map(|&symbol| sweep.derivative(symbol)).collect();
    function.loops.extend(sweep.into_loops());
    (function, derivatives)
}
