//! Which heading needs a value first. With loops a value may be computed long before the section that needs it:
//! before the loop, in an earlier loop, or in the repetition before.

use crate::expr::{Edge, NodeId};
use crate::function::Function;
use std::collections::HashMap;

/// The first headings that need nodes, by number.
pub(super) struct Owners {
    /// In the same repetition.
    own: Vec<Option<usize>>,
    /// In any repetition.
    any: Vec<Option<usize>>,
}

impl Owners {
    /// The owners of all nodes that the headings of a function need; none where there is no loop.
    pub(super) fn of(function: &Function) -> Self {
        let graph = function.graph;
        if function.loops.is_empty() {
            return Owners { own: Vec::new(), any: Vec::new() };
        }
        let mut handed_on = HashMap::new();
        for carry in function.loops.iter().flat_map(|one| &one.carries) {
            for symbol in [carry.phi, carry.exit] {
                handed_on.insert(symbol, [carry.init.node(), carry.next.node()]);
            }
        }
        let [own, any] = [&HashMap::new(), &handed_on].map(|handed_on| {
            let mut owners = vec![None; graph.len()];
            for (number, heading) in function.headings.iter().enumerate() {
                let mut open: Vec<NodeId> =
                    heading.values.iter().map(|(_, edge)| edge.node()).collect();
                while let Some(id) = open.pop() {
                    if owners[id as usize].is_some() {
                        continue;
                    }
                    owners[id as usize] = Some(number);
                    open.extend(graph.node(id).operands().map(Edge::node));
                    let before = graph.symbol_of(id).and_then(|symbol| handed_on.get(&symbol));
                    open.extend(before.into_iter().flatten());
                }
            }
            owners
        });
        Owners { own, any }
    }

    /// The first heading that needs a node in the same repetition.
    pub(super) fn own(&self, node: NodeId) -> Option<usize> {
        *self.own.get(node as usize)?
    }

    /// The first heading that needs a node in any repetition.
    pub(super) fn any(&self, node: NodeId) -> Option<usize> {
        *self.any.get(node as usize)?
    }
}
