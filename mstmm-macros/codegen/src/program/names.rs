//! Values by number, and what they are called.

use crate::ids::{Id, declare_id};

declare_id! {
    /// A value of a program.
    ValueId,
}

/// What the values of a program are called: lists, since looking up every operand in a map takes as long
/// as all passes do.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ValueNames {
    texts: Vec<String>,
    /// Which of them have a number in place of a name.
    numbered: Vec<bool>,
}

impl ValueNames {
    /// A new value with a name.
    pub fn add(&mut self, text: String) -> ValueId {
        self.push(text, false)
    }

    /// A new value whose name says nothing but a number.
    pub fn add_numbered(&mut self, text: String) -> ValueId {
        self.push(text, true)
    }

    fn push(&mut self, text: String, numbered: bool) -> ValueId {
        self.texts.push(text);
        self.numbered.push(numbered);
        ValueId::new(self.texts.len() - 1)
    }

    /// What a value is called.
    pub fn text(&self, value: ValueId) -> &str {
        &self.texts[value.index()]
    }

    /// Whether the name of a value says nothing but a number.
    pub fn is_numbered(&self, value: ValueId) -> bool {
        self.numbered[value.index()]
    }

    /// What all values are called, by number.
    pub fn all(&self) -> &[String] {
        &self.texts
    }

    /// How many there are.
    pub fn count(&self) -> usize {
        self.texts.len()
    }
}
