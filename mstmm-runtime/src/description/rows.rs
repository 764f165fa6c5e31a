//! The rows of inputs, parameters and connection points.

use super::items::Element;
use super::part::{Part, QuantityKind};

/// The path of a connection point; `[]` is where the index of a repetition belongs.
pub type Place = &'static str;

impl Element for Place {
    fn path(&self) -> &'static str {
        self
    }
}

/// Some components of an input.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Input {
    path: &'static str,
    /// A character for each component; empty for a scalar.
    components: &'static str,
    kind: QuantityKind,
}

impl Input {
    pub(crate) const fn new(
        path: &'static str,
        components: &'static str,
        kind: QuantityKind,
    ) -> Self {
        Input { path, components, kind }
    }

    pub(super) fn count(&self) -> usize {
        self.components.len().max(1)
    }

    pub(super) fn path(&self) -> &'static str {
        self.path
    }

    pub(super) fn part(&self, entry: usize) -> Part {
        Part::component(self.kind, self.components.chars().nth(entry))
    }
}

/// A parameter, with one value or one for each repetition.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameter {
    path: &'static str,
    unit: &'static str,
    default: f64,
}

impl Parameter {
    pub(crate) const fn new(path: &'static str, unit: &'static str, default: f64) -> Self {
        Parameter { path, unit, default }
    }

    pub(super) fn path(&self) -> &'static str {
        self.path
    }

    pub(super) fn part(&self, _: usize) -> Part {
        Part { unit: self.unit, start: self.default, ..Part::of(QuantityKind::Parameter) }
    }
}
