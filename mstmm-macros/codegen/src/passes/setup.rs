//! Values that are known since setup.

use crate::expr::{Edge, NodeId};
use crate::ids::RepeatId;
use std::collections::HashMap;

/// The values that all programs of a chain share because they are known since setup: those that
/// stand once, and those of every time of a repeated part.
#[derive(Clone, Debug, Default)]
pub struct Setup {
    once: Slots,
    parts: HashMap<RepeatId, Slots>,
}

#[derive(Clone, Debug, Default)]
struct Slots {
    nodes: Vec<NodeId>,
    names: Vec<String>,
    index: HashMap<NodeId, usize>,
}

impl Setup {
    /// The values in the order of their slots; `part` is the repeated part whose values are meant.
    pub fn values(&self, part: Option<RepeatId>) -> Vec<(&str, Edge)> {
        let slots = match part {
            None => Some(&self.once),
            Some(part) => self.parts.get(&part),
        };
        let Some(Slots { nodes, names, .. }) = slots else { return Vec::new() };
        let edges = nodes.iter().map(|&node| Edge::to(node));
        names.iter().map(String::as_str).zip(edges).collect()
    }

    /// The slot of `node`, a new one under `name` if it has none yet, and its name.
    pub fn slot(
        &mut self,
        part: Option<RepeatId>,
        node: NodeId,
        name: impl FnOnce(usize) -> String,
    ) -> (usize, &str) {
        let slots = match part {
            None => &mut self.once,
            Some(part) => self.parts.entry(part).or_default(),
        };
        let Slots { nodes, names, index } = slots;
        let slot = *index.entry(node).or_insert_with(|| {
            nodes.push(node);
            names.push(name(names.len()));
            names.len() - 1
        });
        (slot, &names[slot])
    }
}
