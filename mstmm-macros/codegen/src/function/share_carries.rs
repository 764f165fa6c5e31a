//! Merges values that loops carry and that are equal in every repetition.
//!
//! All values that loops over the same part carry in the same direction are assumed to be equal. Classes of equal values are
//! split where their starts or their ends differ, until no class needs to be split (J. Hopcroft's partition refinement, as in
//! optimistic value numbering).

use super::substitute::FormulaImages;
use super::{Carry, Function};
use crate::expr::{Edge, Stage};
use crate::ids::RepeatId;
use std::collections::HashMap;

/// Merges equal values that loops carry; a later loop then reads what an earlier one carries.
pub fn share_carries(mut function: Function) -> Function {
    let carries: Vec<((RepeatId, bool), Carry)> = function
        .loops
        .iter()
        .flat_map(|loop_| loop_.carries.iter().map(|&carry| ((loop_.repeat, loop_.inward), carry)))
        .collect();
    let mut first: Vec<usize> = first_alike(carries.iter().map(|(part, _)| *part));
    let images = loop {
        let mut images = images(&function, &carries, &first);
        let graph = function.graph;
        let mut image = |edge: Edge| graph.edge(images.of(edge));
        let ends = carries.iter().map(|(_, carry)| (image(carry.init), image(carry.next)));
        let ends: Vec<(Edge, Edge)> = ends.collect();
        let refined = first_alike(first.iter().zip(ends));
        if refined == first {
            break images;
        }
        first = refined;
    };
    let mut number = 0..;
    for loop_ in &mut function.loops {
        loop_.carries.retain(|_| number.next().is_some_and(|number| first[number] == number));
    }
    function.loops.retain(|loop_| !loop_.carries.is_empty());
    images.apply(function)
}

/// Returns, for each item, the index of the first item that is equal.
fn first_alike<T: std::hash::Hash + Eq>(items: impl Iterator<Item = T>) -> Vec<usize> {
    let mut known: HashMap<T, usize> = HashMap::new();
    items.enumerate().map(|(number, item)| *known.entry(item).or_insert(number)).collect()
}

/// Returns the images of formulas if each carried value is the first of its class.
fn images<'g>(
    function: &Function<'g>,
    carries: &[((RepeatId, bool), Carry)],
    first: &[usize],
) -> FormulaImages<'g> {
    let unknown = |symbol| function.graph.symbol(symbol, Stage::State);
    let merged =
        carries.iter().zip(first).enumerate().filter(|(number, (_, first))| number != *first);
    let formulas = merged.flat_map(|(_, ((_, carry), first))| {
        let (_, same) = &carries[*first];
        [(carry.phi, unknown(same.phi)), (carry.exit, unknown(same.exit))]
    });
    FormulaImages::new(function.graph, formulas.collect())
}
