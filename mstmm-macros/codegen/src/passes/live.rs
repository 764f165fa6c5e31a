//! What the results need.

use crate::expr::{Edge, Graph, NodeId};

/// How often every node of a graph is used on the way to some results.
#[derive(Clone, Debug)]
pub struct Live {
    uses: Vec<u32>,
    /// Those that are used, operands before their users.
    nodes: Vec<NodeId>,
}

impl Live {
    /// Counts from `results`.
    pub fn of(graph: &Graph, results: impl IntoIterator<Item = Edge>) -> Self {
        let mut uses = vec![0; graph.len()];
        let mut nodes = Vec::new();
        // Of the nodes that are used, so many are still to come.
        let mut open = 0;
        let mut next = 0;
        for edge in results {
            let node = edge.node() as usize;
            open += usize::from(uses[node] == 0);
            uses[node] += 1;
            next = next.max(node + 1);
        }
        // Operands stand before their users, so one walk towards the start sees every use.
        while open > 0 {
            next -= 1;
            if uses[next] == 0 {
                continue;
            }
            open -= 1;
            nodes.push(next as NodeId);
            for operand in graph.node(next as NodeId).operands() {
                let uses = &mut uses[operand.node() as usize];
                open += usize::from(*uses == 0);
                *uses += 1;
            }
        }
        nodes.reverse();
        Live { uses, nodes }
    }

    /// The nodes that are used, operands before their users.
    pub fn nodes(&self) -> &[NodeId] {
        &self.nodes
    }

    /// How often `node` is used.
    pub fn uses(&self, node: NodeId) -> u32 {
        match self.uses.get(node as usize) {
            Some(uses) => *uses,
            None => 0,
        }
    }

    /// Whether `node` is used at all.
    pub fn has(&self, node: NodeId) -> bool {
        self.uses(node) > 0
    }
}
