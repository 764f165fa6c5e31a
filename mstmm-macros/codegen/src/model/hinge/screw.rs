//! Screw: an angle in rad.

use super::{Group, Shape, View, turns, zero};

pub(super) const SHAPE: Shape = Shape {
    word: "screw",
    coordinates: &[zero("angle")],
    rates: &["rate"],
    groups: &[turns(0, 1)],
    view: Some(View {
        name: "ScrewState",
        groups: &[Group::Coordinates(0..1), Group::Rates(0..1)],
    }),
};
