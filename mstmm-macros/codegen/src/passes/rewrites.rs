//! The images of nodes when formulas are rewritten.

use crate::expr::{Edge, Expr, Graph, NodeId};
use crate::function::Function;
use crate::ids::copies;

/// The image of every node that a function needs.
#[derive(Clone, Debug)]
pub(super) struct Images(Vec<Option<Edge>>);

impl Images {
    /// Returns an empty table for the current nodes of a graph.
    pub(super) fn new(graph: &Graph) -> Self {
        Images(copies(None, graph.len()))
    }

    pub(super) fn set(&mut self, node: NodeId, image: Expr, graph: &Graph) {
        self.0[node as usize] = Some(graph.edge(image));
    }

    /// Returns the image of an edge, if its node has one.
    pub(super) fn edge(&self, edge: Edge) -> Option<Edge> {
        let image = self.0.get(edge.node() as usize).copied().flatten()?;
        Some(if edge.is_negative() { image.negated() } else { image })
    }

    /// Replaces all edges of a function by their images.
    pub(super) fn apply<'g>(&self, function: Function<'g>) -> Function<'g> {
        function.map(|edge| self.edge(edge))
    }

    /// Returns the image of an edge, or the edge itself if its node has no image.
    pub(super) fn expr<'g>(&self, graph: &'g Graph, edge: Edge) -> Expr<'g> {
        graph.expr(self.edge(edge).unwrap_or(edge))
    }

    /// Applies the operation of a node to the images of its operands.
    pub(super) fn over_images<'g>(&self, graph: &'g Graph, id: NodeId) -> Expr<'g> {
        graph.with_operands(id, |edge| self.expr(graph, edge))
    }
}
