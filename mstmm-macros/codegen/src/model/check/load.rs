//! What acts on bodies from outside.

use crate::diag::Diagnostics;
use crate::model::lower::{Draft, listed};

/// A load acts on a body, by a force or a torque.
pub(super) fn loads_are_complete(draft: &Draft, diagnostics: &mut Diagnostics) {
    for load in &draft.loads {
        let missing = load.missing();
        if !missing.is_empty() {
            let message = format!("load `{}` needs {}", load.name, listed(&missing));
            diagnostics.error(load.name.span(), message);
        }
    }
}

/// A spring joins a body to a point on the ground, and is stiff.
pub(super) fn springs_are_complete(draft: &Draft, diagnostics: &mut Diagnostics) {
    for spring in &draft.springs {
        let missing = spring.missing();
        if !missing.is_empty() {
            let message = format!("spring `{}` needs {}", spring.name, listed(&missing));
            diagnostics.error(spring.name.span(), message);
        }
    }
}

/// No spring has a negative stiffness, damping or length; parameters count with their defaults.
pub(super) fn spring_numbers_are_not_negative(draft: &Draft, diagnostics: &mut Diagnostics) {
    let defaults = draft.defaults();
    for spring in &draft.springs {
        let numbers = [
            (spring.stiffness.as_ref(), "a stiffness"),
            (spring.damping.as_ref().and_then(Option::as_ref), "a damping"),
            (spring.length.as_ref().and_then(Option::as_ref), "a length"),
        ];
        for (given, called) in numbers {
            let Some(given) = given else { continue };
            let Some(at_start) = given.value.at(&defaults).filter(|value| *value < 0.0) else {
                continue;
            };
            let message = format!("{called} cannot be negative");
            let known = given.value.known().is_some();
            diagnostics.error_over(given.at, super::verdict(&message, known, at_start));
        }
    }
}
