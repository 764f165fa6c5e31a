//! Loops over repeated parts: which values live in which of them.

use super::Live;
use crate::expr::{Edge, Graph, Node, NodeId};
use crate::ids::{IdRange, RepeatId};

/// A loop over a repeated part.
#[derive(Clone, Debug)]
pub struct Turn {
    /// Which part.
    pub repeat: RepeatId,
    /// Whether it goes from the last time to the first.
    pub inwards: bool,
    /// What it carries.
    pub carries: Vec<Carry>,
}

/// A number that a loop carries.
#[derive(Clone, Copy, Debug)]
pub struct Carry {
    /// What the first time begins with.
    pub first: Edge,
    /// What any time hands on.
    pub next: Edge,
    /// Number of the unknown that any time begins with.
    pub entering: u32,
    /// Number of the unknown that the last time leaves.
    pub leaving: u32,
}

/// Where a value is computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Home {
    /// Once, when so many loops are done.
    Once(usize),
    /// In every time of this loop.
    Turn(usize),
}

/// The loops of a program, with one more for each repeated part, which carries nothing: there results
/// go that no other loop has.
#[derive(Clone, Debug)]
pub struct Turns {
    /// In the order in which they run.
    pub all: Vec<Turn>,
    /// Where the nodes are computed; none where there is no loop.
    homes: Vec<Home>,
}

impl Turns {
    /// The homes of all live nodes of `graph`; `parts` says which unknowns belong to which repeated
    /// part.
    pub fn of(graph: &Graph, live: &Live, turns: Vec<Turn>, parts: &[Option<RepeatId>]) -> Self {
        let mut all = turns;
        let with_unknowns = parts.iter().flatten().copied();
        let last = with_unknowns.chain(all.iter().map(|turn| turn.repeat)).max();
        let count = last.map_or(0, |last| last.index() + 1);
        let repeats = IdRange::from(0..count).into_iter();
        all.extend(repeats.map(|repeat| Turn { repeat, inwards: false, carries: Vec::new() }));
        if all.is_empty() {
            return Turns { all, homes: Vec::new() };
        }
        let mut places = vec![Place::START; graph.len()];
        for &id in live.nodes() {
            places[id as usize] = match graph.symbol_number(id) {
                Some(number) => Place::of_symbol(number, &all, parts),
                None => graph.node(id).operands().fold(Place::START, |place, operand| {
                    place.together_with(places[operand.node() as usize])
                }),
            };
        }
        let home = |place: &Place| match place.repeat {
            None => Home::Once(place.earliest),
            Some(repeat) => {
                let mut turns = (place.earliest..all.len()).filter(|&t| all[t].repeat == repeat);
                Home::Turn(turns.next().unwrap_or(all.len()))
            }
        };
        let homes = places.iter().map(home).collect();
        Turns { all, homes }
    }

    /// Where a node is computed.
    pub fn home(&self, node: NodeId) -> Home {
        match self.homes.get(node as usize) {
            Some(home) => *home,
            None => Home::Once(0),
        }
    }
}

/// What a value hangs on.
#[derive(Clone, Copy, Debug)]
struct Place {
    /// Of which part it hangs on a single time.
    repeat: Option<RepeatId>,
    /// The loops that come before the first in which it can be computed.
    earliest: usize,
}

impl Place {
    const START: Place = Place { repeat: None, earliest: 0 };

    fn of_symbol(number: u32, turns: &[Turn], parts: &[Option<RepeatId>]) -> Place {
        if let Some(&part) = parts.get(number as usize) {
            return Place { repeat: part, earliest: 0 };
        }
        for (turn, Turn { repeat, carries, .. }) in turns.iter().enumerate() {
            for carry in carries {
                if carry.entering == number {
                    return Place { repeat: Some(*repeat), earliest: turn };
                }
                if carry.leaving == number {
                    return Place { repeat: None, earliest: turn + 1 };
                }
            }
        }
        Place::START
    }

    fn together_with(self, other: Place) -> Place {
        let earliest = self.earliest.max(other.earliest);
        Place { repeat: self.repeat.or(other.repeat), earliest }
    }
}

/// The carries that `results` need, in place of all; and all that has to be computed for both.
pub fn needed_carries(graph: &Graph, turns: &[Turn], results: &[Edge]) -> (Vec<Turn>, Vec<Edge>) {
    if turns.is_empty() {
        return (Vec::new(), results.to_vec());
    }
    let mut needed: Vec<Vec<bool>> =
        turns.iter().map(|turn| vec![false; turn.carries.len()]).collect();
    let mut roots = results.to_vec();
    loop {
        let live = Live::of(graph, roots.iter().copied());
        let is_read =
            |number: u32| graph.find(Node::Symbol(number)).is_some_and(|symbol| live.has(symbol));
        let before = roots.len();
        for (turn, needed) in turns.iter().zip(&mut needed) {
            for (carry, needed) in turn.carries.iter().zip(needed) {
                if !*needed && (is_read(carry.entering) || is_read(carry.leaving)) {
                    *needed = true;
                    roots.extend([carry.first, carry.next]);
                }
            }
        }
        if roots.len() == before {
            break;
        }
    }
    let kept = |(turn, needed): (&Turn, &Vec<bool>)| Turn {
        carries: turn
            .carries
            .iter()
            .zip(needed)
            .filter(|(_, needed)| **needed)
            .map(|(carry, _)| *carry)
            .collect(),
        ..turn.clone()
    };
    (turns.iter().zip(&needed).map(kept).collect(), roots)
}
