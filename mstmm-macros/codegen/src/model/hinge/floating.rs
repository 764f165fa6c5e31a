//! Floating: a place in m and a unit quaternion (w, x, y, z); a velocity in m/s and an angular
//! velocity in rad/s.

use super::{Group, Shape, View, one, quaternion, shifts, zero};

pub(super) const SHAPE: Shape = Shape {
    word: "floating",
    coordinates: &[zero("x"), zero("y"), zero("z"), one("qw"), zero("qx"), zero("qy"), zero("qz")],
    rates: &["vx", "vy", "vz", "wx", "wy", "wz"],
    groups: &[shifts(3), quaternion(3)],
    view: Some(View {
        name: "FloatingState",
        groups: &[
            Group::Coordinates(0..3),
            Group::Coordinates(3..7),
            Group::Rates(0..3),
            Group::Rates(3..6),
        ],
    }),
};
