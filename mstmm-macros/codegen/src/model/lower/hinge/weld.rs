//! `weld name`: no degrees of freedom.

use super::{ArgumentRule, Kind};
use crate::model::HingeKind;

pub(super) const KIND: Kind = Kind {
    word: "weld",
    name: "a weld",
    plain: |_| Some(HingeKind::Weld),
    takes: ArgumentRule::Nothing,
};
