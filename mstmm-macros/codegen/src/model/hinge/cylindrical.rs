//! Cylindrical: a way in m and an angle in rad.

use super::{Group, Shape, View, shifts, turns, zero};

pub(super) const SHAPE: Shape = Shape {
    word: "cylindrical",
    coordinates: &[zero("way"), zero("angle")],
    rates: &["velocity", "rate"],
    groups: &[shifts(1), turns(1, 1)],
    view: Some(View {
        name: "CylindricalState",
        groups: &[
            Group::Coordinates(0..1),
            Group::Coordinates(1..2),
            Group::Rates(0..1),
            Group::Rates(1..2),
        ],
    }),
};
