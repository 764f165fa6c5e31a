//! The nodes of a function that depend on some of its symbols.

use crate::expr::{Edge, NodeId};
use crate::function::Function;
use crate::ids::SymbolId;
use std::collections::HashSet;

/// The nodes whose values change with some symbols, also through loops.
#[derive(Clone, Debug)]
pub(super) struct Active(Vec<bool>);

impl Active {
    /// Finds the nodes of a function that depend on some symbols.
    pub(super) fn of(function: &Function, symbols: &[SymbolId]) -> Self {
        let mut symbols: HashSet<SymbolId> = symbols.iter().copied().collect();
        loop {
            let active = Active::directly(function, &symbols);
            let before = symbols.len();
            for carry in function.loops.iter().flat_map(|loop_| &loop_.carries) {
                if active.has(carry.init) || active.has(carry.next) {
                    symbols.extend([carry.phi, carry.exit]);
                }
            }
            if symbols.len() == before {
                return active;
            }
        }
    }

    /// Finds the nodes that depend on some symbols in the same repetition.
    fn directly(function: &Function, symbols: &HashSet<SymbolId>) -> Self {
        let graph = function.graph;
        let mut active = Active(Vec::with_capacity(graph.len()));
        for id in 0..graph.len() as NodeId {
            let is_active = match graph.symbol_of(id) {
                Some(symbol) => symbols.contains(&symbol),
                None => graph.node(id).operands().any(|edge| active.has(edge)),
            };
            active.0.push(is_active);
        }
        active
    }

    /// Returns whether the value of an edge depends on the symbols.
    pub(super) fn has(&self, edge: Edge) -> bool {
        self.0[edge.node() as usize]
    }
}
