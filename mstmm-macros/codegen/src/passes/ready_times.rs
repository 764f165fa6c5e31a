//! When values are known, on a processor that computes each as soon as it can.

use super::Region;
use super::latency::{MULTIPLICATION, of_node};
use crate::expr::{Edge, Graph, Node, NodeId, Stage};

/// When the nodes of a graph are known, in cycles from the beginning of the program, or of the time of a
/// loop that computes them.
pub(super) struct ReadyTimes<'g> {
    graph: &'g Graph,
    /// Of the nodes that matter.
    all: Vec<Option<(Region, u32)>>,
}

impl<'g> ReadyTimes<'g> {
    /// Of `nodes`, operands before their users, each of which is computed in its `region`.
    pub(super) fn of(
        graph: &'g Graph,
        nodes: &[NodeId],
        region: impl Fn(NodeId) -> Region,
    ) -> Self {
        let mut times = ReadyTimes { graph, all: vec![None; graph.len()] };
        for &id in nodes {
            times.add(id, region(id));
        }
        times
    }

    /// When a node is known in `region`: from the beginning, if it is computed elsewhere.
    pub(super) fn at(&self, region: Region, node: NodeId) -> u32 {
        match self.all.get(node as usize) {
            Some(&Some((own, ready))) if own == region => ready,
            _ => 0,
        }
    }

    /// Takes down a node, and those that it is computed from, as far as they are new: they are computed
    /// in `region`.
    pub(super) fn follow(&mut self, node: NodeId, region: Region) {
        if self.all.len() < self.graph.len() {
            self.all.resize(self.graph.len(), None);
        }
        if self.all[node as usize].is_none() {
            for operand in self.graph.node(node).operands() {
                self.follow(operand.node(), region);
            }
            self.add(node, region);
        }
    }

    fn add(&mut self, id: NodeId, region: Region) {
        self.all[id as usize] = Some((region, self.ready(id, region)));
    }

    fn ready(&self, id: NodeId, region: Region) -> u32 {
        let formula = self.graph.node(id);
        if self.graph.stage(id) < Stage::State {
            return 0;
        }
        let known = |edge: Edge| self.at(region, edge.node());
        let Node::Sum(a, b) = formula else {
            return formula.operands().map(known).max().unwrap_or(0) + of_node(&formula);
        };
        let apart = known(a).max(known(b)) + of_node(&formula);
        // The factors of one product are known earlier than it would be.
        let together = |product: Edge, other: Edge| {
            matches!(self.graph.node(product.node()), Node::Product(..)).then(|| {
                let factors = known(product).saturating_sub(MULTIPLICATION);
                known(other).max(factors) + MULTIPLICATION
            })
        };
        let earliest = together(a, b).into_iter().chain(together(b, a)).min();
        earliest.unwrap_or(apart)
    }
}
