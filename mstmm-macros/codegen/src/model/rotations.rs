//! The coordinates that are rotations, for corrections of closed chains.

use super::{Chain, DofGroup, Hinge, HingeKind, Layout, Representation};
use std::ops::Range;

/// Consecutive coordinates of a hinge that are a rotation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RotationCoordinates {
    /// Their indices in the layout.
    pub coordinates: Range<usize>,
    /// Whether they are a quaternion, whose components change by half the angle.
    pub quaternion: bool,
}

/// Returns all coordinates that are rotations and not prescribed. A screw may need many turns, which its translation limits.
pub fn rotation_coordinates(chain: &Chain, layout: &Layout) -> Vec<RotationCoordinates> {
    let rotates =
        |hinge: &Hinge| !hinge.is_prescribed() && !matches!(hinge.kind, HingeKind::Screw { .. });
    let hinges = chain.hinges.enumerate().filter(|(_, hinge)| rotates(hinge));
    let all = hinges.flat_map(|(id, hinge)| {
        let groups = hinge.kind.spec().groups.iter().filter(|group| group.rotational);
        groups.map(move |group: &DofGroup| {
            let Range { start, end } = group.coordinates;
            let first = layout.q[id].start;
            RotationCoordinates {
                coordinates: first + start..first + end,
                quaternion: group.representation == Representation::Quaternion,
            }
        })
    });
    all.collect()
}
