//! Universal: two angles in rad.

use super::spec::{HingeSpec, StateView, ViewArgument, rotations, zero};

pub(super) const SPEC: HingeSpec = HingeSpec {
    word: "universal",
    coordinates: &[zero("angle1"), zero("angle2")],
    rates: &["rate1", "rate2"],
    groups: &[rotations(0, 2)],
    view: Some(StateView {
        name: "UniversalState",
        groups: &[ViewArgument::Coordinates(0..2), ViewArgument::Rates(0..2)],
    }),
};
