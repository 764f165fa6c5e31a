//! Weld: no coordinates.

use super::spec::HingeSpec;

pub(super) const SPEC: HingeSpec =
    HingeSpec { word: "weld", coordinates: &[], rates: &[], groups: &[], view: None };
