//! Factors common factors out of sums: `a b + a c + … = a (b + c + …)`, if no product is used elsewhere. Each product but
//! the first saves a multiplication.

use super::Images;
use super::flatten_sums::Sums;
use crate::expr::{Edge, Expr, Graph, NodeId};
use crate::function::Function;
use crate::math::Scalar;

/// Factors common factors out of all sums of a function.
pub fn factor(function: Function) -> Function {
    let graph = function.graph;
    let sums = Sums::of(&function);
    let mut images = Images::new(graph);
    for id in sums.nodes() {
        let image = match sums.terms(id) {
            Some(terms) => {
                let terms = terms.iter().map(|&term| SumTerm::of(&sums, &images, term, id));
                sum(graph, terms.collect())
            }
            None => images.over_images(graph, id),
        };
        images.set(id, image, graph);
    }
    images.apply(function)
}

/// A term of a sum.
#[derive(Clone, Copy)]
enum SumTerm {
    /// A product that nothing else uses; the second factor has the sign.
    Product(Edge, Edge),
    /// Any other term.
    Other(Edge),
}

impl SumTerm {
    fn of(sums: &Sums, images: &Images, term: Edge, id: NodeId) -> Self {
        let go = |edge: Edge| images.edge(edge).unwrap_or(edge);
        match sums.factors(term, id) {
            Some([a, b]) => {
                SumTerm::Product(go(a), if term.is_negative() { go(b).negated() } else { go(b) })
            }
            None => SumTerm::Other(go(term)),
        }
    }

    fn value(self, graph: &Graph) -> Expr<'_> {
        match self {
            SumTerm::Product(a, b) => graph.expr(a) * graph.expr(b),
            SumTerm::Other(value) => graph.expr(value),
        }
    }

    /// Returns whether the term is a product that contains a factor or its negative.
    fn has(self, factor: Edge) -> bool {
        match self {
            SumTerm::Product(a, b) => a.node() == factor.node() || b.node() == factor.node(),
            SumTerm::Other(_) => false,
        }
    }

    /// Divides a product by one of its factors or by the negative of one; none if the term is no such product.
    fn without(self, factor: Edge) -> Option<Edge> {
        let SumTerm::Product(a, b) = self else { return None };
        [(a, b), (b, a)].into_iter().find_map(|(one, other)| {
            (one.node() == factor.node())
                .then(|| if one == factor { other } else { other.negated() })
        })
    }
}

/// Adds the terms, after factoring out the factor that most of them share.
fn sum(graph: &Graph, terms: Vec<SumTerm>) -> Expr<'_> {
    match shared_factor(&terms) {
        Some(factor) => {
            let rests = terms.iter().filter_map(|term| term.without(factor)).map(SumTerm::Other);
            let product = graph.expr(factor) * sum(graph, rests.collect());
            let others = terms.iter().filter(|term| !term.has(factor)).copied();
            sum(graph, others.chain([SumTerm::Other(graph.edge(product))]).collect())
        }
        None => {
            let values = terms.into_iter().map(|term| term.value(graph));
            values.reduce(|a, b| a + b).unwrap_or_else(Expr::zero)
        }
    }
}

/// Returns the factor of most products, the first of several, if any is in more than one product.
fn shared_factor(terms: &[SumTerm]) -> Option<Edge> {
    let (mut shared, mut most) = (None, 1);
    for term in terms {
        let SumTerm::Product(a, b) = *term else { continue };
        for factor in [a, b] {
            let count = terms.iter().filter(|term| term.has(factor)).count();
            if count > most {
                (shared, most) = (Some(factor), count);
            }
        }
    }
    shared
}
