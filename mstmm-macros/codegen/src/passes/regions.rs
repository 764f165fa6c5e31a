//! Where values are computed: once, or in a loop over the repetitions of a part.

use super::Live;
use crate::expr::{Edge, Graph, Node, NodeId};
use crate::function::{Function, Loop};
use crate::ids::{IdRange, RepeatId};

/// Where a value is computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Region {
    /// Once, when so many loops are done.
    Once(usize),
    /// In every repetition of this loop.
    Loop(usize),
}

/// The regions of a function's values: a value belongs to the first region in which it can be computed.
#[derive(Clone, Debug)]
pub struct Regions {
    /// The loops in the order in which they run, with one more for each repeated part, which carries nothing:
    /// there results go that no other loop has.
    pub loops: Vec<Loop>,
    /// What the nodes depend on; none where there is no loop.
    needs: Vec<Dependence>,
}

impl Regions {
    /// The regions of all live nodes of a function.
    pub fn of(function: &Function, live: &Live) -> Self {
        let mut loops = function.loops.clone();
        let of_unknowns = function.unknowns.iter().filter_map(|unknown| unknown.repeat);
        let last = of_unknowns.chain(loops.iter().map(|one| one.repeat)).max();
        let repeats = IdRange::from(0..last.map_or(0, |last: RepeatId| last.index() + 1));
        let empty = |repeat| Loop { repeat, inward: false, carries: Vec::new() };
        loops.extend(repeats.into_iter().map(empty));
        if loops.is_empty() {
            return Regions { loops, needs: Vec::new() };
        }
        let graph = function.graph;
        let carried = CarriedUnknowns::of(&loops, function.unknowns.count());
        let mut needs = vec![Dependence::NOTHING; graph.len()];
        for &id in live.nodes() {
            needs[id as usize] = match graph.symbol_number(id) {
                Some(number) => match function.unknowns.get(number) {
                    Some(unknown) => Dependence { repeat: unknown.repeat, earliest: 0 },
                    None => carried.needs(number),
                },
                None => graph.node(id).operands().fold(Dependence::NOTHING, |needed, operand| {
                    needed.and(needs[operand.node() as usize])
                }),
            };
        }
        Regions { loops, needs }
    }

    /// Where a node is computed.
    pub fn region(&self, node: NodeId) -> Region {
        self.first_for(self.needs(node))
    }

    /// Where two nodes can be used together.
    pub fn together(&self, one: NodeId, other: NodeId) -> Region {
        self.first_for(self.needs(one).and(self.needs(other)))
    }

    /// What a node depends on: nothing, where there are no loops or the node was added later.
    fn needs(&self, node: NodeId) -> Dependence {
        self.needs.get(node as usize).copied().unwrap_or(Dependence::NOTHING)
    }

    fn first_for(&self, needs: Dependence) -> Region {
        let Some(repeat) = needs.repeat else { return Region::Once(needs.earliest) };
        let mut later = self.loops.iter().enumerate().skip(needs.earliest);
        match later.find(|(_, one)| one.repeat == repeat) {
            Some((number, _)) => Region::Loop(number),
            None => bug!("no loop is left over a repeated part"),
        }
    }
}

/// What a value depends on.
#[derive(Clone, Copy, Debug)]
struct Dependence {
    /// Of which part it depends on a single repetition.
    repeat: Option<RepeatId>,
    /// The loops that come before the first region in which it can be computed.
    earliest: usize,
}

impl Dependence {
    const NOTHING: Dependence = Dependence { repeat: None, earliest: 0 };

    fn and(self, other: Dependence) -> Dependence {
        let earliest = self.earliest.max(other.earliest);
        Dependence { repeat: self.repeat.or(other.repeat), earliest }
    }
}

/// The unknowns that loops carry, by their numbers beyond the others.
struct CarriedUnknowns {
    first: usize,
    all: Vec<Dependence>,
}

impl CarriedUnknowns {
    fn of(loops: &[Loop], first: usize) -> Self {
        let last = loops.iter().flat_map(|one| &one.carries).map(|carry| carry.exit as usize).max();
        let mut all = vec![Dependence::NOTHING; last.map_or(0, |last| last + 1 - first)];
        for (number, one) in loops.iter().enumerate() {
            for carry in &one.carries {
                all[carry.phi as usize - first] =
                    Dependence { repeat: Some(one.repeat), earliest: number };
                all[carry.exit as usize - first] =
                    Dependence { repeat: None, earliest: number + 1 };
            }
        }
        CarriedUnknowns { first, all }
    }

    /// What an unknown depends on; one that no loop carries any more is not needed.
    fn needs(&self, number: u32) -> Dependence {
        self.all.get(number as usize - self.first).copied().unwrap_or(Dependence::NOTHING)
    }
}

/// The same function with the carries that its results need, in place of all; loops without any are left out.
pub fn drop_unused_carries(mut function: Function) -> Function {
    let graph = function.graph;
    let mut needed: Vec<Vec<bool>> =
        function.loops.iter().map(|one| vec![false; one.carries.len()]).collect();
    let mut roots: Vec<Edge> = function.ends().collect();
    loop {
        let live = Live::of(graph, roots.iter().copied());
        let is_read = |number: u32| is_live(graph, &live, number);
        let before = roots.len();
        for (one, needed) in function.loops.iter().zip(&mut needed) {
            for (carry, needed) in one.carries.iter().zip(needed) {
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
    for (one, needed) in function.loops.iter_mut().zip(&needed) {
        let mut needed = needed.iter();
        one.carries.retain(|_| needed.next() == Some(&true));
    }
    function.loops.retain(|one| !one.carries.is_empty());
    function
}

fn is_live(graph: &Graph, live: &Live, symbol: u32) -> bool {
    graph.find(Node::Symbol(symbol)).is_some_and(|node| live.has(node))
}
