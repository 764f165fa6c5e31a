//! `a b + a c + … = a (b + c + …)` where no product is used elsewhere: a multiplication less for
//! each product but the first.

use super::Images;
use super::flatten_sums::Sums;
use crate::expr::{Edge, Expr, Graph, NodeId};
use crate::function::Function;
use crate::math::Scalar;

/// Takes shared factors out of all sums of a function.
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
    /// The factors of a product that nothing else uses, the sign in the second.
    Product(Edge, Edge),
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

    /// Whether it is a product of a factor or of the negative of it.
    fn has(self, factor: Edge) -> bool {
        match self {
            SumTerm::Product(a, b) => a.node() == factor.node() || b.node() == factor.node(),
            SumTerm::Other(_) => false,
        }
    }

    /// What is left of a product without a factor, which is one of its own or the negative of one.
    fn without(self, factor: Edge) -> Option<Edge> {
        let SumTerm::Product(a, b) = self else { return None };
        [(a, b), (b, a)].into_iter().find_map(|(one, other)| {
            (one.node() == factor.node())
                .then(|| if one == factor { other } else { other.negated() })
        })
    }
}

/// The sum of some terms, the factor that most of them share taken out first.
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

/// The factor of most products, the first of several, if any is in more than one.
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
