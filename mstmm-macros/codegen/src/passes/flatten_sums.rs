//! Flattens sums of sums into sums of many terms.

use super::{Live, Region, Regions};
use crate::expr::{Edge, Graph, Node, NodeId, Stage};
use crate::function::Function;

/// The flattened sums of a function.
pub(super) struct Sums<'g> {
    graph: &'g Graph,
    live: Live,
    regions: Regions,
    /// Whether a sum is a term of one other sum and used nowhere else.
    inner: Vec<bool>,
}

impl<'g> Sums<'g> {
    /// Flattens the sums of a function.
    pub(super) fn of(function: &Function<'g>) -> Self {
        let graph = function.graph;
        let live = Live::of(graph, function.roots());
        let regions = Regions::of(function, &live);
        let mut sums = Sums { graph, live, regions, inner: vec![false; graph.len()] };
        for at in 0..sums.live.nodes().len() {
            let id = sums.live.nodes()[at];
            let Some(terms) = sums.terms_as_written(id) else { continue };
            for term in terms {
                let is_sum = matches!(graph.node(term.node()), Node::Sum(..));
                sums.inner[term.node() as usize] |= is_sum && sums.is_only_for(term.node(), id);
            }
        }
        sums
    }

    /// Iterates over the live nodes, operands before their users, without the sums that are part of another sum.
    pub(super) fn nodes(&self) -> impl Iterator<Item = NodeId> {
        self.live.nodes().iter().copied().filter(|&id| !self.inner[id as usize])
    }

    /// Returns the region in which a node is computed.
    pub(super) fn region(&self, id: NodeId) -> Region {
        self.regions.region(id)
    }

    /// Returns all terms of a sum that is computed for every state; none for other nodes.
    pub(super) fn terms(&self, id: NodeId) -> Option<Vec<Edge>> {
        let mut terms = Vec::new();
        self.add_terms(self.terms_as_written(id)?, false, &mut terms);
        Some(terms)
    }

    /// Adds two terms, or their negatives, with the terms of sums among them.
    fn add_terms(&self, pair: [Edge; 2], negative: bool, terms: &mut Vec<Edge>) {
        for term in pair {
            let term = if negative { term.negated() } else { term };
            let is_inner = self.inner[term.node() as usize];
            match if is_inner { self.terms_as_written(term.node()) } else { None } {
                Some(inner) => self.add_terms(inner, term.is_negative(), terms),
                None => terms.push(term),
            }
        }
    }

    fn terms_as_written(&self, id: NodeId) -> Option<[Edge; 2]> {
        match self.graph.node(id) {
            Node::Sum(a, b) if self.graph.stage(id) == Stage::State => Some([a, b]),
            _ => None,
        }
    }

    /// Returns the factors of a product that only the sum `of` uses.
    pub(super) fn factors(&self, term: Edge, of: NodeId) -> Option<[Edge; 2]> {
        match self.graph.node(term.node()) {
            Node::Product(a, b) if self.is_only_for(term.node(), of) => Some([a, b]),
            _ => None,
        }
    }

    /// Returns whether a node is used once, in the same stage and region as its user.
    fn is_only_for(&self, node: NodeId, user: NodeId) -> bool {
        self.live.uses(node) == 1
            && self.graph.stage(node) == self.graph.stage(user)
            && self.regions.region(node) == self.regions.region(user)
    }
}
