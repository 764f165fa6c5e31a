//! `elastic name`: all degrees of freedom of the dimension, meant for springs.

use super::axis::unit;
use super::{ArgumentRule, Kind};
use crate::model::{Dimension, HingeKind};

pub(super) const KIND: Kind = Kind {
    word: "elastic",
    name: "an elastic hinge",
    plain: |space| {
        Some(match space {
            Dimension::Space => HingeKind::Elastic,
            Dimension::Plane => HingeKind::PlaneElastic,
            Dimension::Line => HingeKind::Slider { axis: unit(0) },
        })
    },
    takes: ArgumentRule::Nothing,
};
