//! Sums of many terms: those that are written as sums of sums.

use super::{Live, Region, Regions};
use crate::expr::{Edge, Graph, Node, NodeId, Stage};
use crate::function::Function;

/// The sums of formulas, with the sums in them taken apart.
pub(super) struct Sums<'g> {
    graph: &'g Graph,
    live: Live,
    regions: Regions,
    /// The sums that are terms of one other sum and nothing else.
    inner: Vec<bool>,
}

impl<'g> Sums<'g> {
    /// Those of a function.
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

    /// The nodes that are needed for themselves, before those that they are needed for.
    pub(super) fn nodes(&self) -> impl Iterator<Item = NodeId> {
        self.live.nodes().iter().copied().filter(|&id| !self.inner[id as usize])
    }

    /// Where a node is computed.
    pub(super) fn region(&self, id: NodeId) -> Region {
        self.regions.region(id)
    }

    /// All terms of a sum that is needed and computed in every step.
    pub(super) fn terms(&self, id: NodeId) -> Option<Vec<Edge>> {
        let written = self.terms_as_written(id)?;
        let mut terms = Vec::new();
        for term in written {
            match self.inner[term.node() as usize].then(|| self.terms(term.node())).flatten() {
                Some(inner) => {
                    let signed = |t: Edge| if term.is_negative() { t.negated() } else { t };
                    terms.extend(inner.into_iter().map(signed));
                }
                None => terms.push(term),
            }
        }
        Some(terms)
    }

    fn terms_as_written(&self, id: NodeId) -> Option<[Edge; 2]> {
        match self.graph.node(id) {
            Node::Sum(a, b) if self.graph.stage(id) == Stage::State => Some([a, b]),
            _ => None,
        }
    }

    /// The factors of a product that is computed for the sum `of` alone.
    pub(super) fn factors(&self, term: Edge, of: NodeId) -> Option<[Edge; 2]> {
        match self.graph.node(term.node()) {
            Node::Product(a, b) if self.is_only_for(term.node(), of) => Some([a, b]),
            _ => None,
        }
    }

    /// Whether a node is used once, and computed where its user is.
    fn is_only_for(&self, node: NodeId, user: NodeId) -> bool {
        self.live.uses(node) == 1
            && self.graph.stage(node) == self.graph.stage(user)
            && self.regions.region(node) == self.regions.region(user)
    }
}
