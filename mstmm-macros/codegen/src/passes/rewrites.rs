//! Where nodes go when formulas are rewritten.

use crate::expr::{Edge, Expr, Graph, Node, NodeId};
use crate::function::Function;
use crate::math::Scalar;

/// What has become of every node that a function needs.
#[derive(Clone, Debug)]
pub(super) struct Images(Vec<Option<Edge>>);

impl Images {
    /// Images of the first nodes of a graph, as many as it has now, none of them known yet.
    pub(super) fn new(graph: &Graph) -> Self {
        Images(vec![None; graph.len()])
    }

    pub(super) fn set(&mut self, node: NodeId, image: Expr, graph: &Graph) {
        self.0[node as usize] = Some(graph.edge(image));
    }

    /// The same use of what a node has become, if it is still needed.
    pub(super) fn edge(&self, edge: Edge) -> Option<Edge> {
        let image = self.0.get(edge.node() as usize).copied().flatten()?;
        Some(if edge.is_negative() { image.negated() } else { image })
    }

    /// The function over what its nodes have become.
    pub(super) fn apply<'g>(&self, function: Function<'g>) -> Function<'g> {
        function.map(|edge| self.edge(edge))
    }

    /// Where a use leads when its node's image is known, and as before where it is not.
    pub(super) fn expr<'g>(&self, graph: &'g Graph, edge: Edge) -> Expr<'g> {
        graph.expr(self.edge(edge).unwrap_or(edge))
    }

    /// A node over the images of its operands.
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
