//! The operation of a node: on other operands, and differentiated by its own.

use super::{Edge, Expr, Graph, Node, NodeId};
use crate::math::Scalar;

impl Graph {
    /// Applies the operation of a node to other operands, which `operand` returns for its own.
    pub fn with_operands<'g>(&'g self, id: NodeId, operand: impl Fn(Edge) -> Expr<'g>) -> Expr<'g> {
        match self.node(id) {
            Node::Number(_) | Node::Symbol(_) => self.expr(Edge::to(id)),
            Node::Sum(a, b) => operand(a) + operand(b),
            Node::Product(a, b) => operand(a) * operand(b),
            Node::Recip(a) => operand(a).recip(),
            Node::Sqrt(a) => operand(a).sqrt(),
            Node::Sin(a) => operand(a).sin_cos().0,
            Node::Cos(a) => operand(a).sin_cos().1,
            Node::CopySign(a, b) => operand(a).copysign(operand(b)),
            Node::Atan2(a, b) => operand(a).atan2(operand(b)),
            Node::RecipAbove(a, b) => operand(a).recip_above(operand(b)),
        }
    }

    /// Returns the derivative of a node by one of its operands, counted from zero. At a kink it is the derivative of the side
    /// that `copysign` takes, and the derivative by the scale of a rounding error is zero.
    pub fn partial(&self, id: NodeId, operand: usize) -> Expr<'_> {
        let (of, one) = (|edge| self.expr(edge), Expr::number(1.0));
        let itself = of(Edge::to(id));
        match (self.node(id), operand) {
            (Node::Sum(..), _) => one,
            (Node::Product(_, b), 0) => of(b),
            (Node::Product(a, _), 1) => of(a),
            (Node::Recip(_), _) | (Node::RecipAbove(..), 0) => -(itself * itself),
            (Node::Sqrt(_), _) => Expr::number(0.5) * itself.recip(),
            (Node::Sin(a), _) => of(a).sin_cos().1,
            (Node::Cos(a), _) => -of(a).sin_cos().0,
            (Node::CopySign(a, b), 0) => one.copysign(of(a)) * one.copysign(of(b)),
            (Node::Atan2(y, x), 0) => of(x) * (of(y) * of(y) + of(x) * of(x)).recip(),
            (Node::Atan2(y, x), 1) => -(of(y) * (of(y) * of(y) + of(x) * of(x)).recip()),
            (Node::CopySign(..) | Node::RecipAbove(..), 1) => Expr::number(0.0),
            (node, operand) => bug!("{node:?} has no operand {operand}"),
        }
    }
}
