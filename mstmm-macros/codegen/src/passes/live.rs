//! What the results need.

use crate::expr::{Edge, Graph, NodeId};

/// How often every node of a graph is used on the way to some results.
#[derive(Clone, Debug)]
pub struct Live {
    uses: Vec<u32>,
}

impl Live {
    /// Counts from `results`.
    pub fn of(graph: &Graph, results: impl IntoIterator<Item = Edge>) -> Self {
        let mut uses = vec![0; graph.len()];
        for edge in results {
            uses[edge.node() as usize] += 1;
        }
        // Operands stand before their users, so one walk from the end sees every use.
        for id in (0..uses.len()).rev() {
            if uses[id] > 0 {
                for operand in graph.node(id as NodeId).operands() {
                    uses[operand.node() as usize] += 1;
                }
            }
        }
        Live { uses }
    }

    /// How often `node` is used.
    pub fn uses(&self, node: NodeId) -> u32 {
        self.uses.get(node as usize).copied().unwrap_or(0)
    }

    /// Whether `node` is used at all.
    pub fn has(&self, node: NodeId) -> bool {
        self.uses(node) > 0
    }
}
