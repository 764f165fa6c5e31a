//! The slots of a chain: values that are known since setup.

use crate::expr::{Edge, NodeId};
use crate::ids::RepeatId;
use std::collections::HashMap;

/// The slots that all programs of a chain share: those of repeated parts, and those outside of repeated parts.
#[derive(Clone, Debug, Default)]
pub struct SetupSlots {
    once: SlotTable,
    parts: HashMap<RepeatId, SlotTable>,
    /// The number of unnamed slots of each section, by its prefix.
    unnamed: HashMap<String, usize>,
}

#[derive(Clone, Debug, Default)]
struct SlotTable {
    nodes: Vec<NodeId>,
    names: Vec<String>,
    index: HashMap<NodeId, usize>,
}

impl SetupSlots {
    /// Returns names and values of the slots of a repeated part, or of those outside of repeated parts.
    pub fn values(&self, part: Option<RepeatId>) -> Vec<(&str, Edge)> {
        let slots = match part {
            None => Some(&self.once),
            Some(part) => self.parts.get(&part),
        };
        let Some(SlotTable { nodes, names, .. }) = slots else { return Vec::new() };
        let edges = nodes.iter().map(|&node| Edge::to(node));
        names.iter().map(String::as_str).zip(edges).collect()
    }

    /// Returns the number of slots of a repeated part, or of those outside of repeated parts.
    pub fn count(&self, part: Option<RepeatId>) -> usize {
        self.values(part).len()
    }

    /// Returns index and name of the slot of `node`, which is added if it is new. A new slot gets this `name`, or else a
    /// number after the prefix of the section that needs it first, so that an added slot does not rename the slots of other
    /// sections.
    pub fn slot(
        &mut self,
        part: Option<RepeatId>,
        node: NodeId,
        name: Option<String>,
        prefix: &str,
    ) -> (usize, &str) {
        let slots = match part {
            None => &mut self.once,
            Some(part) => self.parts.entry(part).or_default(),
        };
        let SlotTable { nodes, names, index } = slots;
        let slot = *index.entry(node).or_insert_with(|| {
            nodes.push(node);
            names.push(name.unwrap_or_else(|| {
                let number = self.unnamed.entry(prefix.to_owned()).or_default();
                *number += 1;
                format!("{prefix}_p{number}")
            }));
            names.len() - 1
        });
        (slot, &names[slot])
    }
}
