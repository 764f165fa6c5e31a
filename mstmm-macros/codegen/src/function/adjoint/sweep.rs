//! The sweep from a value back to the unknowns.

use super::active::Active;
use super::adjoints::{Adjoints, CarriedAdjoint};
use crate::expr::{Edge, Expr, Graph, NodeId, Stage};
use crate::function::{Carry, Dependence, Function, Loop, SymbolDependences, Unknowns};
use crate::ids::{RepeatId, SymbolId};
use std::collections::BTreeMap;

/// The state of a sweep.
#[derive(Clone, Debug)]
pub(super) struct ReverseSweep<'g> {
    graph: &'g Graph,
    unknowns: &'g Unknowns,
    active: Active,
    symbols: SymbolDependences<'g>,
    /// The dependences of the first nodes of the graph; later nodes are added on demand.
    dependences: Vec<Dependence>,
    /// The active nodes outside of loops, by the number of loops that run before.
    outside: Vec<Vec<NodeId>>,
    /// The active nodes of repeated parts, by the first loop in which they can be computed.
    inside: Vec<Vec<NodeId>>,
    adjoints: Adjoints<'g>,
    /// The loops of the adjoints.
    loops: Vec<Loop>,
    next_symbol: usize,
}

impl<'g> ReverseSweep<'g> {
    /// Prepares to differentiate a value of a function by some unknowns.
    pub(super) fn new(function: &Function<'g>, by: &[SymbolId]) -> Self {
        let Function { graph, unknowns, loops, .. } = function;
        let last = (0..graph.len() as NodeId).filter_map(|id| graph.symbol_of(id)).max();
        let mut sweep = ReverseSweep {
            graph,
            unknowns,
            active: Active::of(function, by),
            symbols: SymbolDependences::of(unknowns, loops),
            dependences: Vec::new(),
            outside: vec![Vec::new(); loops.len() + 1],
            inside: vec![Vec::new(); loops.len()],
            adjoints: Adjoints::default(),
            loops: Vec::new(),
            // In other functions of the graph a symbol may have another meaning, so these must be new.
            next_symbol: last.map_or(0, |last| last.index() + 1).max(unknowns.count()),
        };
        sweep.find_dependences();
        sweep.place_nodes(loops);
        sweep
    }

    /// Sorts the active nodes by where they are computed.
    fn place_nodes(&mut self, loops: &[Loop]) {
        for id in 0..self.graph.len() as NodeId {
            if !self.active.has(Edge::to(id)) {
                continue;
            }
            let Dependence { repeat, earliest } = self.dependences[id as usize];
            let nodes = match repeat {
                None => self.outside.get_mut(earliest),
                // What no loop can compute is read after all loops, and the differentiated value does not depend on it.
                Some(part) => {
                    let first = (earliest..loops.len()).find(|&it| loops[it].repeat == part);
                    first.map(|first| &mut self.inside[first])
                }
            };
            nodes.into_iter().for_each(|nodes| nodes.push(id));
        }
    }

    /// Sets the adjoint of the differentiated value to one.
    pub(super) fn start(&mut self, of: Edge) {
        if self.dependences[of.node() as usize].repeat.is_some() {
            bug!("a value of a repeated part is differentiated")
        }
        self.adjoints.add(of, Expr::Number(1.0));
    }

    /// Returns the derivative by an unknown.
    pub(super) fn derivative(&self, symbol: SymbolId) -> Edge {
        self.graph.edge(self.adjoints.of_symbol(self.graph, symbol))
    }

    /// Returns the loops of the adjoints.
    pub(super) fn into_loops(self) -> Vec<Loop> {
        self.loops
    }

    /// Follows the values outside of loops that are computed after exactly this number of loops.
    pub(super) fn outside_after(&mut self, number: usize) {
        for id in std::mem::take(&mut self.outside[number]).into_iter().rev() {
            if let Some(adjoint) = self.adjoints.of(id) {
                let given = self.given(id, adjoint).into_iter();
                given.for_each(|(operand, it)| self.adjoints.add(operand, it));
            }
        }
    }

    /// Adds the loop of the adjoints of a loop, and follows the values that the loop computes.
    pub(super) fn through_loop(&mut self, number: usize, loop_: &Loop) {
        let graph = self.graph;
        let mut carried = self.carried(loop_);
        let adjoints = loop {
            let adjoints = self.in_repetition(number, &carried);
            let mut are_right = true;
            for it in &mut carried {
                are_right &= it.is_right(adjoints.of_symbol(graph, it.carry.phi), graph);
            }
            if are_right {
                break adjoints;
            }
        };
        let mut carries = Vec::new();
        for it in carried {
            carries.extend(it.carry(adjoints.of_symbol(graph, it.carry.phi), graph));
            let [_, of_init] = it.values(graph);
            self.adjoints.add(it.carry.init, of_init);
        }
        self.keep(number, adjoints, loop_.repeat, &mut carries);
        if !carries.is_empty() {
            self.loops.push(Loop { repeat: loop_.repeat, inward: !loop_.inward, carries });
        }
    }

