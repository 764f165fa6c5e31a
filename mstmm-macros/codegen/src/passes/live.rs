//! Liveness: the nodes that the results need.

use crate::expr::{Edge, Graph, NodeId};

/// The nodes that some results need, and the number of uses of each.
#[derive(Clone, Debug)]
pub struct Live {
    uses: Vec<u32>,
    /// The live nodes, operands before their users.
    nodes: Vec<NodeId>,
}

impl Live {
    /// Finds the nodes that `results` need.
    pub fn of(graph: &Graph, results: impl IntoIterator<Item = Edge>) -> Self {
        let of_graph = graph.nodes();
        let mut uses = vec![0; of_graph.len()];
        let mut nodes = Vec::new();
        // The number of live nodes that the walk has not reached.
        let mut open = 0;
        let mut next = 0;
        for edge in results {
            let node = edge.node() as usize;
            open += usize::from(uses[node] == 0);
            uses[node] += 1;
            next = next.max(node + 1);
        }
        // Operands come before their users, so one walk towards the start sees every use.
        while open > 0 {
            next -= 1;
            if uses[next] == 0 {
                continue;
            }
            open -= 1;
            nodes.push(next as NodeId);
            for operand in of_graph[next].operands() {
                let uses = &mut uses[operand.node() as usize];
                open += usize::from(*uses == 0);
                *uses += 1;
            }
        }
        nodes.reverse();
        Live { uses, nodes }
    }

    /// Returns the live nodes, operands before their users.
    pub fn nodes(&self) -> &[NodeId] {
        &self.nodes
    }

    /// Returns the number of uses of `node`.
    pub fn uses(&self, node: NodeId) -> u32 {
        match self.uses.get(node as usize) {
            Some(uses) => *uses,
            None => 0,
        }
    }

    /// Returns whether `node` is live.
    pub fn has(&self, node: NodeId) -> bool {
        self.uses(node) > 0
    }
}
