//! Slider: a way in m.

use super::{Group, Shape, View, shifts, zero};

pub(super) const SHAPE: Shape = Shape {
    word: "slider",
    coordinates: &[zero("way")],
    rates: &["velocity"],
    groups: &[shifts(1)],
    view: Some(View {
        name: "SliderState",
        groups: &[Group::Coordinates(0..1), Group::Rates(0..1)],
    }),
};
