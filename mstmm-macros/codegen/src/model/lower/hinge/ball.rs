//! `ball name`: all rotations.

use super::{ArgumentRule, Kind};
use crate::model::{Dimension, HingeKind};

pub(super) const KIND: Kind = Kind {
    word: "ball",
    name: "a ball",
    plain: |space| (space == Dimension::Space).then_some(HingeKind::Ball),
    takes: ArgumentRule::Nothing,
};
