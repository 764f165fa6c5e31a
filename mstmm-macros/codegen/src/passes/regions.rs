//! Assigns every value to a region: outside of loops, or a loop over the repetitions of a part.

use super::Live;
use crate::expr::{Edge, Graph, Node, NodeId};
use crate::function::{Dependence, Function, Loop, SymbolDependences};
use crate::ids::{IdRange, IdVec, RepeatId, SymbolId, copies, declare_id};

declare_id! {
    /// A loop of a function, in the order in which the loops run.
    LoopId,
}

/// Where a value is computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Region {
    /// Outside of loops, after this number of loops.
    AfterLoops(usize),
    /// In every repetition of a loop.
    Loop(LoopId),
}

/// The regions of a function's values. A value belongs to the first region in which it can be computed.
#[derive(Clone, Debug)]
pub struct Regions {
    /// The loops in the order in which they run, then one loop without carries for each repeated part, which computes the
    /// results that no other loop computes.
    pub loops: IdVec<LoopId, Loop>,
    /// The dependences of all nodes; empty if there are no loops.
    dependences: Vec<Dependence>,
}

impl Regions {
    /// Finds the regions of all live nodes of a function.
    pub fn of(function: &Function, live: &Live) -> Self {
        let mut loops: IdVec<LoopId, Loop> = function.loops.clone().into();
        let of_unknowns = function.unknowns.iter().filter_map(|unknown| unknown.repeat);
        let last = of_unknowns.chain(loops.iter().map(|loop_| loop_.repeat)).max();
        let repeats = IdRange::from(0..last.map_or(0, |last: RepeatId| last.index() + 1));
        let empty = |repeat| Loop { repeat, inward: false, carries: Vec::new() };
        loops.extend(repeats.into_iter().map(empty));
        if loops.is_empty() {
            return Regions { loops, dependences: Vec::new() };
        }
        let graph = function.graph;
        let symbols = SymbolDependences::of(function.unknowns, loops.iter())
            .with_factor_after(function.loops_before_factor);
        let mut dependences = copies(Dependence::NONE, graph.len());
        for &id in live.nodes() {
            dependences[id as usize] = symbols.node(graph, id, &dependences);
        }
        Regions { loops, dependences }
    }

    /// Returns the region in which a node is computed.
    pub fn region(&self, node: NodeId) -> Region {
        self.first_for(self.dependence(node))
    }

    /// Returns the first region in which two nodes can be used together.
    pub fn common(&self, a: NodeId, b: NodeId) -> Region {
        self.first_for(self.dependence(a).and(self.dependence(b)))
    }

    /// Returns the dependence of a node: none if there are no loops, or if the node was added later.
    fn dependence(&self, node: NodeId) -> Dependence {
        self.dependences.get(node as usize).copied().unwrap_or(Dependence::NONE)
    }

    fn first_for(&self, dependence: Dependence) -> Region {
        let Some(repeat) = dependence.repeat else {
            return Region::AfterLoops(dependence.earliest);
        };
        let mut later = self.loops.enumerate().skip(dependence.earliest);
        match later.find(|(_, loop_)| loop_.repeat == repeat) {
            Some((id, _)) => Region::Loop(id),
            None => bug!("no loop is left over a repeated part"),
        }
    }
}

/// Removes the loop-carried values that no result needs, and loops without carries.
pub fn drop_unused_carries(mut function: Function) -> Function {
    if function.loops.is_empty() {
        return function;
    }
    let graph = function.graph;
    let mut needed: Vec<Vec<bool>> =
        function.loops.iter().map(|loop_| vec![false; loop_.carries.len()]).collect();
    let mut roots: Vec<Edge> = function.ends().collect();
    loop {
        let live = Live::of(graph, roots.iter().copied());
        let is_read = |symbol| is_live(graph, &live, symbol);
        let before = roots.len();
        for (loop_, needed) in function.loops.iter().zip(&mut needed) {
            for (carry, needed) in loop_.carries.iter().zip(needed) {
                if !*needed && (is_read(carry.phi) || is_read(carry.exit)) {
                    *needed = true;
                    roots.extend([carry.init, carry.next]);
                }
            }
        }
        if roots.len() == before {
            break;
        }
    }
    for (loop_, needed) in function.loops.iter_mut().zip(&needed) {
        let mut needed = needed.iter();
        loop_.carries.retain(|_| needed.next() == Some(&true));
    }
    function.loops.retain(|loop_| !loop_.carries.is_empty());
    function
}

fn is_live(graph: &Graph, live: &Live, symbol: SymbolId) -> bool {
    graph.find(Node::Symbol(symbol)).is_some_and(|node| live.has(node))
}
