//! The kinds of formula, and the edges that lead to them.

use std::fmt;

/// Index of a node in its graph. A node's operands have smaller indices.
pub type NodeId = u32;

/// A use of a node, with a sign: negation is a property of the use, so `x` and `−x` share a node.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
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
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
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
    pub fn operands(self) -> impl Iterator<Item = Edge> {
        let (first, second) = match self {
            Node::Number(_) | Node::Symbol(_) => (None, None),
            Node::Sum(a, b)
            | Node::Product(a, b)
            | Node::CopySign(a, b)
            | Node::Atan2(a, b)
            | Node::RecipAbove(a, b) => (Some(a), Some(b)),
            Node::Recip(a) | Node::Sqrt(a) | Node::Sin(a) | Node::Cos(a) => (Some(a), None),
        };
        first.into_iter().chain(second)
    }
}
