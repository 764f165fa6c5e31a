//! The nodes of the graph, and the signed edges that lead to them.

use crate::ids::SymbolId;
use std::fmt;

/// The index of a node in its graph. A node's operands have smaller indices.
pub type NodeId = u32;

/// A use of a node, with a sign. Negation is a property of the edge, so that `x` and `−x` share a node.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Edge(u32);

impl Edge {
    /// Returns the positive edge to `node`.
    pub fn to(node: NodeId) -> Self {
        Edge(node << 1)
    }

    /// Returns the node.
    pub fn node(self) -> NodeId {
        self.0 >> 1
    }

    /// Returns whether the node's value is negated.
    pub fn is_negative(self) -> bool {
        self.0 & 1 == 1
    }

    /// Returns the edge with the opposite sign.
    pub fn negated(self) -> Self {
        Edge(self.0 ^ 1)
    }

    /// Returns the edge with a positive sign.
    pub fn plain(self) -> Self {
        Edge(self.0 & !1)
    }
}

impl fmt::Debug for Edge {
    fn fmt(&self, out: &mut fmt::Formatter) -> fmt::Result {
        write!(out, "{}n{}", if self.is_negative() { "-" } else { "" }, self.node())
    }
}

/// An operation on edges.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Node {
    /// The bits of a known number, which is positive: the sign belongs to the edge.
    Number(u64),
    /// An unknown, whose meaning is defined outside the graph.
    Symbol(SymbolId),
    /// A sum. The first edge is positive and leads to the smaller node.
    Sum(Edge, Edge),
    /// A product. Both edges are positive; the first leads to the smaller node.
    Product(Edge, Edge),
    /// The reciprocal of a positive edge.
    Recip(Edge),
    /// The square root of an edge.
    Sqrt(Edge),
    /// The sine of a positive edge.
    Sin(Edge),
    /// The cosine of a positive edge.
    Cos(Edge),
    /// The magnitude of the first edge, which is positive, with the sign of the second edge.
    CopySign(Edge, Edge),
    /// The arctangent `atan2(y, x)` of the first edge `y` and the second edge `x`.
    Atan2(Edge, Edge),
    /// The reciprocal of the first edge if it exceeds the rounding error of the second edge, otherwise zero.
    RecipAbove(Edge, Edge),
}

impl Node {
    /// Returns the edges that the node uses.
    pub fn operands(self) -> Operands {
        let (next, last) = match self {
            Node::Number(_) | Node::Symbol(_) => (None, None),
            Node::Sum(a, b)
            | Node::Product(a, b)
            | Node::CopySign(a, b)
            | Node::Atan2(a, b)
            | Node::RecipAbove(a, b) => (Some(a), Some(b)),
            Node::Recip(a) | Node::Sqrt(a) | Node::Sin(a) | Node::Cos(a) => (Some(a), None),
        };
        Operands { next, last }
    }

    /// Returns a hash, whose upper bits are well distributed.
    pub(super) fn hash(self) -> u64 {
        let (kind, first, second) = match self {
            Node::Number(bits) => (0, bits, 0),
            Node::Symbol(symbol) => (1, symbol.index() as u64, 0),
            Node::Sum(a, b) => (2, a.0.into(), b.0.into()),
            Node::Product(a, b) => (3, a.0.into(), b.0.into()),
            Node::Recip(a) => (4, a.0.into(), 0),
            Node::Sqrt(a) => (5, a.0.into(), 0),
            Node::Sin(a) => (6, a.0.into(), 0),
            Node::Cos(a) => (7, a.0.into(), 0),
            Node::CopySign(a, b) => (8, a.0.into(), b.0.into()),
            Node::Atan2(a, b) => (9, a.0.into(), b.0.into()),
            Node::RecipAbove(a, b) => (10, a.0.into(), b.0.into()),
        };
        // Fibonacci hashing, after Knuth: 2^64 divided by the golden ratio.
        let mixed = (first << 4 | kind).wrapping_mul(0x9e37_79b9_7f4a_7c55) ^ second;
        mixed.wrapping_mul(0x9e37_79b9_7f4a_7c55)
    }
}

/// An iterator over the edges that a node uses.
///
/// It is written by hand because macros are built unoptimised, where it costs a fraction of a chain of iterators.
#[derive(Clone, Debug)]
pub struct Operands {
    next: Option<Edge>,
    last: Option<Edge>,
}

impl Iterator for Operands {
    type Item = Edge;

    fn next(&mut self) -> Option<Edge> {
        let next = self.next;
        self.next = self.last;
        self.last = None;
        next
    }
}
