//! Gimbal: three angles in rad.

use super::spec::{HingeSpec, StateView, ViewArgument, rotations, zero};

pub(super) const SPEC: HingeSpec = HingeSpec {
    word: "gimbal",
    coordinates: &[zero("angle1"), zero("angle2"), zero("angle3")],
    rates: &["rate1", "rate2", "rate3"],
    groups: &[rotations(0, 3)],
    view: Some(StateView {
        name: "GimbalState",
        groups: &[ViewArgument::Coordinates(0..3), ViewArgument::Rates(0..3)],
    }),
};