    /// Returns the adjoints of the carried values of a loop that depend on the unknowns.
    fn carried(&mut self, loop_: &Loop) -> Vec<CarriedAdjoint<'g>> {
        let is_active = |carry: &Carry| self.active.has(carry.init) || self.active.has(carry.next);
        let carries: Vec<Carry> = loop_.carries.iter().copied().filter(is_active).collect();
        let adjoint = |carry: Carry| {
            let init = self.adjoints.of_symbol(self.graph, carry.exit);
            CarriedAdjoint::new(carry, init, self.new_carry(loop_.repeat))
        };
        carries.into_iter().map(adjoint).collect()
    }

    /// Returns the adjoints of all nodes to which a repetition of a loop contributes. Those of the nodes that it computes are
    /// complete.
    fn in_repetition(&self, number: usize, carried: &[CarriedAdjoint<'g>]) -> Adjoints<'g> {
        let mut adjoints = Adjoints::default();
        for it in carried.iter().filter(|it| self.active.has(it.carry.next)) {
            let [of_next, _] = it.values(self.graph);
            adjoints.add(it.carry.next, of_next);
        }
        for &id in self.inside[number].iter().rev() {
            if let Some(later) = self.adjoints.of(id) {
                adjoints.add(Edge::to(id), later);
            }
            if let Some(adjoint) = adjoints.of(id) {
                let given = self.given(id, adjoint).into_iter();
                given.for_each(|(operand, it)| adjoints.add(operand, it));
            }
        }
        adjoints
    }

    /// Adds what a repetition contributes to the adjoints of all nodes: to those outside of loops the sum over all
    /// repetitions.
    fn keep(
        &mut self,
        number: usize,
        adjoints: Adjoints<'g>,
        repeat: RepeatId,
        carries: &mut Vec<Carry>,
    ) {
        let mut sums: BTreeMap<Edge, Expr<'g>> = BTreeMap::new();
        for (id, adjoint) in adjoints.0 {
            if self.inside[number].binary_search(&id).is_ok() {
                self.adjoints.0.insert(id, adjoint);
                continue;
            }
            let mut contribution = adjoint;
            if self.dependences[id as usize].repeat.is_none() {
                let term = self.graph.edge(adjoint);
                let sum = sums.entry(term.plain());
                let sum = *sum.or_insert_with(|| self.sum(term.plain(), repeat, carries));
                contribution = if term.is_negative() { -sum } else { sum };
            }
            self.adjoints.add(Edge::to(id), contribution);
        }
    }

    /// Returns the sum of a term over the repetitions of a part.
    fn sum(&mut self, term: Edge, repeat: RepeatId, carries: &mut Vec<Carry>) -> Expr<'g> {
        self.find_dependences();
        let each = self.graph.expr(term);
        if self.dependences[term.node() as usize].repeat.is_none() {
            return Expr::Number(self.unknowns.repetitions(repeat) as f64) * each;
        }
        let [phi, exit] = self.new_carry(repeat);
        let next = self.graph.edge(self.graph.symbol(phi, Stage::State) + each);
        carries.push(Carry { init: self.graph.number(0.0), next, phi, exit });
        self.graph.symbol(exit, Stage::State)
    }

    /// Returns the operands of a node that depend on the unknowns, with what the node adds to their adjoints.
    fn given(&self, id: NodeId, adjoint: Expr<'g>) -> Vec<(Edge, Expr<'g>)> {
        let operands = self.graph.node(id).operands().enumerate();
        let active = operands.filter(|(_, operand)| self.active.has(*operand));
        active.map(|(number, it)| (it, adjoint * self.graph.partial(id, number))).collect()
    }

    /// Returns new symbols for a carried value of a loop over a part.
    fn new_carry(&mut self, repeat: RepeatId) -> [SymbolId; 2] {
        let [phi, exit] = [0, 1].map(|next| SymbolId(self.next_symbol + next));
        self.next_symbol += 2;
        self.symbols.carry(phi, Dependence { repeat: Some(repeat), earliest: 0 });
        [phi, exit]
    }

    /// Adds the dependences of the nodes that are new in the graph.
    fn find_dependences(&mut self) {
        for id in self.dependences.len()..self.graph.len() {
            let dependence = self.symbols.node(self.graph, id as NodeId, &self.dependences);
            self.dependences.push(dependence);
        }
    }
}
