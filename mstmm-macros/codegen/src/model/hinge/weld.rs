//! Weld: no coordinates.

use super::HingeSpec;

pub(super) const SHAPE: HingeSpec =
    HingeSpec { word: "weld", coordinates: &[], rates: &[], groups: &[], view: None };
