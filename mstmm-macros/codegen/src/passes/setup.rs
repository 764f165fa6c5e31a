//! Values that are known since setup.

use crate::expr::{Edge, NodeId};
use std::collections::HashMap;

/// The values that all programs of a chain share because they are known since setup.
#[derive(Clone, Debug, Default)]
pub struct Setup {
    nodes: Vec<NodeId>,
    names: Vec<String>,
    index: HashMap<NodeId, usize>,
}

impl Setup {
    /// The values in the order of their slots.
    pub fn values(&self) -> impl Iterator<Item = (&str, Edge)> {
        self.names.iter().map(String::as_str).zip(self.nodes.iter().map(|&node| Edge::to(node)))
    }

    /// The slot of `node`, a new one under `name` if it has none yet.
    pub fn slot(&mut self, node: NodeId, name: impl FnOnce(usize) -> String) -> usize {
        *self.index.entry(node).or_insert_with(|| {
            self.nodes.push(node);
            self.names.push(name(self.names.len()));
            self.names.len() - 1
        })
    }

    /// The name of a slot.
    pub fn name(&self, slot: usize) -> &str {
        &self.names[slot]
    }
}
