//! The graph: a list of nodes without repetitions.

use super::{Edge, Expr, Node, NodeId};
use std::cell::RefCell;
use std::collections::HashMap;

/// When the value of a formula becomes known.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Stage {
    /// While compiling.
    Compile,
    /// When the chain is made or a parameter is set.
    Setup,
    /// In every step.
    State,
}

/// Formulas under construction. Handles borrow it, so it hides its list behind a cell.
#[derive(Debug, Default)]
pub struct Graph {
    inner: RefCell<Inner>,
}

#[derive(Debug, Default)]
struct Inner {
    nodes: Vec<Node>,
    stages: Vec<Stage>,
    // Only looked up, never walked through: its order would not be the same in every build.
    index: HashMap<Node, NodeId>,
}

impl Graph {
    /// The unknown with this number. The same number is the same unknown.
    pub fn symbol(&self, number: u32, stage: Stage) -> Expr<'_> {
        Expr::Formula(self, self.insert(Node::Symbol(number), stage))
    }

    /// The formula of `node`, whose form the rules have made canonical.
    pub(super) fn formula(&self, node: Node) -> Expr<'_> {
        let stage =
            node.operands().map(|edge| self.stage(edge.node())).max().unwrap_or(Stage::Compile);
        Expr::Formula(self, self.insert(node, stage))
    }

    /// The edge to a known number.
    pub fn number(&self, value: f64) -> Edge {
        let edge = self.insert(Node::Number(value.abs().to_bits()), Stage::Compile);
        if value.is_sign_negative() { edge.negated() } else { edge }
    }

    /// The edge to any expression.
    pub fn edge(&self, expr: Expr) -> Edge {
        match expr {
            Expr::Number(value) => self.number(value),
            Expr::Formula(_, edge) => edge,
        }
    }

    /// The expression that `edge` leads to.
    pub fn expr(&self, edge: Edge) -> Expr<'_> {
        match self.node(edge.node()) {
            Node::Number(bits) => {
                let value = f64::from_bits(bits);
                Expr::Number(if edge.is_negative() { -value } else { value })
            }
            _ => Expr::Formula(self, edge),
        }
    }

    /// The node at `id`.
    pub fn node(&self, id: NodeId) -> Node {
        self.inner.borrow().nodes[id as usize]
    }

    /// Where `node` is, if it is there.
    pub fn find(&self, node: Node) -> Option<NodeId> {
        self.inner.borrow().index.get(&node).copied()
    }

    /// When the value of the node at `id` becomes known.
    pub fn stage(&self, id: NodeId) -> Stage {
        self.inner.borrow().stages[id as usize]
    }

    /// The number of the unknown at `id`, if it is one.
    pub fn symbol_number(&self, id: NodeId) -> Option<u32> {
        match self.node(id) {
            Node::Symbol(number) => Some(number),
            _ => None,
        }
    }

    /// How many nodes there are.
    pub fn len(&self) -> usize {
        self.inner.borrow().nodes.len()
    }

    /// Whether there is no node.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    fn insert(&self, node: Node, stage: Stage) -> Edge {
        let inner = &mut *self.inner.borrow_mut();
        let id = *inner.index.entry(node).or_insert_with(|| {
            inner.nodes.push(node);
            inner.stages.push(stage);
            (inner.nodes.len() - 1) as NodeId
        });
        Edge::to(id)
    }
}
