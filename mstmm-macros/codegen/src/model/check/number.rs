//! Requirements on all numbers of a description.

use crate::model::condition::{Bound, Condition, Requirement};
use crate::model::lower::Draft;
use crate::model::{Request, Value};

const ROOT_OF_ZERO: &str = "`linearize`, `push` and `pull` have derivatives by parameters, which are infinite where the \
                            argument of `sqrt` is zero: it must be positive";

/// Requires finite numbers, and quaternions that are not zero.
pub(super) fn numbers_are_finite(draft: &Draft) -> Vec<Requirement> {
    draft.requirements.clone()
}

/// Requires finite derivatives of all numbers by the parameters, if answers contain derivatives by them.
pub(super) fn roots_have_derivatives(draft: &Draft) -> Vec<Requirement> {
    let by_parameters = [Request::Linearize, Request::Push, Request::Pull];
    if !draft.settings.requests.iter().any(|request| by_parameters.contains(&request.value)) {
        return Vec::new();
    }
    let mut requirements = Vec::new();
    for condition in draft.requirements.iter().flatten() {
        let arguments = condition.value.roots().into_iter().filter(|argument| argument.changes());
        requirements.extend(arguments.map(|argument| {
            // A root of a negative number is no finite number.
            let not_negative =
                Condition::silent(argument.clone(), Bound::NotBeNegative, condition.at);
            let positive =
                Condition::new(argument.clone(), Bound::BePositive, condition.at, ROOT_OF_ZERO);
            vec![not_negative, positive.shown("")]
        }));
    }
    requirements
}

impl Value {
    /// Returns the arguments of all square roots in a value.
    fn roots(&self) -> Vec<&Value> {
        match self {
            Value::Number(_) | Value::Symbol(_) => Vec::new(),
            Value::Sum(a, b) | Value::Product(a, b) | Value::Quotient(a, b) => {
                [a.roots(), b.roots()].concat()
            }
            Value::Sqrt(a) => [vec![&**a], a.roots()].concat(),
            Value::Sin(a) | Value::Cos(a) => a.roots(),
        }
    }
}
