//! Which values nodes are.

use crate::expr::NodeId;
use crate::program::ValueId;

/// Values by node.
pub(super) struct NodeValues(Vec<Option<ValueId>>);

impl NodeValues {
    /// No values yet for so many nodes.
    pub(super) fn new(nodes: usize) -> Self {
        NodeValues(vec![None; nodes])
    }

    pub(super) fn get(&self, node: NodeId) -> Option<ValueId> {
        self.0[node as usize]
    }

    pub(super) fn insert(&mut self, node: NodeId, value: ValueId) {
        self.0[node as usize] = Some(value);
    }
}
