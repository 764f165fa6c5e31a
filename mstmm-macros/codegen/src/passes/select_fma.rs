//! Selects the products that are fused with the sum that they are a term of.

use super::ready_times::ReadyTimes;
use super::{Live, Regions};
use crate::expr::{Edge, Graph, Node, Stage};

/// Returns, for each node, whether it is a product that is fused with the only sum that uses it.
///
/// Each sum is fused with at most one product: of two, the product that is ready later. Sum and product must be in the same
/// region. A product that is known before `stage` is read from a slot and not fused.
pub(super) fn fused(graph: &Graph, live: &Live, regions: &Regions, stage: Stage) -> Vec<bool> {
    let mut fused = vec![false; graph.len()];
    let times = ReadyTimes::of(graph, live.nodes(), |id| regions.region(id));
    for &id in live.nodes() {
        let Node::Sum(a, b) = graph.node(id) else { continue };
        let belongs = |term: Edge| {
            let node = term.node();
            matches!(graph.node(node), Node::Product(..))
                && live.uses(node) == 1
                && (stage < Stage::State || graph.stage(node) == stage)
                && regions.region(node) == regions.region(id)
        };
        let ready = |term: Edge| times.at(regions.region(id), term.node());
        let term = match (belongs(a), belongs(b)) {
            (true, true) if ready(a) > ready(b) => a,
            (_, true) => b,
            (true, false) => a,
            (false, false) => continue,
        };
        fused[term.node() as usize] = true;
    }
    fused
}
