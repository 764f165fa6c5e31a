//! The kinds of formula, and the edges that lead to them.

use std::fmt;

/// Index of a node in its graph. A node's operands have smaller indices.
pub type NodeId = u32;

/// A use of a node, with a sign: negation is a property of the use, so `x` and `−x` share a node.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Edge(u32);

impl Edge {
    /// A use of `node` as it is.
    pub fn to(node: NodeId) -> Self {
        Edge(node << 1)
    }

    /// The node.
    pub fn node(self) -> NodeId {
        self.0 >> 1
    }

    /// Whether the node's value is negated.
    pub fn is_negative(self) -> bool {
        self.0 & 1 == 1
    }

    /// The opposite use.
    pub fn negated(self) -> Self {
        Edge(self.0 ^ 1)
    }

    /// Without the sign.
    pub fn plain(self) -> Self {
        Edge(self.0 & !1)
    }
}

impl fmt::Debug for Edge {
    fn fmt(&self, out: &mut fmt::Formatter) -> fmt::Result {
        write!(out, "{}n{}", if self.is_negative() { "-" } else { "" }, self.node())
    }
}

/// A formula over edges.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Node {
    /// A known number by its bits: positive, as the sign is the edge's.
    Number(u64),
    /// An unknown; the graph's user knows what it stands for.
    Symbol(u32),
    /// A sum; the first edge is positive and leads to the smaller node.
    Sum(Edge, Edge),
    /// A product; both edges are positive, the first leads to the smaller node.
    Product(Edge, Edge),
    /// The reciprocal of a positive edge.
    Recip(Edge),
    /// The square root.
    Sqrt(Edge),
    /// The sine of a positive edge.
    Sin(Edge),
    /// The cosine of a positive edge.
    Cos(Edge),
    /// The magnitude of the first edge, which is positive, with the sign of the second.
    CopySign(Edge, Edge),
    /// The angle of the point at the first edge upwards and the second to the right.
    Atan2(Edge, Edge),
    /// The reciprocal of the first edge where it exceeds what rounding can leave of the second, zero
    /// elsewhere.
    RecipAbove(Edge, Edge),
}

impl Node {
    /// The edges that it uses.
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

    /// A number that differs between most nodes that differ, in its upper bits.
    pub(super) fn scattered(self) -> u64 {
        let (kind, first, second) = match self {
            Node::Number(bits) => (0, bits, 0),
            Node::Symbol(number) => (1, number.into(), 0),
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
        // A prime near the golden ratio of 2^64, as Knuth has it.
        let mixed = (first << 4 | kind).wrapping_mul(0x9e37_79b9_7f4a_7c55) ^ second;
        mixed.wrapping_mul(0x9e37_79b9_7f4a_7c55)
    }
}

/// The edges that a node uses, by hand: unoptimised, as macros are built, it takes a fraction of
/// what a chain of iterators does.
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
