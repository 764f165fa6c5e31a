//! Ball: a unit quaternion (w, x, y, z), and an angular velocity in rad/s.

use super::spec::{HingeSpec, StateView, ViewArgument, one, quaternion, zero};

pub(super) const SPEC: HingeSpec = HingeSpec {
    word: "ball",
    coordinates: &[one("qw"), zero("qx"), zero("qy"), zero("qz")],
    rates: &["wx", "wy", "wz"],
    groups: &[quaternion(0)],
    view: Some(StateView {
        name: "BallState",
        groups: &[ViewArgument::Coordinates(0..4), ViewArgument::Rates(0..3)],
    }),
};
