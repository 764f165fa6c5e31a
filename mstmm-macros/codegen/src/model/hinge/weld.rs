//! Weld: no numbers.

use super::{Results, Shape};

pub(super) const SHAPE: Shape = Shape {
    word: "weld",
    coordinates: &[],
    rates: &[],
    view: None,
    results: Results::Nothing,
    effort: "",
};
