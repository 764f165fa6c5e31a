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
pub struct Names {
    texts: Vec<String>,
    /// Which of them have a number in place of a name.
    numbered: Vec<bool>,
}

impl Names {
    /// A new value with a name.
    pub fn add(&mut self, text: String) -> Name {
        self.push(text, false)
    }

    /// A new value whose name says nothing but a number.
    pub fn add_numbered(&mut self, text: String) -> Name {
        self.push(text, true)
    }

    fn push(&mut self, text: String, numbered: bool) -> Name {
        self.texts.push(text);
        self.numbered.push(numbered);
        Name(self.texts.len() as u32 - 1)
    }

    /// What a value is called.
    pub fn text(&self, name: Name) -> &str {
        &self.texts[name.index()]
    }

    /// Whether the name of a value says nothing but a number.
    pub fn is_numbered(&self, name: Name) -> bool {
        self.numbered[name.index()]
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
