//! Ids and names of values.

use crate::ids::{Id, declare_id};

declare_id! {
    /// A value of a program.
    ValueId,
}

/// The names of a program's values.
///
/// They are lists, since looking up every operand in a map would cost as much as all passes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ValueNames {
    texts: Vec<String>,
    /// Which values have a generated name.
    numbered: Vec<bool>,
}

impl ValueNames {
    /// Adds a value with a meaningful name.
    pub fn add(&mut self, text: String) -> ValueId {
        self.push(text, false)
    }

    /// Adds a value whose name is only a generated number.
    pub fn add_numbered(&mut self, text: String) -> ValueId {
        self.push(text, true)
    }

    fn push(&mut self, text: String, numbered: bool) -> ValueId {
        self.texts.push(text);
        self.numbered.push(numbered);
        ValueId::new(self.texts.len() - 1)
    }

    /// Gives a value another name.
    pub fn rename(&mut self, value: ValueId, text: String) {
        self.texts[value.index()] = text;
    }

    /// Returns the name of a value.
    pub fn text(&self, value: ValueId) -> &str {
        &self.texts[value.index()]
    }

    /// Returns whether the name of a value is only a generated number.
    pub fn is_numbered(&self, value: ValueId) -> bool {
        self.numbered[value.index()]
    }

    /// Returns the names of all values, by id.
    pub fn all(&self) -> &[String] {
        &self.texts
    }

    /// Returns the number of values.
    pub fn count(&self) -> usize {
        self.texts.len()
    }
}
