//! Loops that follow each other are one where they may be: what the first computes the second then has at
//! hand, and a processor works on both at a time.

use super::Turn;
use crate::expr::{Edge, Graph};
use std::collections::HashSet;

/// Joins each loop with the one before it that carries anything, if both go the same way over the same
/// part and it needs nothing of what that one leaves in the end.
pub fn join(graph: &Graph, turns: &[Turn]) -> Vec<Turn> {
    let mut joined: Vec<Turn> = Vec::new();
    for turn in turns.iter().filter(|turn| !turn.carries.is_empty()) {
        match joined.last_mut() {
            Some(last) if last.goes_like(turn) && !last.leaves_something_for(turn, graph) => {
                last.carries.extend(&turn.carries);
            }
            _ => joined.push(turn.clone()),
        }
    }
    joined
}

impl Turn {
    /// Whether both go the same way over the same part.
    fn goes_like(&self, other: &Turn) -> bool {
        (self.repeat, self.inwards) == (other.repeat, other.inwards)
    }

    /// Whether what `later` begins with or hands on needs what the last time of this loop leaves.
    fn leaves_something_for(&self, later: &Turn, graph: &Graph) -> bool {
        let left: HashSet<u32> = self.carries.iter().map(|carry| carry.leaving).collect();
        let carries = later.carries.iter();
        let mut open: Vec<Edge> = carries.flat_map(|carry| [carry.first, carry.next]).collect();
        let mut seen = HashSet::new();
        while let Some(edge) = open.pop() {
            if !seen.insert(edge.node()) {
                continue;
            }
            if graph.symbol_number(edge.node()).is_some_and(|symbol| left.contains(&symbol)) {
                return true;
            }
            open.extend(graph.node(edge.node()).operands());
        }
        false
    }
}

#[cfg(test)]
mod tests {
    use super::{Turn, join};
    use crate::expr::{Expr, Graph, Stage};
    use crate::ids::RepeatId;
    use crate::passes::Carry;

    /// A loop with one number, entering as the unknown with this number and leaving as the next one.
    fn turn(graph: &Graph, inwards: bool, number: u32, first: Expr, added: Expr) -> Turn {
        let (entering, leaving) = (number, number + 1);
        let next = graph.symbol(entering, Stage::State) + added;
        let carry = Carry { first: graph.edge(first), next: graph.edge(next), entering, leaving };
        Turn { repeat: RepeatId(0), inwards, carries: vec![carry] }
    }

    #[test]
    fn loops_are_joined_unless_they_turn_back_or_wait() {
        let graph = Graph::default();
        let [start, own, left] = [0, 1, 3].map(|number| graph.symbol(number, Stage::State));
        let first = turn(&graph, false, 2, start, own);
        let count = |second: Turn| join(&graph, &[first.clone(), second]).len();
        assert_eq!(count(turn(&graph, false, 4, start, own)), 1);
        assert_eq!(count(turn(&graph, true, 4, start, own)), 2);
        assert_eq!(count(turn(&graph, false, 4, left * own, own)), 2);
        assert_eq!(count(turn(&graph, false, 4, start, own * left)), 2);
        assert_eq!(count(Turn { repeat: RepeatId(1), ..turn(&graph, false, 4, start, own) }), 2);
    }

    #[test]
    fn joined_loops_are_waited_for_as_one_and_empty_ones_are_none() {
        let graph = Graph::default();
        let [start, own, left] = [0, 1, 5].map(|number| graph.symbol(number, Stage::State));
        let first = turn(&graph, false, 2, start, own);
        let second = turn(&graph, false, 4, start, own);
        let third = turn(&graph, false, 6, left, own);
        let carries = |turns: &[Turn]| -> Vec<usize> {
            join(&graph, turns).iter().map(|turn| turn.carries.len()).collect()
        };
        assert_eq!(carries(&[first.clone(), second.clone(), third]), [2, 1]);
        let empty = Turn { repeat: RepeatId(1), inwards: true, carries: Vec::new() };
        assert_eq!(carries(&[first, empty, second]), [2]);
    }
}
