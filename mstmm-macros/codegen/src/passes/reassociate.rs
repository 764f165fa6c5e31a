//! Orders the terms of sums by the time at which they are ready, so that a processor that runs several operations at once
//! waits less for the next term.

use super::flatten_sums::Sums;
use super::ready_times::ReadyTimes;
use super::{Images, Region};
use crate::expr::{Edge, Expr, Graph, NodeId};
use crate::function::Function;
use crate::math::Scalar;

/// Orders the terms of all sums of a function.
pub fn reassociate(function: Function) -> Function {
    let graph = function.graph;
    let sums = Sums::of(&function);
    let nodes: Vec<NodeId> = sums.nodes().collect();
    let ready_times = ReadyTimes::of(graph, &nodes, |id| sums.region(id));
    let mut pass = Reassociation { graph, images: Images::new(graph), ready_times };
    for id in nodes {
        let image = match sums.terms(id) {
            Some(terms) => {
                let region = sums.region(id);
                let term = |term: Edge| pass.term(term, sums.factors(term, id), region);
                let terms = terms.into_iter().map(term);
                in_order(terms.collect())
            }
            None => pass.images.over_images(graph, id),
        };
        if let Expr::Formula(_, edge) = image {
            pass.ready_times.follow(edge.node(), sums.region(id));
        }
        pass.images.set(id, image, graph);
    }
    pass.images.apply(function)
}

struct Reassociation<'g> {
    graph: &'g Graph,
    images: Images,
    /// The ready times of old and new formulas.
    ready_times: ReadyTimes<'g>,
}

/// A term of a sum.
struct TimedTerm<'g> {
    value: Expr<'g>,
    due: Due,
}

/// The time at which a term can be added. A product is fused with the addition, so that it is due when its factors are
/// ready. Of terms that are due at the same time, products come last.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Due {
    ready: u32,
    is_product: bool,
}

impl<'g> Reassociation<'g> {
    /// Returns a term of a sum in `region`; `factors` are those of a product that only this sum uses.
    fn term(&self, edge: Edge, factors: Option<[Edge; 2]>, region: Region) -> TimedTerm<'g> {
        let value = self.images.expr(self.graph, edge);
        let ready_at = |edge: Edge| match self.images.expr(self.graph, edge) {
            Expr::Formula(_, image) => self.ready_times.at(region, image.node()),
            Expr::Number(_) => 0,
        };
        let ready = match factors {
            Some([a, b]) => ready_at(a).max(ready_at(b)),
            None => ready_at(edge),
        };
        TimedTerm { value, due: Due { ready, is_product: factors.is_some() } }
    }
}

/// Adds the terms, the earliest ready first.
fn in_order(mut terms: Vec<TimedTerm>) -> Expr {
    terms.sort_by_key(|term| term.due);
    let values = terms.into_iter().map(|term| term.value);
    values.reduce(|sum, value| sum + value).unwrap_or_else(Expr::zero)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expr::Stage;
    use crate::ids::SymbolId;

    #[test]
    fn terms_are_added_by_ready_time_products_last() {
        let graph = Graph::default();
        let term = |symbol, ready, is_product| TimedTerm {
            value: graph.symbol(SymbolId(symbol), Stage::State),
            due: Due { ready, is_product },
        };
        let ordered = in_order(vec![term(0, 9, false), term(1, 4, true), term(2, 4, false)]);
        let [late, product, other] = [0, 1, 2].map(|k| graph.symbol(SymbolId(k), Stage::State));
        assert_eq!(graph.edge(ordered), graph.edge(other + product + late));
    }
}
