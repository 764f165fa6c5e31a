//! Ids and names of values.

use crate::ids::{Id, declare_id};
use std::collections::HashSet;
use std::hash::{BuildHasherDefault, Hasher};

declare_id! {
    /// A value of a program.
    ValueId,
}

/// The names of a program's values, which are unique.
///
/// They are lists, since looking up every operand in a map would cost as much as all passes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ValueNames {
    texts: Vec<String>,
    /// Which values have a generated name.
    numbered: Vec<bool>,
    /// The names in use.
    taken: HashSet<String, BuildHasherDefault<TextHasher>>,
}

impl ValueNames {
    /// Keeps names from values that are added by [`fresh`](Self::fresh) and [`numbered`](Self::numbered).
    pub fn reserve(&mut self, texts: impl Iterator<Item = String>) {
        self.taken.extend(texts);
    }

    /// Adds a value with a meaningful name that no other value has.
    pub fn add(&mut self, text: String) -> ValueId {
        self.taken.insert(text.clone());
        self.push(text, false)
    }

    /// Adds a value with a meaningful name, made unique by a number if it is in use.
    pub fn fresh(&mut self, wanted: String) -> ValueId {
        let text = self.free(wanted);
        self.push(text, false)
    }

    /// Adds a value whose name is only a generated number, made unique in the same way.
    pub fn numbered(&mut self, wanted: String) -> ValueId {
        let text = self.free(wanted);
        self.push(text, true)
    }

    /// Gives a value another name, made unique in the same way.
    pub fn rename(&mut self, value: ValueId, wanted: String) {
        self.texts[value.index()] = self.free(wanted);
    }

    fn push(&mut self, text: String, numbered: bool) -> ValueId {
        self.texts.push(text);
        self.numbered.push(numbered);
        ValueId::new(self.texts.len() - 1)
    }

    /// Returns an unused name, which is in use from then on.
    fn free(&mut self, wanted: String) -> String {
        if self.taken.insert(wanted.clone()) {
            return wanted;
        }
        let numbered = (2..).map(|number| format!("{wanted}_{number}"));
        let mut free = numbered.filter(|name| self.taken.insert(name.clone()));
        free.next().unwrap_or_else(|| bug!("there are no numbers left"))
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

/// The hash function FNV-1a, of Fowler, Noll and Vo.
///
/// Macros are built unoptimised, where it costs a fraction of the standard library's hash function.
#[derive(Clone, Debug)]
struct TextHasher(u64);

impl Default for TextHasher {
    fn default() -> Self {
        TextHasher(0xcbf2_9ce4_8422_2325)
    }
}

impl Hasher for TextHasher {
    fn write(&mut self, bytes: &[u8]) {
        for &byte in bytes {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
        }
    }

    fn finish(&self) -> u64 {
        self.0
    }
}
