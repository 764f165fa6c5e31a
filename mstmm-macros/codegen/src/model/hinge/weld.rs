//! Weld: no coordinates.

use super::HingeSpec;

pub(super) const SPEC: HingeSpec =
    HingeSpec { word: "weld", coordinates: &[], rates: &[], groups: &[], view: None };
