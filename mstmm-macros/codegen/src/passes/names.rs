//! Which values nodes are.

use crate::expr::NodeId;
use crate::program::Name;

/// Values by node.
pub(super) struct NodeNames(Vec<Option<Name>>);

impl NodeNames {
    /// No values yet for so many nodes.
    pub(super) fn new(nodes: usize) -> Self {
        NodeNames(vec![None; nodes])
    }

    pub(super) fn get(&self, node: NodeId) -> Option<Name> {
        self.0[node as usize]
    }

    pub(super) fn insert(&mut self, node: NodeId, name: Name) {
        self.0[node as usize] = Some(name);
    }
}
