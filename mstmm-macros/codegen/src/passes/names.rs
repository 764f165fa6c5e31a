//! The names of nodes.

use crate::expr::NodeId;

/// Names by node: lists, since looking up every operand in a map takes as long as all passes do.
pub(super) struct Names {
    /// For every node, how many names there were with its own; zero if it has none.
    counts: Vec<u32>,
    names: Vec<String>,
}

impl Names {
    /// No names yet for so many nodes.
    pub(super) fn new(nodes: usize) -> Self {
        Names { counts: vec![0; nodes], names: Vec::new() }
    }

    pub(super) fn get(&self, node: NodeId) -> Option<&String> {
        match self.counts[node as usize] {
            0 => None,
            count => Some(&self.names[count as usize - 1]),
        }
    }

    pub(super) fn insert(&mut self, node: NodeId, name: String) {
        self.names.push(name);
        self.counts[node as usize] = self.names.len() as u32;
    }
}
