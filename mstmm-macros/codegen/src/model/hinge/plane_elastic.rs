//! Elastic in the plane: a displacement in m and an angle in rad; a velocity in m/s and an angular
//! velocity in rad/s.

use super::{Group, Shape, View, shifts, turns, zero};

pub(super) const SHAPE: Shape = Shape {
    word: "elastic",
    coordinates: &[zero("x"), zero("y"), zero("angle")],
    rates: &["vx", "vy", "rate"],
    groups: &[shifts(2), turns(2, 1)],
    view: Some(View {
        name: "PlaneElasticState",
        groups: &[
            Group::Coordinates(0..2),
            Group::Coordinates(2..3),
            Group::Rates(0..2),
            Group::Rates(2..3),
        ],
    }),
};
