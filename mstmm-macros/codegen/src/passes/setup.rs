//! Values that are known since setup.

use crate::expr::{Edge, NodeId};
use crate::ids::RepeatId;
use std::collections::HashMap;

/// The values that all programs of a chain share because they are known since setup: those that
/// stand once, and those of every time of a repeated part.
#[derive(Clone, Debug, Default)]
pub struct SetupSlots {
    once: SlotTable,
    parts: HashMap<RepeatId, SlotTable>,
    /// How many slots without a name each section has, by its prefix.
    unnamed: HashMap<String, usize>,
}

#[derive(Clone, Debug, Default)]
struct SlotTable {
    nodes: Vec<NodeId>,
    names: Vec<String>,
    index: HashMap<NodeId, usize>,
}

impl SetupSlots {
    /// The values in the order of their slots; `part` is the repeated part whose values are meant.
    pub fn values(&self, part: Option<RepeatId>) -> Vec<(&str, Edge)> {
        let slots = match part {
            None => Some(&self.once),
            Some(part) => self.parts.get(&part),
        };
        let Some(SlotTable { nodes, names, .. }) = slots else { return Vec::new() };
        let edges = nodes.iter().map(|&node| Edge::to(node));
        names.iter().map(String::as_str).zip(edges).collect()
    }

    /// How many slots there are, of a repeated part or of all that stands once.
    pub fn count(&self, part: Option<RepeatId>) -> usize {
        self.values(part).len()
    }

    /// The slot of `node` and its name. A new one is called `name`, or numbered under the prefix of the section
    /// that needs it first: so a slot that is added renames no slots of other sections.
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
