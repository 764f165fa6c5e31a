//! `floating name`: all degrees of freedom of the dimension.

use super::axis::unit;
use super::{ArgumentRule, Kind};
use crate::model::{Dimension, HingeKind};

pub(super) const KIND: Kind = Kind {
    word: "floating",
    name: "a floating hinge",
    plain: |space| Some(of_everything(space)),
    takes: ArgumentRule::Nothing,
};

/// Returns the hinge with all degrees of freedom of this dimension.
pub(crate) fn of_everything(space: Dimension) -> HingeKind {
    match space {
        Dimension::Space => HingeKind::Floating,
        Dimension::Plane => HingeKind::Planar { normal: 2 },
        Dimension::Line => HingeKind::Slider { axis: unit(0) },
    }
}
