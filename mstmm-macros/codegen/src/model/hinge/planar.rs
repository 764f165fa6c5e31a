//! Planar: two displacements in m and an angle in rad.

use super::spec::{HingeSpec, StateView, ViewArgument, rotations, translations, zero};

pub(super) const SPEC: HingeSpec = HingeSpec {
    word: "planar",
    coordinates: &[zero("way1"), zero("way2"), zero("angle")],
    rates: &["velocity1", "velocity2", "rate"],
    groups: &[translations(2), rotations(2, 1)],
    view: Some(StateView {
        name: "PlanarState",
        groups: &[
            ViewArgument::Coordinates(0..2),
            ViewArgument::Coordinates(2..3),
            ViewArgument::Rates(0..2),
            ViewArgument::Rates(2..3),
        ],
    }),
};
