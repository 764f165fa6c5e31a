//! Pin: an angle in rad.

use super::{HingeSpec, StateView, ViewArgument, turns, zero};

pub(super) const SHAPE: HingeSpec = HingeSpec {
    word: "pin",
    coordinates: &[zero("angle")],
    rates: &["rate"],
    groups: &[turns(0, 1)],
    view: Some(StateView {
        name: "PinState",
        groups: &[ViewArgument::Coordinates(0..1), ViewArgument::Rates(0..1)],
    }),
};
