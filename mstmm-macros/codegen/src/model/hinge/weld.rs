//! Weld: nothing.

use super::Shape;

pub(super) const SHAPE: Shape =
    Shape { word: "weld", coordinates: &[], rates: &[], groups: &[], view: None };
