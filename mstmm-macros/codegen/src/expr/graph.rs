//! The graph: a list of distinct nodes.

use super::{Edge, Expr, Node, NodeId};
use crate::ids::{SymbolId, copies};
use std::cell::{Ref, RefCell};

/// The time at which the value of a formula becomes known.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Stage {
    /// At compile time.
    Compile,
    /// When the chain is constructed or a parameter is set.
    Setup,
    /// At every evaluation of a state.
    State,
}

/// A hash-consed graph of formulas. Expressions borrow it while it grows, so its list is in a cell.
#[derive(Debug, Default)]
pub struct Graph {
    inner: RefCell<Inner>,
}

#[derive(Debug, Default)]
struct Inner {
    nodes: Vec<Node>,
    stages: Vec<Stage>,
    index: Index,
}

/// A hash table of nodes with open addressing, at most half full.
///
/// Macros are built unoptimised, where it costs a fraction of the standard library's hash map.
#[derive(Debug, Default)]
struct Index {
    /// The buckets, with linear probing; their number is a power of two.
    buckets: Vec<Option<NodeId>>,
}

impl Index {
    const MIN_BUCKETS: usize = 1 << 10;

    /// Returns the bucket of `node`, which is empty if the node is not in the table.
    fn bucket(&self, nodes: &[Node], node: Node) -> usize {
        let last = self.buckets.len() - 1;
        let mut bucket = (node.hash() >> 32) as usize & last;
        while let Some(id) = self.buckets[bucket] {
            if nodes[id as usize] == node {
                break;
            }
            bucket = (bucket + 1) & last;
        }
        bucket
    }

    /// Makes room for one node more than `nodes`.
    fn reserve(&mut self, nodes: &[Node]) {
        if 2 * nodes.len() < self.buckets.len() {
            return;
        }
        self.buckets = copies(None, (2 * self.buckets.len()).max(Self::MIN_BUCKETS));
        for (id, &node) in nodes.iter().enumerate() {
            let bucket = self.bucket(nodes, node);
            self.buckets[bucket] = Some(id as NodeId);
        }
    }
}

impl Graph {
    /// Returns the unknown with this id.
    pub fn symbol(&self, symbol: SymbolId, stage: Stage) -> Expr<'_> {
        Expr::Formula(self, self.insert(Node::Symbol(symbol), stage))
    }

    /// Returns the formula of `node`, which the rules have put into canonical form.
    pub(super) fn formula(&self, node: Node) -> Expr<'_> {
        let mut stage = Stage::Compile;
        for operand in node.operands() {
            stage = stage.max(self.stage(operand.node()));
        }
        Expr::Formula(self, self.insert(node, stage))
    }

    /// Returns the edge to a known number.
    pub fn number(&self, value: f64) -> Edge {
        let edge = self.insert(Node::Number(value.abs().to_bits()), Stage::Compile);
        if value.is_sign_negative() { edge.negated() } else { edge }
    }

    /// Returns the edge to an expression.
    pub fn edge(&self, expr: Expr) -> Edge {
        match expr {
            Expr::Number(value) => self.number(value),
            Expr::Formula(_, edge) => edge,
        }
    }

    /// Returns the expression that `edge` leads to.
    pub fn expr(&self, edge: Edge) -> Expr<'_> {
        match self.node(edge.node()) {
            Node::Number(bits) => {
                let value = f64::from_bits(bits);
                Expr::Number(if edge.is_negative() { -value } else { value })
            }
            _ => Expr::Formula(self, edge),
        }
    }

    /// Returns the node with this id.
    pub fn node(&self, id: NodeId) -> Node {
        self.inner.borrow().nodes[id as usize]
    }

    /// Returns all nodes, by id. The graph must not grow while they are borrowed.
    pub fn nodes(&self) -> Ref<'_, [Node]> {
        Ref::map(self.inner.borrow(), |inner| &inner.nodes[..])
    }

    /// Returns the id of `node`, if the graph has it.
    pub fn find(&self, node: Node) -> Option<NodeId> {
        let Inner { nodes, index, .. } = &*self.inner.borrow();
        if nodes.is_empty() { None } else { index.buckets[index.bucket(nodes, node)] }
    }

    /// Returns the stage at which the value of a node becomes known.
    pub fn stage(&self, id: NodeId) -> Stage {
        self.inner.borrow().stages[id as usize]
    }

    /// Returns the id of the unknown that a node is, if it is one.
    pub fn symbol_of(&self, id: NodeId) -> Option<SymbolId> {
        match self.node(id) {
            Node::Symbol(symbol) => Some(symbol),
            _ => None,
        }
    }

    /// Returns the number of nodes.
    pub fn len(&self) -> usize {
        self.inner.borrow().nodes.len()
    }

    /// Returns whether the graph has no nodes.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    fn insert(&self, node: Node, stage: Stage) -> Edge {
        let Inner { nodes, stages, index } = &mut *self.inner.borrow_mut();
        index.reserve(nodes);
        let bucket = index.bucket(nodes, node);
        if let Some(id) = index.buckets[bucket] {
            return Edge::to(id);
        }
        let id = nodes.len() as NodeId;
        index.buckets[bucket] = Some(id);
        nodes.push(node);
        stages.push(stage);
        Edge::to(id)
    }
}
