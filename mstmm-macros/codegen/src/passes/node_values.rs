//! The values of nodes.

use crate::expr::NodeId;
use crate::ids::copies;
use crate::program::ValueId;

/// The values of a program, by node.
pub(super) struct NodeValues(Vec<Option<ValueId>>);

impl NodeValues {
    /// Returns an empty table for this number of nodes.
    pub(super) fn new(nodes: usize) -> Self {
        NodeValues(copies(None, nodes))
    }

    pub(super) fn get(&self, node: NodeId) -> Option<ValueId> {
        self.0[node as usize]
    }

    pub(super) fn insert(&mut self, node: NodeId, value: ValueId) {
        self.0[node as usize] = Some(value);
    }
}
