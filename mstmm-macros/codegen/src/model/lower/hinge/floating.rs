//! `floating name`: lets everything free that the chain's dimension has.

use super::axis::unit;
use super::{ArgumentRule, Kind};
use crate::model::{Dimension, HingeKind};

pub(super) const KIND: Kind = Kind {
    word: "floating",
    name: "a floating hinge",
    plain: |space| Some(of_everything(space)),
    takes: ArgumentRule::Nothing,
};

/// The hinge that lets everything free in a chain of this dimension.
pub(crate) fn of_everything(space: Dimension) -> HingeKind {
    match space {
        Dimension::Space => HingeKind::Floating,
        Dimension::Plane => HingeKind::Planar { normal: 2 },
        Dimension::Line => HingeKind::Slider { axis: unit(0) },
    }
}
