//! Floating: a place in m and a unit quaternion (w, x, y, z); a velocity in m/s and an angular
//! velocity in rad/s.

use super::{Group, Results, Shape, View, one, zero};

pub(super) const SHAPE: Shape = Shape {
    word: "floating",
    coordinates: &[zero("x"), zero("y"), zero("z"), one("qw"), zero("qx"), zero("qy"), zero("qz")],
    rates: &["vx", "vy", "vz", "wx", "wy", "wz"],
    view: Some(View {
        name: "FloatingState",
        groups: &[
            Group::Coordinates(0..3),
            Group::Coordinates(3..7),
            Group::Rates(0..3),
            Group::Rates(3..6),
        ],
    }),
    // Implied hinges have no results of their own: their body has.
    results: Results::Nothing,
    effort: "",
};
