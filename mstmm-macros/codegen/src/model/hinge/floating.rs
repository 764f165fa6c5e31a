//! Floating: a position in m and a unit quaternion (w, x, y, z); a velocity in m/s and an angular
//! velocity in rad/s.

use super::spec::{HingeSpec, StateView, ViewArgument, one, quaternion, translations, zero};

pub(super) const SPEC: HingeSpec = HingeSpec {
    word: "floating",
    coordinates: &[zero("x"), zero("y"), zero("z"), one("qw"), zero("qx"), zero("qy"), zero("qz")],
    rates: &["vx", "vy", "vz", "wx", "wy", "wz"],
    groups: &[translations(3), quaternion(3)],
    view: Some(StateView {
        name: "FloatingState",
        groups: &[
            ViewArgument::Coordinates(0..3),
            ViewArgument::Coordinates(3..7),
            ViewArgument::Rates(0..3),
            ViewArgument::Rates(3..6),
        ],
    }),
};
