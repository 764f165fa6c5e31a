//! Slider: a displacement in m.

use super::spec::{HingeSpec, StateView, ViewArgument, translations, zero};

pub(super) const SPEC: HingeSpec = HingeSpec {
    word: "slider",
    coordinates: &[zero("position")],
    rates: &["velocity"],
    groups: &[translations(1)],
    view: Some(StateView {
        name: "SliderState",
        groups: &[ViewArgument::Coordinates(0..1), ViewArgument::Rates(0..1)],
    }),
};
