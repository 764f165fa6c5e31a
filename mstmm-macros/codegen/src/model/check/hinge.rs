//! Hinges.

use crate::diag::Diagnostics;
use crate::model::HingeKind;
use crate::model::lower::{Draft, Stop};

/// An axis of zeros points nowhere; parameters count with their defaults.
pub(super) fn axes_have_a_direction(draft: &Draft, diagnostics: &mut Diagnostics) {
    let defaults = draft.defaults();
    for stop in &draft.stops {
        let Stop::Hinge { frees: Some(frees), .. } = stop else { continue };
        let HingeKind::Pin { axis } = &frees.value else { continue };
        if axis.iter().all(|component| component.at(&defaults) == Some(0.0)) {
            diagnostics.error_over(frees.at, "an axis of zeros has no direction");
        }
    }
}
