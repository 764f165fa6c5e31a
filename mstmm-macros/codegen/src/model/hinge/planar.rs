//! Planar: two ways in m and an angle in rad.

use super::{Group, Shape, View, shifts, turns, zero};

pub(super) const SHAPE: Shape = Shape {
    word: "planar",
    coordinates: &[zero("way1"), zero("way2"), zero("angle")],
    rates: &["velocity1", "velocity2", "rate"],
    groups: &[shifts(2), turns(2, 1)],
    view: Some(View {
        name: "PlanarState",
        groups: &[
            Group::Coordinates(0..2),
            Group::Coordinates(2..3),
            Group::Rates(0..2),
            Group::Rates(2..3),
        ],
    }),
};
