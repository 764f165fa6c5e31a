//! Cylindrical: a displacement in m and an angle in rad.

use super::spec::{HingeSpec, StateView, ViewArgument, rotations, translations, zero};

pub(super) const SPEC: HingeSpec = HingeSpec {
    word: "cylindrical",
    coordinates: &[zero("position"), zero("angle")],
    rates: &["velocity", "rate"],
    groups: &[translations(1), rotations(1, 1)],
    view: Some(StateView {
        name: "CylindricalState",
        groups: &[
            ViewArgument::Coordinates(0..1),
            ViewArgument::Coordinates(1..2),
            ViewArgument::Rates(0..1),
            ViewArgument::Rates(1..2),
        ],
    }),
};
