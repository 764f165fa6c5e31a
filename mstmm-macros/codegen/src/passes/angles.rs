//! Groups sines and cosines that can be computed in one statement.

use super::{Live, Region, Regions};
use crate::expr::{Graph, Node, NodeId, Stage};
use std::collections::HashMap;

/// The angles by nesting depth of sines and cosines, and by region.
pub(super) type Angles = HashMap<(u32, Region), Vec<NodeId>>;

/// Returns the live angles by depth and region, and the depth of every live node: the number of sines and cosines that
/// are nested in it.
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
        let mut below = 0;
        for operand in node.operands() {
            below = below.max(depths[operand.node() as usize]);
        }
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
