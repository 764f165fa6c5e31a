//! The order in which the terms of a sum are added up: terms that are known first come first. A processor
//! that runs several operations at once then waits less for the next term.

use super::arrivals::Arrivals;
use super::sums::Sums;
use super::{Home, Images, Turn};
use crate::expr::{Edge, Expr, Graph, NodeId};
use crate::ids::RepeatId;
use crate::math::Scalar;

/// Rewrites everything that `results` need.
pub fn order(
    graph: &Graph,
    results: &[Edge],
    turns: &[Turn],
    parts: &[Option<RepeatId>],
) -> Images {
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

/// When a term can be added. A product is added in one operation with its multiplication, so that it is
/// due when its factors are ready; at the same time what is no product comes first.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Due {
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
        Term { value, due: Due { ready, is_product: factors.is_some() } }
    }
}

/// The sum of terms, those that are ready earlier first.
fn in_order(mut terms: Vec<Term>) -> Expr {
    terms.sort_by_key(|term| term.due);
    let values = terms.into_iter().map(|term| term.value);
    values.reduce(|sum, value| sum + value).unwrap_or_else(Expr::zero)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expr::Stage;

    #[test]
    fn terms_that_are_ready_first_come_first_and_products_after_others() {
        let graph = Graph::default();
        let term = |number: u32, ready, is_product| Term {
            value: graph.symbol(number, Stage::State),
            due: Due { ready, is_product },
        };
        let ordered = in_order(vec![term(0, 9, false), term(1, 4, true), term(2, 4, false)]);
        let [late, product, other] = [0, 1, 2].map(|number| graph.symbol(number, Stage::State));
        assert_eq!(graph.edge(ordered), graph.edge(other + product + late));
    }
}
