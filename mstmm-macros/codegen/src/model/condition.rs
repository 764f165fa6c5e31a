//! What must hold of numbers. Known ones are judged at once, parameters by their defaults; what hangs
//! on Rust constants is left to `const` assertions of the same words at the same place.

use super::Value;
use crate::diag::{Diagnostics, SpanRange};

/// Something that must hold of a number.
#[derive(Clone, Debug)]
pub struct Condition {
    /// The number.
    pub value: Value,
    /// What it must be.
    pub must: Bound,
    /// What to edit where it does not hold.
    pub at: SpanRange,
    /// What to say then; nothing where that is another condition's.
    pub message: Option<String>,
    /// The unit of the number, if that helps who reads the message.
    pub shown: Option<&'static str>,
}

/// What a number must be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bound {
    /// Neither infinite nor undefined.
    BeFinite,
    /// Above zero.
    BePositive,
    /// Zero or above.
    NotBeNegative,
}

/// Conditions of which the first that does not hold is reported: those behind it take for granted
/// that it does.
pub type Requirement = Vec<Condition>;

impl Bound {
    /// Whether it holds. That a number is finite is a condition of its own.
    pub fn holds(self, number: f64) -> bool {
        match self {
            Bound::BeFinite => number.is_finite(),
            Bound::BePositive => number > 0.0 || !number.is_finite(),
            Bound::NotBeNegative => number >= 0.0 || !number.is_finite(),
        }
    }
}

impl Condition {
    /// A condition and what to say where it does not hold.
    pub fn new(value: Value, must: Bound, at: SpanRange, message: impl Into<String>) -> Self {
        Condition { value, must, at, message: Some(message.into()), shown: None }
    }

    /// One that is reported elsewhere.
    pub fn silent(value: Value, must: Bound, at: SpanRange) -> Self {
        Condition { value, must, at, message: None, shown: None }
    }

    /// The number is shown with its unit where it comes from parameters.
    pub fn shown(self, unit: &'static str) -> Self {
        Condition { shown: Some(unit), ..self }
    }

    /// What to say of a number that breaks it.
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

/// Judges what is known, and gives back what is not: what hangs on Rust constants.
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
