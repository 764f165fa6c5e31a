//! The order in which the terms of a sum are added up: those that are known first come first, so
//! that the next one is there when it is needed. A processor that has several operations under way
//! at once waits less.

use super::arrivals::Arrivals;
use super::sums::Sums;
use super::{Home, Images, Turn};
use crate::expr::{Edge, Expr, Graph, NodeId};
use crate::math::Scalar;

/// Sums of so many terms and more are added up in two halves, side by side.
const HALVED: usize = 6;

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
