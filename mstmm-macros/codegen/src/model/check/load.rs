//! Loads and springs on bodies.

use crate::diag::Diagnostics;
use crate::model::Value;
use crate::model::condition::Requirement;
use crate::model::lower::{Draft, Spanned, listed};
use crate::model::rules::{DAMPING, LENGTH, STIFFNESS, ValueRule};

/// Reports missing fields of loads: a load needs a body and a force or a torque.
pub(super) fn loads_are_complete(draft: &Draft, diagnostics: &mut Diagnostics) {
    for load in &draft.loads {
        let missing = load.missing();
        if !missing.is_empty() {
            let message = format!("load `{}` needs {}", load.name, listed(&missing));
            diagnostics.error(load.name.joined.span(), message);
        }
    }
}

/// Reports missing fields of springs.
pub(super) fn springs_are_complete(draft: &Draft, diagnostics: &mut Diagnostics) {
    for spring in &draft.springs {
        let missing = spring.missing();
        if !missing.is_empty() {
            let message = format!("spring `{}` needs {}", spring.name, listed(&missing));
            diagnostics.error(spring.name.joined.span(), message);
        }
    }
}

/// Requires that stiffness, damping and length of springs are not negative.
pub(super) fn spring_values_are_not_negative(draft: &Draft) -> Vec<Requirement> {
    let numbers = draft.springs.iter().flat_map(|spring| {
        [
            (spring.stiffness.as_ref().and_then(Option::as_ref), STIFFNESS),
            (spring.damping.as_ref().and_then(Option::as_ref), DAMPING),
            (spring.length.as_ref().and_then(Option::as_ref), LENGTH),
        ]
    });
    let not_negative = |(value, rule): (Option<&Spanned<Value>>, ValueRule)| {
        let Spanned { value, at } = value?.clone();
        Some(vec![rule.condition(value, at)])
    };
    numbers.filter_map(not_negative).collect()
}
