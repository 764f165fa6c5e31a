//! The images of nodes when formulas are rewritten.

use crate::expr::{Edge, Expr, Graph, Node, NodeId};
use crate::function::Function;
use crate::math::Scalar;

/// The image of every node that a function needs.
#[derive(Clone, Debug)]
pub(super) struct Images(Vec<Option<Edge>>);

impl Images {
    /// Returns an empty table for the current nodes of a graph.
    pub(super) fn new(graph: &Graph) -> Self {
        Images(vec![None; graph.len()])
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
        let go = |edge: Edge| self.expr(graph, edge);
        match graph.node(id) {
            Node::Number(_) | Node::Symbol(_) => graph.expr(Edge::to(id)),
            Node::Sum(a, b) => go(a) + go(b),
            Node::Product(a, b) => go(a) * go(b),
            Node::Recip(a) => go(a).recip(),
            Node::Sqrt(a) => go(a).sqrt(),
            Node::Sin(a) => go(a).sin_cos().0,
            Node::Cos(a) => go(a).sin_cos().1,
            Node::CopySign(a, b) => go(a).copysign(go(b)),
            Node::Atan2(a, b) => go(a).atan2(go(b)),
            Node::RecipAbove(a, b) => go(a).recip_above(go(b)),
        }
    }
}
