//! Values by number, and what they are called.

/// A value of a program, by the number of its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Name(u32);

impl Name {
    /// Its number.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// What the values of a program are called: lists, since looking up every operand in a map takes as long
/// as all passes do.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Names(Vec<String>);

impl Names {
    /// A new value.
    pub fn add(&mut self, text: String) -> Name {
        self.0.push(text);
        Name(self.0.len() as u32 - 1)
    }

    /// What a value is called.
    pub fn text(&self, name: Name) -> &str {
        &self.0[name.index()]
    }

    /// Calls a value something else.
    pub fn rename(&mut self, name: Name, text: String) {
        self.0[name.index()] = text;
    }

    /// What all values are called, by number.
    pub fn all(&self) -> &[String] {
        &self.0
    }

    /// How many there are.
    pub fn count(&self) -> usize {
        self.0.len()
    }
}
