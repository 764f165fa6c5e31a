//! `ball name`: turns any way.

use super::{Kind, Takes};
use crate::model::{Dimension, HingeKind};

pub(super) const KIND: Kind = Kind {
    word: "ball",
    name: "a ball",
    plain: |space| (space == Dimension::Space).then_some(HingeKind::Ball),
    takes: Takes::Nothing,
};
