//! The order in which the terms of a sum are added up: those that are known first come first, so
//! that the next one is there when it is needed. A processor that has several operations under way
//! at once waits less.

use super::latency::{MULTIPLICATION, of_node};
use super::sums::Sums;
use super::{Home, Images, Turn};
use crate::expr::{Edge, Expr, Graph, Node, NodeId, Stage};
use crate::math::Scalar;

/// Sums of so many terms and more are added up in two halves, side by side.
const HALVED: usize = 6;

/// Rewrites everything that `results` need.
pub fn order(graph: &Graph, results: &[Edge], turns: &[Turn], parts: &[Option<usize>]) -> Images {
    let sums = Sums::of(graph, results, turns, parts);
    let mut pass =
        Order { graph, images: Images::new(graph), arrivals: Arrivals::new(graph, &sums) };
    for id in sums.nodes() {
        let image = match sums.terms(id) {
            Some(terms) => {
                let home = sums.home(id);
                let term = |term: Edge| pass.term(term, sums.factors(term, id), home);
                let terms = terms.into_iter().map(term);
                in_order(terms.collect())
            }
            None => pass.images.over_images(graph, id),
        };
        pass.arrivals.follow(sums.home(id));
        pass.images.set(id, image, graph);
    }
    pass.images
}

struct Order<'g> {
    graph: &'g Graph,
    images: Images,
    arrivals: Arrivals<'g>,
}

/// A term of a sum.
struct Term<'g> {
    value: Expr<'g>,
    /// When it can be added, in one operation with its product if it is one.
    ready: u32,
    is_product: bool,
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
        Term { value, ready, is_product: factors.is_some() }
    }
}

/// When the nodes of the new formulas are known, in cycles from the beginning of the time of a loop that
/// computes them; those of the old ones are among them.
struct Arrivals<'g> {
    graph: &'g Graph,
    all: Vec<(Home, u32)>,
}

impl<'g> Arrivals<'g> {
    /// Of formulas that are still to be rewritten.
    fn new(graph: &'g Graph, sums: &Sums) -> Self {
        let mut arrivals = Arrivals { graph, all: Vec::new() };
        for id in 0..graph.len() as NodeId {
            arrivals.add(id, sums.home(id));
        }
        arrivals
    }

    /// When a node is known at `home`: from the beginning, if it is computed elsewhere.
    fn at(&self, home: Home, node: NodeId) -> u32 {
        let (own, arrival) = self.all[node as usize];
        if own == home { arrival } else { 0 }
    }

    /// Takes down the nodes that are new, which are computed at `home`.
    fn follow(&mut self, home: Home) {
        for id in self.all.len()..self.graph.len() {
            self.add(id as NodeId, home);
        }
    }

    fn add(&mut self, id: NodeId, home: Home) {
        let arrival = self.arrival(id, home);
        self.all.push((home, arrival));
    }

    fn arrival(&self, id: NodeId, home: Home) -> u32 {
        let formula = self.graph.node(id);
        if self.graph.stage(id) < Stage::State {
            return 0;
        }
        let known = |edge: Edge| self.at(home, edge.node());
        let is_product = |edge: &Edge| matches!(self.graph.node(edge.node()), Node::Product(..));
        match formula {
            // One product is computed with the sum.
            Node::Sum(a, b) if is_product(&b) => {
                known(a).max(known(b).saturating_sub(MULTIPLICATION)) + MULTIPLICATION
            }
            Node::Sum(a, b) if is_product(&a) => {
                known(b).max(known(a).saturating_sub(MULTIPLICATION)) + MULTIPLICATION
            }
            _ => formula.operands().map(known).max().unwrap_or(0) + of_node(&formula),
        }
    }
}

/// The sum of terms, those that are ready earlier first.
fn in_order(mut terms: Vec<Term>) -> Expr {
    // Where both are ready, what is no product comes first: the others are added with theirs.
    terms.sort_by_key(|term| (term.ready, term.is_product));
    let halves = if terms.len() < HALVED { 1 } else { 2 };
    let half = |first: usize| total(terms.iter().skip(first).step_by(halves));
    (1..halves).fold(half(0), |sum, first| sum + half(first))
}

/// The terms one after the other.
fn total<'a, 'g: 'a>(terms: impl Iterator<Item = &'a Term<'g>>) -> Expr<'g> {
    terms.map(|term| term.value).reduce(|sum, value| sum + value).unwrap_or_else(Expr::zero)
}
