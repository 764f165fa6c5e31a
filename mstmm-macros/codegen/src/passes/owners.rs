//! Finds the first heading that needs a value. With loops a value may be computed long before the section that needs it:
//! before the loop, in an earlier loop, or in the previous repetition.

use crate::expr::{Edge, NodeId};
use crate::function::Function;
use crate::ids::copies;
use std::collections::HashMap;

/// For each node, the index of the first heading that needs it.
pub(super) struct Owners {
    /// The first heading that needs it in the same repetition.
    same: Vec<Option<usize>>,
    /// The first heading that needs it in any repetition.
    any: Vec<Option<usize>>,
}

impl Owners {
    /// Finds the owners of all nodes that the headings of a function need; none if there is no loop.
    pub(super) fn of(function: &Function) -> Self {
        let graph = function.graph;
        if function.loops.is_empty() {
            return Owners { same: Vec::new(), any: Vec::new() };
        }
        let mut carried = HashMap::new();
        for carry in function.loops.iter().flat_map(|loop_| &loop_.carries) {
            for symbol in [carry.phi, carry.exit] {
                carried.insert(symbol, [carry.init.node(), carry.next.node()]);
            }
        }
        let [same, any] = [&HashMap::new(), &carried].map(|carried| {
            let mut owners = copies(None, graph.len());
            for (number, heading) in function.headings.iter().enumerate() {
                let mut open: Vec<NodeId> =
                    heading.values.iter().map(|(_, edge)| edge.node()).collect();
                while let Some(id) = open.pop() {
                    if owners[id as usize].is_some() {
                        continue;
                    }
                    owners[id as usize] = Some(number);
                    open.extend(graph.node(id).operands().map(Edge::node));
                    let before = graph.symbol_of(id).and_then(|symbol| carried.get(&symbol));
                    open.extend(before.into_iter().flatten());
                }
            }
            owners
        });
        Owners { same, any }
    }

    /// Returns the first heading that needs a node in the same repetition.
    pub(super) fn same(&self, node: NodeId) -> Option<usize> {
        *self.same.get(node as usize)?
    }

    /// Returns the first heading that needs a node in any repetition.
    pub(super) fn any(&self, node: NodeId) -> Option<usize> {
        *self.any.get(node as usize)?
    }
}
