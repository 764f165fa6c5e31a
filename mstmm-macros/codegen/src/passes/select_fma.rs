//! Products that are computed in one operation with the sum that they are a term of.

use super::ready_times::ReadyTimes;
use super::{Live, Regions};
use crate::expr::{Edge, Graph, Node, Stage};

/// Which products are taken into the sum that alone uses them: one for every sum that has any, of two
/// the one whose factors are known later. Both must be computed at the same place; what is known earlier than `stage`
/// is no product but a number.
pub(super) fn fused(graph: &Graph, live: &Live, regions: &Regions, stage: Stage) -> Vec<bool> {
    let mut fused = vec![false; graph.len()];
    let times = ReadyTimes::of(graph, live.nodes(), |id| regions.region(id));
    for &id in live.nodes() {
        let Node::Sum(a, b) = graph.node(id) else { continue };
        let belongs = |term: &Edge| {
            let node = term.node();
            matches!(graph.node(node), Node::Product(..))
                && live.uses(node) == 1
                && (stage < Stage::State || graph.stage(node) == stage)
                && regions.region(node) == regions.region(id)
        };
        let ready = |term: &Edge| times.at(regions.region(id), term.node());
        if let Some(term) = [a, b].into_iter().filter(belongs).max_by_key(ready) {
            fused[term.node() as usize] = true;
        }
    }
    fused
}
