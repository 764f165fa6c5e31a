//! Turns nodes into statements or names.

use super::Region;
use super::linearize::Linearizer;
use crate::expr::{Edge, Node, NodeId};
use crate::ids::{RepeatId, SymbolId};
use crate::program::{Operand, Operation, Slot, Statement, ValueId};

impl Linearizer<'_> {
    /// Computes a node, unless it is fused into its user.
    pub(super) fn compute(&mut self, id: NodeId) {
        if self.is_slot(id) {
            return self.read_slot(id);
        }
        if self.fused[id as usize] {
            return;
        }
        let operation = match self.graph.node(id) {
            Node::Number(_) => return,
            Node::Symbol(symbol) => return self.read_symbol(symbol, id),
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
        self.push(Statement::Let(name, operation));
    }

    /// Adds the value of an unknown under the unknown's name. Loop-carried values have a name already, and loops list
    /// the unknowns that they read themselves.
    fn read_symbol(&mut self, symbol: SymbolId, id: NodeId) {
        let Some(unknown) = self.function.unknowns.get(symbol) else { return };
        let value = self.program.names.add(unknown.name.clone());
        self.names.insert(id, value);
        if matches!(self.regions.region(id), Region::AfterLoops(_)) {
            self.program.unknowns.push((symbol, value));
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

    /// Returns the repeated part that a node belongs to, if any.
    fn part_of(&self, id: NodeId) -> Option<RepeatId> {
        match self.regions.region(id) {
            Region::AfterLoops(_) => None,
            Region::Loop(id) => Some(self.regions.loops[id].repeat),
        }
    }

    /// Returns the slot of a node, with a value of this program.
    fn slot_of(&mut self, id: NodeId) -> Slot {
        let symbol = self.graph.symbol_of(id);
        let given = match symbol.and_then(|symbol| self.function.unknowns.get(symbol)) {
            Some(unknown) => Some(unknown.name.clone()),
            None => self.names.get(id).map(|name| self.program.names.text(name).to_owned()),
        };
        let (part, prefix) = (self.part_of(id), self.prefix().to_owned());
        let (index, name) = self.setup.slot(part, id, given, &prefix);
        let wanted = format!("known_{name}");
        let value = self.program.names.fresh(wanted);
        self.names.insert(id, value);
        Slot { index, value }
    }

    /// Returns the operation of `a + b`, with the sign of `b` and with a fused product, if there is one.
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

    /// Computes the sines and cosines of all angles of the same depth and region in one statement.
    fn compute_angles(&mut self, id: NodeId) {
        let key = (self.depths[id as usize], self.regions.region(id));
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
                        let symbol = graph.symbol_of(angle);
                        let unknown = symbol.and_then(|it| self.function.unknowns.get(it));
                        let name = match unknown {
                            Some(unknown) => {
                                self.program.names.fresh(format!("{prefix}_{}", unknown.name))
                            }
                            None => self.program.names.numbered(format!("{prefix}_{number}")),
                        };
                        self.names.insert(node, name);
                        Some(name)
                    }
                    None => None,
                });
            }
            operands.push(self.operand(Edge::to(angle)));
        }
        self.push(Statement::SinCos { sines, cosines, angles: operands });
    }

    fn name(&mut self, id: NodeId) -> ValueId {
        if let Some(name) = self.names.get(id) {
            return name;
        }
        let name = self.program.names.numbered(format!("t{}", self.temporaries));
        self.temporaries += 1;
        self.names.insert(id, name);
        name
    }

    pub(super) fn operand(&self, edge: Edge) -> Operand {
        let node = edge.node();
        if let Node::Number(bits) = self.graph.node(node) {
            let value = f64::from_bits(bits);
            return Operand::Number(if edge.is_negative() { 0.0 - value } else { value });
        }
        let value = self.value(node);
        if edge.is_negative() { Operand::Minus(value) } else { Operand::Value(value) }
    }

    /// Returns the value of a node, which must have been computed.
    pub(super) fn value(&self, node: NodeId) -> ValueId {
        match self.names.get(node) {
            Some(value) => value,
            None => bug!("a value is used before it is computed"),
        }
    }
}
