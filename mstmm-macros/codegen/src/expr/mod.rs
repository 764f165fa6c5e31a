//! Formulas as a hash-consed graph, and a handle that computes like a number.

mod graph;
mod node;
mod operands;
mod rules;

pub use graph::{Graph, Stage};
pub use node::{Edge, Node, NodeId};

use crate::math::Scalar;
use std::fmt;
use std::ops::{Add, Mul, Neg, Sub};

/// A formula in a [`Graph`], or a known number. Arithmetic on it adds nodes to the graph.
#[derive(Clone, Copy)]
pub enum Expr<'g> {
    /// A known number, which needs no graph.
    Number(f64),
    /// A formula.
    Formula(&'g Graph, Edge),
}

impl<'g> Expr<'g> {
    /// Returns the number, if it is known.
    pub fn known(self) -> Option<f64> {
        match self {
            Expr::Number(value) => Some(value),
            Expr::Formula(..) => None,
        }
    }

    /// Returns whether both are the same formula, or the same number bit by bit.
    pub fn is(&self, other: &Self) -> bool {
        match (self, other) {
            (Expr::Number(one), Expr::Number(other)) => one.to_bits() == other.to_bits(),
            (Expr::Formula(_, one), Expr::Formula(_, other)) => one == other,
            _ => false,
        }
    }

    fn unary(self, number: impl Fn(f64) -> f64, rule: impl Fn(&'g Graph, Edge) -> Self) -> Self {
        match self {
            Expr::Number(value) => Expr::Number(number(value)),
            Expr::Formula(graph, edge) => rule(graph, edge),
        }
    }
}

impl Neg for Expr<'_> {
    type Output = Self;
    fn neg(self) -> Self {
        self.unary(|value| 0.0 - value, |graph, edge| Expr::Formula(graph, edge.negated()))
    }
}

impl Add for Expr<'_> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        rules::sum(self, other)
    }
}

impl Sub for Expr<'_> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        rules::sum(self, -other)
    }
}

impl Mul for Expr<'_> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        rules::product(self, other)
    }
}

impl Scalar for Expr<'_> {
    fn number(value: f64) -> Self {
        Expr::Number(value)
    }

    fn recip(self) -> Self {
        self.unary(f64::recip, rules::reciprocal)
    }

    fn sqrt(self) -> Self {
        self.unary(f64::sqrt, |graph, edge| graph.formula(Node::Sqrt(edge)))
    }

    fn sin_cos(self) -> (Self, Self) {
        let sin = self.unary(f64::sin, |graph, edge| {
            graph.formula(Node::Sin(edge.plain())).signed(edge.is_negative())
        });
        let cos = self.unary(f64::cos, |graph, edge| graph.formula(Node::Cos(edge.plain())));
        (sin, cos)
    }

    fn copysign(self, sign: Self) -> Self {
        rules::copysign(self, sign)
    }

    fn atan2(self, x: Self) -> Self {
        rules::binary(self, x, Scalar::atan2, Node::Atan2)
    }

    fn recip_above(self, scale: Self) -> Self {
        rules::binary(self, scale, Scalar::recip_above, Node::RecipAbove)
    }

    fn vanishes(self) -> bool {
        self.known() == Some(0.0)
    }
}

impl Expr<'_> {
    /// Negates the expression if `negative`.
    fn signed(self, negative: bool) -> Self {
        if negative { -self } else { self }
    }
}

impl fmt::Debug for Expr<'_> {
    fn fmt(&self, out: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Expr::Number(value) => write!(out, "{value:?}"),
            Expr::Formula(_, edge) => write!(out, "{edge:?}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Expr, Graph, Stage};
    use crate::ids::SymbolId;
    use crate::math::Scalar;

    fn edge(expr: Expr) -> super::Edge {
        match expr {
            Expr::Formula(_, edge) => edge,
            Expr::Number(value) => panic!("{value} is no formula"),
        }
    }

    #[test]
    fn equal_formulas_are_one_node_whatever_the_order_and_the_sign() {
        let graph = Graph::default();
        let (x, y) =
            (graph.symbol(SymbolId(0), Stage::State), graph.symbol(SymbolId(1), Stage::State));
        assert_eq!(edge(x + y), edge(y + x));
        assert_eq!(edge(x * y), edge(y * x));
        assert_eq!(edge(x - y), edge(-(y - x)));
        assert_eq!(edge((-x) * y), edge(-(x * y)));
        assert_eq!(edge((-x).recip()), edge(-x.recip()));
        assert_eq!(edge((-x).sin_cos().1), edge(x.sin_cos().1));
    }

    #[test]
    fn zeros_ones_and_numbers_fold() {
        let graph = Graph::default();
        let x = graph.symbol(SymbolId(0), Stage::State);
        let number = Expr::number;
        assert_eq!((x * number(0.0)).known(), Some(0.0));
        assert_eq!((x - x).known(), Some(0.0));
        assert_eq!(edge(x * number(1.0)), edge(x));
        assert_eq!(edge(x * number(-1.0)), edge(-x));
        assert_eq!(edge(number(2.0) * (number(3.0) * x)), edge(number(6.0) * x));
        assert_eq!(edge(x + x), edge(number(2.0) * x));
        assert_eq!(edge((x + number(1.0)) + number(2.0)), edge(x + number(3.0)));
        assert_eq!(edge(x.recip().recip()), edge(x));
        let y = graph.symbol(SymbolId(1), Stage::State);
        assert_eq!(edge((x + y) - y), edge(x));
        assert_eq!(edge(x - (x - y)), edge(y));
        assert_eq!(edge((y - x) + (x - y) + x), edge(x));
    }
}
