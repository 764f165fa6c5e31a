//! The graph: a list of nodes without repetitions.

use super::{Edge, Expr, Node, NodeId};
use std::cell::RefCell;

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
    index: Index,
}

/// Where nodes are: a table with open addresses, at most half full. It takes a fraction of the time
/// of a hash map of the standard library where it is not optimised, as macros are built.
#[derive(Debug, Default)]
struct Index {
    /// Numbers of nodes, the next places taken where those of several would be the same; its length
    /// is a power of two.
    places: Vec<Option<NodeId>>,
}

impl Index {
    const SMALLEST: usize = 1 << 10;

    /// The place of `node`, which is free if it is not there.
    fn place(&self, nodes: &[Node], node: Node) -> usize {
        let last = self.places.len() - 1;
        let mut place = (node.scattered() >> 32) as usize & last;
        while let Some(id) = self.places[place] {
            if nodes[id as usize] == node {
                break;
            }
            place = (place + 1) & last;
        }
        place
    }

    /// Makes room for one more than `nodes`.
    fn reserve(&mut self, nodes: &[Node]) {
        if 2 * nodes.len() < self.places.len() {
            return;
        }
        self.places = vec![None; (2 * self.places.len()).max(Self::SMALLEST)];
        for (id, &node) in nodes.iter().enumerate() {
            let place = self.place(nodes, node);
            self.places[place] = Some(id as NodeId);
        }
    }
}

impl Graph {
    /// The unknown with this number. The same number is the same unknown.
    pub fn symbol(&self, number: u32, stage: Stage) -> Expr<'_> {
        Expr::Formula(self, self.insert(Node::Symbol(number), stage))
    }

    /// The formula of `node`, whose form the rules have made canonical.
    pub(super) fn formula(&self, node: Node) -> Expr<'_> {
        let mut stage = Stage::Compile;
        for operand in node.operands() {
            stage = stage.max(self.stage(operand.node()));
        }
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
        let Inner { nodes, index, .. } = &*self.inner.borrow();
        if nodes.is_empty() { None } else { index.places[index.place(nodes, node)] }
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
        let Inner { nodes, stages, index } = &mut *self.inner.borrow_mut();
        index.reserve(nodes);
        let place = index.place(nodes, node);
        if let Some(id) = index.places[place] {
            return Edge::to(id);
        }
        let id = nodes.len() as NodeId;
        index.places[place] = Some(id);
        nodes.push(node);
        stages.push(stage);
        Edge::to(id)
    }
}
