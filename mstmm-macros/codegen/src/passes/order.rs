//! The order in which the terms of a sum are added up: those that are known first come first, so
//! that the next one is there when it is needed. A processor that has several operations under way
//! at once waits less.

use super::sums::Sums;
use super::{Images, Turn};
use crate::expr::{Edge, Expr, Graph, Node, NodeId, Stage};
use crate::math::Scalar;

/// How many cycles a processor takes until a result is there, about: addition, multiplication and
/// both in one; division; square root; sine, cosine and angle.
const ARITHMETIC: u32 = 4;
const DIVISION: u32 = 14;
const ROOT: u32 = 19;
const ANGLE: u32 = 60;

/// Sums of so many terms and more are added up in two halves, side by side.
const HALVED: usize = 6;

/// Rewrites everything that `results` need.
pub fn order(graph: &Graph, results: &[Edge], turns: &[Turn], parts: &[Option<usize>]) -> Images {
    let sums = Sums::of(graph, results, turns, parts);
    let mut pass = Order { graph, images: Images::new(graph), arrivals: Vec::new() };
    for id in sums.nodes() {
        let image = match sums.terms(id) {
            Some(terms) => {
                let terms = terms.into_iter().map(|term| pass.term(term, sums.factors(term, id)));
                in_order(terms.collect())
            }
            None => pass.images.over_images(graph, id),
        };
        pass.images.set(id, image, graph);
    }
    pass.images
}

struct Order<'g> {
    graph: &'g Graph,
    images: Images,
    /// When the nodes of the new formulas are known, in cycles; those of the old ones are among them.
    arrivals: Vec<u32>,
}

/// A term of a sum.
struct Term<'g> {
    value: Expr<'g>,
    /// When it can be added, in one operation with its product if it is one.
    ready: u32,
    is_product: bool,
}

impl<'g> Order<'g> {
    /// A term, and the factors that it is computed from for this sum alone.
    fn term(&mut self, edge: Edge, factors: Option<[Edge; 2]>) -> Term<'g> {
        let value = self.images.expr(self.graph, edge);
        let arrival = |pass: &mut Self, edge: Edge| match pass.images.expr(pass.graph, edge) {
            Expr::Formula(_, image) => pass.arrival(image.node()),
            Expr::Number(_) => 0,
        };
        let ready = match factors {
            Some([a, b]) => arrival(self, a).max(arrival(self, b)),
            None => arrival(self, edge),
        };
        Term { value, ready, is_product: factors.is_some() }
    }

    /// When a node is known.
    fn arrival(&mut self, node: NodeId) -> u32 {
        for id in self.arrivals.len() as NodeId..=node {
            let formula = self.graph.node(id);
            let operands = formula.operands().map(|edge| self.arrivals[edge.node() as usize]);
            let duration = match formula {
                _ if self.graph.stage(id) < Stage::State => 0,
                Node::Number(_) | Node::Symbol(_) => 0,
                Node::Sum(..) | Node::Product(..) | Node::CopySign(..) => ARITHMETIC,
                Node::Recip(_) | Node::RecipAbove(..) => DIVISION,
                Node::Sqrt(_) => ROOT,
                Node::Sin(_) | Node::Cos(_) | Node::Atan2(..) => ANGLE,
            };
            self.arrivals.push(operands.max().unwrap_or(0) + duration);
        }
        self.arrivals[node as usize]
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
