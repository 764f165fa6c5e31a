//! Planar: two displacements in m and an angle in rad.

use super::{HingeSpec, StateView, ViewArgument, shifts, turns, zero};

pub(super) const SHAPE: HingeSpec = HingeSpec {
    word: "planar",
    coordinates: &[zero("way1"), zero("way2"), zero("angle")],
    rates: &["velocity1", "velocity2", "rate"],
    groups: &[shifts(2), turns(2, 1)],
    view: Some(StateView {
        name: "PlanarState",
        groups: &[
            ViewArgument::Coordinates(0..2),
            ViewArgument::Coordinates(2..3),
            ViewArgument::Rates(0..2),
            ViewArgument::Rates(2..3),
        ],
    }),
};
