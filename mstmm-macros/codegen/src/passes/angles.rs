//! Sines and cosines that can be computed side by side.

use super::{Live, Region, Regions};
use crate::expr::{Graph, Node, NodeId, Stage};
use std::collections::HashMap;

/// Angles by how many sines and cosines deep they lie, and by where they are computed.
pub(super) type Angles = HashMap<(u32, Region), Vec<NodeId>>;

/// The live angles by depth and region, and every live node's depth: how many sines and cosines are
/// nested.
pub(super) fn angles(
    graph: &Graph,
    live: &Live,
    regions: &Regions,
    stage: Stage,
) -> (Angles, Vec<u32>) {
    let mut depths = vec![0; graph.len()];
    let mut angles = Angles::new();
    for &id in live.nodes() {
        let node = graph.node(id);
        if stage == Stage::State && graph.stage(id) < Stage::State {
            continue;
        }
        let below = node.operands().map(|edge| depths[edge.node() as usize]).max().unwrap_or(0);
        depths[id as usize] = below;
        if let Node::Sin(angle) | Node::Cos(angle) = node {
            depths[id as usize] = below + 1;
            let group = angles.entry((below + 1, regions.region(id))).or_default();
            if !group.contains(&angle.node()) {
                group.push(angle.node());
            }
        }
    }
    (angles, depths)
}
