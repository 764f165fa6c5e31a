//! Ball: a unit quaternion (w, x, y, z), and an angular velocity in rad/s.

use super::{Group, Shape, View, one, quaternion, zero};

pub(super) const SHAPE: Shape = Shape {
    word: "ball",
    coordinates: &[one("qw"), zero("qx"), zero("qy"), zero("qz")],
    rates: &["wx", "wy", "wz"],
    groups: &[quaternion(0)],
    view: Some(View { name: "BallState", groups: &[Group::Coordinates(0..4), Group::Rates(0..3)] }),
};
