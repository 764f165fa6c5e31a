//! The times at which values are ready on a processor with unlimited parallelism.

use super::Region;
use super::latency::{MULTIPLICATION, of_node};
use crate::expr::{Edge, Graph, Node, NodeId, Stage};
use crate::ids::copies;

/// The times at which nodes are ready, in cycles from the start of the program, or of the repetition of the loop that
/// computes them.
pub(super) struct ReadyTimes<'g> {
    graph: &'g Graph,
    /// Region and time of each node; none for nodes that were not added.
    times: Vec<Option<(Region, u32)>>,
}

impl<'g> ReadyTimes<'g> {
    /// Returns the ready times of `nodes`, which are sorted with operands before their users.
    pub(super) fn of(
        graph: &'g Graph,
        nodes: &[NodeId],
        region: impl Fn(NodeId) -> Region,
    ) -> Self {
        let mut times = ReadyTimes { graph, times: copies(None, graph.len()) };
        for &id in nodes {
            times.add(id, region(id));
        }
        times
    }

    /// Returns the time at which a node is ready in `region`: zero if it is computed in another region.
    pub(super) fn at(&self, region: Region, node: NodeId) -> u32 {
        match self.times.get(node as usize) {
            Some(&Some((own, ready))) if own == region => ready,
            _ => 0,
        }
    }

    /// Adds a node and its operands, as far as they are new; they are computed in `region`.
    pub(super) fn follow(&mut self, node: NodeId, region: Region) {
        if self.times.len() < self.graph.len() {
            self.times.resize(self.graph.len(), None);
        }
        if self.times[node as usize].is_none() {
            for operand in self.graph.node(node).operands() {
                self.follow(operand.node(), region);
            }
            self.add(node, region);
        }
    }

    fn add(&mut self, id: NodeId, region: Region) {
        self.times[id as usize] = Some((region, self.ready(id, region)));
    }

    fn ready(&self, id: NodeId, region: Region) -> u32 {
        if self.graph.stage(id) < Stage::State {
            return 0;
        }
        let formula = self.graph.node(id);
        let known = |edge: Edge| self.at(region, edge.node());
        let mut separate = 0;
        for operand in formula.operands() {
            separate = separate.max(known(operand));
        }
        separate += of_node(&formula);
        let Node::Sum(a, b) = formula else { return separate };
        // A fused product waits for its factors only.
        let fused = |product: Edge, other: Edge| {
            matches!(self.graph.node(product.node()), Node::Product(..)).then(|| {
                let factors = known(product).saturating_sub(MULTIPLICATION);
                known(other).max(factors) + MULTIPLICATION
            })
        };
        match (fused(a, b), fused(b, a)) {
            (Some(first), Some(second)) => first.min(second),
            (Some(only), None) | (None, Some(only)) => only,
            (None, None) => separate,
        }
    }
}
