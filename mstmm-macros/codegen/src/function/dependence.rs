//! What values depend on: a single repetition of a part, and loops that must have run.

use super::{Loop, Unknowns};
use crate::expr::{Graph, NodeId};
use crate::ids::{RepeatId, SymbolId};

/// What a value depends on.
#[derive(Clone, Copy, Debug)]
pub struct Dependence {
    /// The part of which the value depends on a single repetition.
    pub repeat: Option<RepeatId>,
    /// The number of loops that must run before the value can be computed.
    pub earliest: usize,
}

impl Dependence {
    /// The dependence of a number.
    pub const NONE: Dependence = Dependence { repeat: None, earliest: 0 };

    /// Returns the dependence of a value that is computed from two others.
    pub fn and(self, other: Dependence) -> Dependence {
        let earliest = self.earliest.max(other.earliest);
        Dependence { repeat: self.repeat.or(other.repeat), earliest }
    }
}

/// The dependences of the symbols of a function.
#[derive(Clone, Debug)]
pub struct SymbolDependences<'g> {
    unknowns: &'g Unknowns,
    /// Those of loop-carried values, whose symbols follow those of the unknowns.
    carried: Vec<Dependence>,
    /// The number of loops that run before the factor of a product is read.
    before_factor: usize,
}

impl<'g> SymbolDependences<'g> {
    /// Finds the dependences of the unknowns and of the values that loops carry.
    pub fn of<'a>(unknowns: &'g Unknowns, loops: impl IntoIterator<Item = &'a Loop>) -> Self {
        let mut all = SymbolDependences { unknowns, carried: Vec::new(), before_factor: 0 };
        for (number, loop_) in loops.into_iter().enumerate() {
            for carry in &loop_.carries {
                let repeat = Some(loop_.repeat);
                all.carry(carry.phi, Dependence { repeat, earliest: number });
                all.carry(carry.exit, Dependence { repeat: None, earliest: number + 1 });
            }
        }
        all
    }

    /// Sets the number of loops that run before the factor of a product is read.
    pub fn with_factor_after(self, loops: usize) -> Self {
        SymbolDependences { before_factor: loops, ..self }
    }

    /// Sets the dependence of a loop-carried value.
    pub fn carry(&mut self, symbol: SymbolId, dependence: Dependence) {
        let place = symbol.index() - self.unknowns.count();
        if place >= self.carried.len() {
            self.carried.resize(place + 1, Dependence::NONE);
        }
        self.carried[place] = dependence;
    }

    /// Returns the dependence of a symbol; none if no loop carries the symbol any more.
    pub fn symbol(&self, symbol: SymbolId) -> Dependence {
        match self.unknowns.get(symbol) {
            Some(unknown) => {
                let earliest = if unknown.argument.is_factor() { self.before_factor } else { 0 };
                Dependence { repeat: unknown.repeat, earliest }
            }
            None => {
                let place = symbol.index() - self.unknowns.count();
                self.carried.get(place).copied().unwrap_or(Dependence::NONE)
            }
        }
    }

    /// Returns the dependence of a node, from those of its operands.
    pub fn node(&self, graph: &Graph, id: NodeId, all: &[Dependence]) -> Dependence {
        match graph.symbol_of(id) {
            Some(symbol) => self.symbol(symbol),
            None => {
                let operands = graph.node(id).operands().map(|edge| all[edge.node() as usize]);
                operands.fold(Dependence::NONE, Dependence::and)
            }
        }
    }
}
