//! Slider: a displacement in m.

use super::{HingeSpec, StateView, ViewArgument, shifts, zero};

pub(super) const SHAPE: HingeSpec = HingeSpec {
    word: "slider",
    coordinates: &[zero("way")],
    rates: &["velocity"],
    groups: &[shifts(1)],
    view: Some(StateView {
        name: "SliderState",
        groups: &[ViewArgument::Coordinates(0..1), ViewArgument::Rates(0..1)],
    }),
};
