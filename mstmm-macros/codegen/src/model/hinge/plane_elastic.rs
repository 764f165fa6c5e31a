//! Elastic in the plane: a displacement in m and an angle in rad; a velocity in m/s and an angular
//! velocity in rad/s.

use super::spec::{HingeSpec, StateView, ViewArgument, displacements, rotations, zero};

pub(super) const SPEC: HingeSpec = HingeSpec {
    word: "elastic",
    coordinates: &[zero("x"), zero("y"), zero("angle")],
    rates: &["vx", "vy", "rate"],
    groups: &[displacements(2), rotations(2, 1)],
    view: Some(StateView {
        name: "PlaneElasticState",
        groups: &[
            ViewArgument::Coordinates(0..2),
            ViewArgument::Coordinates(2..3),
            ViewArgument::Rates(0..2),
            ViewArgument::Rates(2..3),
        ],
    }),
};
