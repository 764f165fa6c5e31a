//! Universal: two angles in rad.

use super::{Group, Shape, View, turns, zero};

pub(super) const SHAPE: Shape = Shape {
    word: "universal",
    coordinates: &[zero("angle1"), zero("angle2")],
    rates: &["rate1", "rate2"],
    groups: &[turns(0, 2)],
    view: Some(View {
        name: "UniversalState",
        groups: &[Group::Coordinates(0..2), Group::Rates(0..2)],
    }),
};
