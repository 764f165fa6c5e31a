//! What a node becomes: a statement, a name, or nothing.

use super::Home;
use super::schedule::Scheduler;
use crate::expr::{Edge, Node, NodeId};
use crate::ids::RepeatId;
use crate::program::{Name, Operand, Operation, Slot, Statement};

impl Scheduler<'_> {
    /// States a node.
    pub(super) fn compute(&mut self, id: NodeId) {
        if self.is_slot(id) {
            return self.read_slot(id);
        }
        if self.fused[id as usize] {
            return;
        }
        let operation = match self.graph.node(id) {
            Node::Number(_) => return,
            Node::Symbol(number) => return self.read_symbol(number, id),
            Node::Sin(_) | Node::Cos(_) => return self.compute_angles(id),
            Node::Sum(a, b) => self.sum(a, b),
            Node::Product(a, b) => Operation::Product(self.operand(a), self.operand(b)),
            Node::Recip(a) => Operation::Recip(self.operand(a)),
            Node::Sqrt(a) => Operation::Sqrt(self.operand(a)),
            Node::CopySign(a, b) => Operation::CopySign(self.operand(a), self.operand(b)),
            Node::Atan2(a, b) => Operation::Atan2(self.operand(a), self.operand(b)),
            Node::RecipAbove(a, b) => Operation::RecipAbove(self.operand(a), self.operand(b)),
        };
        let name = self.name(id);
        self.state(Statement::Let(name, operation));
    }

    fn read_symbol(&mut self, number: u32, id: NodeId) {
        let is_once = matches!(self.turns.home(id), Home::Once(_));
        if is_once && !self.carried.contains_key(&number) {
            self.program.symbols.push(number);
        }
    }

    fn read_slot(&mut self, id: NodeId) {
        let slot = self.slot_of(id);
        if self.part_of(id).is_none() {
            self.program.slots.push(slot);
        } else {
            self.slots.insert(id, slot);
        }
    }

    /// The repeated part that a node belongs to.
    fn part_of(&self, id: NodeId) -> Option<RepeatId> {
        match self.turns.home(id) {
            Home::Once(_) => None,
            Home::Turn(turn) => self.turns.all.get(turn).map(|turn| turn.repeat),
        }
    }

    /// The slot of a value that is known since setup, under a name of this program.
    fn slot_of(&mut self, id: NodeId) -> Slot {
        let (graph, symbols) = (self.graph, self.symbols);
        let given = match graph.node(id) {
            Node::Symbol(symbol) => Some(symbols[symbol as usize].clone()),
            _ => self.names.get(id).map(|name| self.program.names.text(name).to_owned()),
        };
        let (part, prefix) = (self.part_of(id), self.prefix().to_owned());
        let (index, name) = self.setup.slot(part, id, given, &prefix);
        let wanted = format!("known_{name}");
        let name = self.fresh(wanted);
        self.names.insert(id, name);
        Slot { index, name }
    }

    /// `a + b` with the sign of `b`, and a product if it is computed here, in the operation.
    fn sum(&self, a: Edge, b: Edge) -> Operation {
        let product = |edge: Edge| match self.graph.node(edge.node()) {
            Node::Product(x, y) if self.fused[edge.node() as usize] => {
                Some((self.operand(x), self.operand(y)))
            }
            _ => None,
        };
        let negative = b.is_negative();
        if let Some((x, y)) = product(b) {
            let addend = self.operand(a);
            return if negative {
                Operation::MulNegAdd(x, y, addend)
            } else {
                Operation::MulAdd(x, y, addend)
            };
        }
        let other = self.operand(b.plain());
        match (product(a), negative) {
            (Some((x, y)), true) => Operation::MulSub(x, y, other),
            (Some((x, y)), false) => Operation::MulAdd(x, y, other),
            (None, true) => Operation::Difference(self.operand(a), other),
            (None, false) => Operation::Sum(self.operand(a), other),
        }
    }

    /// Sines and cosines of all angles of one depth, side by side.
    fn compute_angles(&mut self, id: NodeId) {
        let key = (self.depths[id as usize], self.turns.home(id));
        let Some(angles) = self.angles.remove(&key) else { return };
        for &angle in &angles {
            self.require(angle);
        }
        let (mut sines, mut cosines, mut operands) = (Vec::new(), Vec::new(), Vec::new());
        for &angle in &angles {
            let graph = self.graph;
            let number = sines.len();
            for (names, prefix, node) in [
                (&mut sines, "sin", graph.find(Node::Sin(Edge::to(angle)))),
                (&mut cosines, "cos", graph.find(Node::Cos(Edge::to(angle)))),
            ] {
                names.push(match node.filter(|&node| self.live.has(node)) {
                    Some(node) => {
                        self.mark(node);
                        let name = match graph.node(angle) {
                            Node::Symbol(symbol) if !self.carried.contains_key(&symbol) => {
                                self.fresh(format!("{prefix}_{}", self.symbols[symbol as usize]))
                            }
                            _ => self.numbered(format!("{prefix}_{number}")),
                        };
                        self.names.insert(node, name);
                        Some(name)
                    }
                    None => None,
                });
            }
            operands.push(self.operand(Edge::to(angle)));
        }
        self.state(Statement::SinCos { sines, cosines, angles: operands });
    }

    fn name(&mut self, id: NodeId) -> Name {
        if let Some(name) = self.names.get(id) {
            return name;
        }
        let name = self.numbered(format!("t{}", self.temporaries));
        self.temporaries += 1;
        self.names.insert(id, name);
        name
    }

    pub(super) fn operand(&self, edge: Edge) -> Operand {
        let node = edge.node();
        let plain = match self.graph.node(node) {
            Node::Number(bits) => {
                let value = f64::from_bits(bits);
                return Operand::Number(if edge.is_negative() { 0.0 - value } else { value });
            }
            Node::Symbol(number) if !self.is_slot(node) => match self.carried.get(&number) {
                Some(&name) => Operand::Named(name),
                None => Operand::Symbol(number),
            },
            // Every node has been stated before its users.
            _ => self.names.get(node).map_or(Operand::Repeated, Operand::Named),
        };
        if edge.is_negative() { Operand::Minus(Box::new(plain)) } else { plain }
    }
}
