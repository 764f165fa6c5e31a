//! The adjoints of nodes, and the assumptions on those that loops carry.

use crate::expr::{Edge, Expr, Graph, Node, NodeId, Stage};
use crate::function::Carry;
use crate::ids::SymbolId;
use std::collections::BTreeMap;

/// The adjoints of nodes; those of other nodes are zero.
#[derive(Clone, Debug, Default)]
pub(super) struct Adjoints<'g>(pub BTreeMap<NodeId, Expr<'g>>);

impl<'g> Adjoints<'g> {
    /// Adds an adjoint to that of an edge's node.
    pub(super) fn add(&mut self, edge: Edge, adjoint: Expr<'g>) {
        if adjoint.known() == Some(0.0) {
            return;
        }
        let signed = if edge.is_negative() { -adjoint } else { adjoint };
        self.0.entry(edge.node()).and_modify(|sum| *sum = *sum + signed).or_insert(signed);
    }

    /// Returns the adjoint of a node, if it is not zero.
    pub(super) fn of(&self, node: NodeId) -> Option<Expr<'g>> {
        self.0.get(&node).copied()
    }

    /// Returns the adjoint of a symbol.
    pub(super) fn of_symbol(&self, graph: &Graph, symbol: SymbolId) -> Expr<'g> {
        let node = graph.find(Node::Symbol(symbol));
        node.and_then(|node| self.of(node)).unwrap_or(Expr::Number(0.0))
    }
}

/// The adjoint of a carried value.
#[derive(Clone, Copy, Debug)]
pub(super) struct CarriedAdjoint<'g> {
    /// The carried value.
    pub carry: Carry,
    /// The adjoint of its exit.
    pub init: Expr<'g>,
    /// The symbols for the adjoint of its `next` in a repetition, and for that of its `init`.
    pub symbols: [SymbolId; 2],
    /// Whether the adjoint is assumed to change from repetition to repetition.
    changes: bool,
    /// Whether it has been found to change.
    is_known_to_change: bool,
}

impl<'g> CarriedAdjoint<'g> {
    /// Starts with the assumption that only known numbers do not change.
    pub(super) fn new(carry: Carry, init: Expr<'g>, symbols: [SymbolId; 2]) -> Self {
        let changes = init.known().is_none();
        CarriedAdjoint { carry, init, symbols, changes, is_known_to_change: false }
    }

    /// Returns the adjoint of `next` in a repetition, and that of `init`.
    pub(super) fn values(&self, graph: &'g Graph) -> [Expr<'g>; 2] {
        if !self.changes {
            return [self.init; 2];
        }
        self.symbols.map(|symbol| graph.symbol(symbol, Stage::State))
    }

    /// Returns whether the assumption is right, given the adjoint of `phi`, and corrects it otherwise.
    pub(super) fn is_right(&mut self, of_phi: Expr<'g>, graph: &'g Graph) -> bool {
        let [of_next, _] = self.values(graph);
        let is_kept = of_phi.is(&of_next);
        let changes = self.is_known_to_change || !is_kept;
        self.is_known_to_change |= !self.changes && !is_kept;
        let is_right = changes == self.changes;
        self.changes = changes;
        is_right
    }

    /// Returns the carried value that computes it, if it changes.
    pub(super) fn carry(&self, of_phi: Expr<'g>, graph: &'g Graph) -> Option<Carry> {
        let [phi, exit] = self.symbols;
        let (init, next) = (graph.edge(self.init), graph.edge(of_phi));
        self.changes.then_some(Carry { init, next, phi, exit })
    }
}
