//! Pin: an angle in rad.

use super::{Group, Results, Shape, View, zero};

pub(super) const SHAPE: Shape = Shape {
    word: "pin",
    coordinates: &[zero("angle")],
    rates: &["rate"],
    view: Some(View { name: "PinState", groups: &[Group::Coordinates(0..1), Group::Rates(0..1)] }),
    results: Results::Number,
    effort: "Torque in N m",
};
