//! Cylindrical: a displacement in m and an angle in rad.

use super::{HingeSpec, StateView, ViewArgument, shifts, turns, zero};

pub(super) const SHAPE: HingeSpec = HingeSpec {
    word: "cylindrical",
    coordinates: &[zero("way"), zero("angle")],
    rates: &["velocity", "rate"],
    groups: &[shifts(1), turns(1, 1)],
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
