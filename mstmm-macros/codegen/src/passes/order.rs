//! The order in which the terms of a sum are added up: those that are known first come first, so
//! that the next one is there when it is needed; and in two partial sums side by side where that is done
//! sooner. A processor that has several operations under way at once waits less.

use super::arrivals::Arrivals;
use super::latency::{ADDITION, MULTIPLICATION};
use super::sums::Sums;
use super::{Home, Images, Turn};
use crate::expr::{Edge, Expr, Graph, NodeId};
use crate::math::Scalar;
use std::cmp::Reverse;

/// Rewrites everything that `results` need.
pub fn order(graph: &Graph, results: &[Edge], turns: &[Turn], parts: &[Option<usize>]) -> Images {
    let sums = Sums::of(graph, results, turns, parts);
    let nodes: Vec<NodeId> = sums.nodes().collect();
    let arrivals = Arrivals::of(graph, &nodes, |id| sums.home(id));
    let mut pass = Order { graph, images: Images::new(graph), arrivals };
    for id in nodes {
        let image = match sums.terms(id) {
            Some(terms) => {
                let home = sums.home(id);
                let term = |term: Edge| pass.term(term, sums.factors(term, id), home);
                let terms = terms.into_iter().map(term);
                in_order(terms.collect())
            }
            None => pass.images.over_images(graph, id),
        };
        if let Expr::Formula(_, edge) = image {
            pass.arrivals.follow(edge.node(), sums.home(id));
        }
        pass.images.set(id, image, graph);
    }
    pass.images
}

struct Order<'g> {
    graph: &'g Graph,
    images: Images,
    /// Of the new formulas; the old ones are among them.
    arrivals: Arrivals<'g>,
}

/// A term of a sum.
struct Term<'g> {
    value: Expr<'g>,
    due: Due,
}

/// When a term or a partial sum can be added, in one operation with its product if it is one.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Due {
    ready: u32,
    is_product: bool,
}

impl Due {
    /// When both are added up.
    fn plus(self, other: Due) -> Due {
        let (first, last) = (self.min(other).ready, self.max(other).ready);
        let ready = match (self.is_product, other.is_product) {
            (true, true) => last.max(first + MULTIPLICATION) + MULTIPLICATION,
            (false, false) => last + ADDITION,
            _ => last + MULTIPLICATION,
        };
        Due { ready, is_product: false }
    }
}

impl<'g> Order<'g> {
    /// A term of a sum at `home`, and the factors that it is computed from for this sum alone.
    fn term(&self, edge: Edge, factors: Option<[Edge; 2]>, home: Home) -> Term<'g> {
        let value = self.images.expr(self.graph, edge);
        let arrival = |edge: Edge| match self.images.expr(self.graph, edge) {
            Expr::Formula(_, image) => self.arrivals.at(home, image.node()),
            Expr::Number(_) => 0,
        };
        let ready = match factors {
            Some([a, b]) => arrival(a).max(arrival(b)),
            None => arrival(edge),
        };
        Term { value, due: Due { ready, is_product: factors.is_some() } }
    }
}

/// The sum of terms, those that are ready earlier first.
fn in_order(mut terms: Vec<Term>) -> Expr {
    // Where both are ready, what is no product comes first: the others are added with theirs.
    terms.sort_by_key(|term| term.due);
    let total = |part: &Part| {
        let values = part.terms.iter().map(|&number| terms[number].value);
        values.reduce(|sum, value| sum + value)
    };
    let best = sooner(&terms);
    best.iter().filter_map(total).reduce(|sum, part| sum + part).unwrap_or_else(Expr::zero)
}

/// A partial sum: when it can be added to others, and the numbers of its terms.
struct Part {
    due: Due,
    terms: Vec<usize>,
}

/// Two partial sums of the terms if all are added up sooner so, one if not.
fn sooner(terms: &[Term]) -> Vec<Part> {
    let (one, two) = (parts(terms, 1), parts(terms, 2));
    if done(&two) < done(&one) { two } else { one }
}

/// Partial sums of the terms, so many at most. A term goes to the one that it waits for least, and of those
/// that are there already to the last.
fn parts(terms: &[Term], most: usize) -> Vec<Part> {
    let mut parts: Vec<Part> = Vec::new();
    for (number, &Term { due, .. }) in terms.iter().enumerate() {
        let wait = |part: &Part| part.due.ready.saturating_sub(due.ready);
        let room = parts.len() < most;
        let next = parts.iter_mut().min_by_key(|part| (wait(part), Reverse(part.due.ready)));
        match next.filter(|part| !room || wait(part) == 0) {
            Some(part) => {
                part.due = part.due.plus(due);
                part.terms.push(number);
            }
            None => parts.push(Part { due, terms: vec![number] }),
        }
    }
    parts
}

/// When all are added up.
fn done(parts: &[Part]) -> Option<u32> {
    parts.iter().map(|part| part.due).reduce(Due::plus).map(|total| total.ready)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// How many terms each partial sum has, of products whose factors are ready then, and when all are added up.
    fn added_up(ready: &[u32]) -> (Vec<usize>, Option<u32>) {
        let due = |&ready: &u32| Due { ready, is_product: true };
        let terms: Vec<Term> =
            ready.iter().map(due).map(|due| Term { value: Expr::Number(0.0), due }).collect();
        let best = sooner(&terms);
        (best.iter().map(|part| part.terms.len()).collect(), done(&best))
    }

    #[test]
    fn what_is_there_is_added_up_side_by_side_and_what_comes_late_last() {
        // Two products and their sum take two multiplications one after the other.
        assert_eq!(added_up(&[0, 0]), (vec![2], Some(8)));
        // One after the other they would take 16 cycles.
        assert_eq!(added_up(&[0, 0, 0, 0]), (vec![2, 2], Some(11)));
        // Nothing is gained where the others are added up until the last comes.
        assert_eq!(added_up(&[0, 0, 0, 20]), (vec![4], Some(24)));
        assert_eq!(added_up(&[0, 20, 20, 20, 20]), (vec![3, 2], Some(31)));
    }
}
