//! The canonical form of every operation: constant folding, the order of operands, and the place of signs.
//!
//! The rules are those of real numbers. Rounding may change if known numbers are collected or if a sum or a reciprocal
//! is undone, and `0 x` is zero even if `x` is not finite.

use super::{Edge, Expr, Graph, Node};
use Expr::{Formula, Number};

/// `a + b`
pub(super) fn sum<'g>(a: Expr<'g>, b: Expr<'g>) -> Expr<'g> {
    match (a, b) {
        (Number(a), Number(b)) => Number(a + b),
        (Number(0.0), x) | (x, Number(0.0)) => x,
        (Number(value), Formula(graph, edge)) | (Formula(graph, edge), Number(value)) => {
            sum_with_number(graph, edge, value)
        }
        (Formula(graph, a), Formula(_, b)) => {
            if a == b {
                product(Number(2.0), Formula(graph, a))
            } else if a == b.negated() {
                Number(0.0)
            } else if let Some(rest) = without(graph, a, b).or_else(|| without(graph, b, a)) {
                Formula(graph, rest)
            } else {
                ordered_sum(graph, a, b)
            }
        }
    }
}

/// `(x + y) − y = x`: removes the term `−b` from the sum `a`, if the sum has it.
fn without(graph: &Graph, a: Edge, b: Edge) -> Option<Edge> {
    let Node::Sum(x, y) = graph.node(a.node()) else { return None };
    let sign = |edge: Edge| if a.is_negative() { edge.negated() } else { edge };
    let (x, y) = (sign(x), sign(y));
    match b.negated() {
        taken if taken == y => Some(x),
        taken if taken == x => Some(y),
        _ => None,
    }
}

/// `(x + 1) + 2 = x + 3`
fn sum_with_number(graph: &Graph, edge: Edge, value: f64) -> Expr<'_> {
    if let Node::Sum(first, second) = graph.node(edge.node()) {
        for (number, rest) in [(first, second), (second, first)] {
            if let Node::Number(bits) = graph.node(number.node()) {
                let sign = if number.is_negative() != edge.is_negative() { -1.0 } else { 1.0 };
                let rest = Formula(graph, rest).signed(edge.is_negative());
                return sum(rest, Number(value + sign * f64::from_bits(bits)));
            }
        }
    }
    ordered_sum(graph, edge, graph.number(value))
}

/// Puts the smaller node first and makes it positive: `−a + b = −(a − b)`.
fn ordered_sum(graph: &Graph, a: Edge, b: Edge) -> Expr<'_> {
    let (a, b) = if a.node() < b.node() { (a, b) } else { (b, a) };
    if a.is_negative() {
        -graph.formula(Node::Sum(a.negated(), b.negated()))
    } else {
        graph.formula(Node::Sum(a, b))
    }
}

/// `a · b`
pub(super) fn product<'g>(a: Expr<'g>, b: Expr<'g>) -> Expr<'g> {
    match (a, b) {
        (Number(a), Number(b)) => Number(a * b),
        (Number(0.0), _) | (_, Number(0.0)) => Number(0.0),
        (Number(1.0), x) | (x, Number(1.0)) => x,
        (Number(-1.0), x) | (x, Number(-1.0)) => -x,
        (Number(value), Formula(graph, edge)) | (Formula(graph, edge), Number(value)) => {
            product_with_number(graph, edge, value)
        }
        (Formula(graph, a), Formula(_, b)) => ordered_product(graph, a, b),
    }
}

/// `2 (3 x) = 6 x`
fn product_with_number(graph: &Graph, edge: Edge, value: f64) -> Expr<'_> {
    if let Node::Product(first, second) = graph.node(edge.node()) {
        for (number, rest) in [(first, second), (second, first)] {
            if let Node::Number(bits) = graph.node(number.node()) {
                let rest = Formula(graph, rest).signed(edge.is_negative());
                return product(Number(value * f64::from_bits(bits)), rest);
            }
        }
    }
    ordered_product(graph, edge, graph.number(value))
}

/// Puts the smaller node first, and the signs in front of the product.
fn ordered_product(graph: &Graph, a: Edge, b: Edge) -> Expr<'_> {
    let negative = a.is_negative() != b.is_negative();
    let (a, b) = (a.plain().min(b.plain()), a.plain().max(b.plain()));
    graph.formula(Node::Product(a, b)).signed(negative)
}

/// `1 / x`, with `1 / (1 / x) = x`
pub(super) fn reciprocal(graph: &Graph, edge: Edge) -> Expr<'_> {
    match graph.node(edge.node()) {
        Node::Recip(inner) => Formula(graph, inner),
        _ => graph.formula(Node::Recip(edge.plain())),
    }
    .signed(edge.is_negative())
}

/// `|a|` with the sign of `b`
pub(super) fn copysign<'g>(a: Expr<'g>, b: Expr<'g>) -> Expr<'g> {
    match (a, b) {
        (Number(a), Number(b)) => Number(a.copysign(b)),
        (Formula(graph, a), b) => graph.formula(Node::CopySign(a.plain(), graph.edge(b))),
        (a, Formula(graph, b)) => graph.formula(Node::CopySign(graph.edge(a).plain(), b)),
    }
}

/// An operation whose only rule folds known numbers.
pub(super) fn binary<'g>(
    a: Expr<'g>,
    b: Expr<'g>,
    fold: impl Fn(f64, f64) -> f64,
    node: impl Fn(Edge, Edge) -> Node,
) -> Expr<'g> {
    match (a, b) {
        (Number(a), Number(b)) => Number(fold(a, b)),
        (Formula(graph, a), b) => graph.formula(node(a, graph.edge(b))),
        (a, Formula(graph, b)) => graph.formula(node(graph.edge(a), b)),
    }
}
