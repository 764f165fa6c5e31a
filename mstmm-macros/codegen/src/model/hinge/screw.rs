//! Screw: an angle in rad.

use super::spec::{HingeSpec, StateView, ViewArgument, rotations, zero};

pub(super) const SPEC: HingeSpec = HingeSpec {
    word: "screw",
    coordinates: &[zero("angle")],
    rates: &["rate"],
    groups: &[rotations(0, 1)],
    view: Some(StateView {
        name: "ScrewState",
        groups: &[ViewArgument::Coordinates(0..1), ViewArgument::Rates(0..1)],
    }),
};
