//! Conditions on values. Known values are checked at once, and parameters by their defaults.
//! Conditions that depend on Rust constants become `const` assertions with the same message and
//! span.

use super::Value;
use crate::diag::{Diagnostics, SpanRange};

/// A condition on a value.
#[derive(Clone, Debug)]
pub struct Condition {
    /// The number.
    pub value: Value,
    /// The bound that it must satisfy.
    pub must: Bound,
    /// The span to edit if the condition fails.
    pub at: SpanRange,
    /// The message if the condition fails; `None` if another condition reports it.
    pub message: Option<String>,
    /// The unit of the value, if the message shows the value.
    pub shown: Option<&'static str>,
}

/// A bound on a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bound {
    /// Neither infinite nor undefined.
    BeFinite,
    /// Above zero.
    BePositive,
    /// Zero or above.
    NotBeNegative,
}

/// Conditions of which the first failure is reported: each condition assumes those before it.
pub type Requirement = Vec<Condition>;

impl Bound {
    /// Returns whether a value satisfies the bound. Finiteness is a separate condition.
    pub fn holds(self, number: f64) -> bool {
        match self {
            Bound::BeFinite => number.is_finite(),
            Bound::BePositive => number > 0.0 || !number.is_finite(),
            Bound::NotBeNegative => number >= 0.0 || !number.is_finite(),
        }
    }
}

impl Condition {
    /// Creates a condition with its message.
    pub fn new(value: Value, must: Bound, at: SpanRange, message: impl Into<String>) -> Self {
        Condition { value, must, at, message: Some(message.into()), shown: None }
    }

    /// Creates a condition that another one reports.
    pub fn silent(value: Value, must: Bound, at: SpanRange) -> Self {
        Condition { value, must, at, message: None, shown: None }
    }

    /// Lets the message show the value with its unit if it depends on parameters.
    pub fn shown(self, unit: &'static str) -> Self {
        Condition { shown: Some(unit), ..self }
    }

    /// Returns the message for a value that fails the condition.
    fn verdict(&self, number: f64) -> Option<String> {
        let message = self.message.as_ref()?;
        Some(match (self.value.known(), self.shown) {
            (Some(_), _) => message.clone(),
            (None, None) => format!("{message}, with its parameters' defaults"),
            (None, Some(unit)) => {
                let space = if unit.is_empty() { "" } else { " " };
                format!("{message}; with its parameters' defaults it is {number}{space}{unit}")
            }
        })
    }
}

/// Checks the conditions on known values. Returns those that depend on Rust constants.
pub fn judge(
    requirements: Vec<Requirement>,
    defaults: &[Option<f64>],
    diagnostics: &mut Diagnostics,
) -> Vec<Requirement> {
    let mut open = Vec::new();
    'next: for requirement in requirements {
        let mut unknown = Vec::new();
        for condition in requirement {
            match condition.value.at(defaults) {
                None => unknown.push(condition),
                Some(number) if condition.must.holds(number) => {}
                Some(number) => {
                    if let Some(verdict) = condition.verdict(number) {
                        diagnostics.error_over(condition.at, verdict);
                    }
                    continue 'next;
                }
            }
        }
        if unknown.iter().any(|condition| condition.message.is_some()) {
            open.push(unknown);
        }
    }
    open
}
