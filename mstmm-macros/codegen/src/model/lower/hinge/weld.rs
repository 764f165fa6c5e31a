//! `weld name`: lets nothing free.

use super::{Kind, Takes};
use crate::model::HingeKind;

pub(super) const KIND: Kind =
    Kind { word: "weld", name: "a weld", plain: |_| Some(HingeKind::Weld), takes: Takes::Nothing };
