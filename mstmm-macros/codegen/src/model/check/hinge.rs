//! Hinges.

use crate::diag::Diagnostics;
use crate::model::lower::{Draft, Stop};
use crate::model::{HingeKind, Value};

/// An axis of zeros points nowhere.
pub(super) fn axes_have_a_direction(draft: &Draft, diagnostics: &mut Diagnostics) {
    for stop in &draft.stops {
        let Stop::Hinge { frees: Some(frees), .. } = stop else { continue };
        let HingeKind::Pin { axis } = &frees.value else { continue };
        if axis.iter().all(Value::is_zero) {
            diagnostics.error_over(frees.at, "an axis of zeros has no direction");
        }
    }
}
