//! Names that are formed when they are displayed.

use core::fmt::{self, Display, Write};

/// The name of an element or a quantity, such as `joint[12].angle`.
///
/// [`Display`] writes it. It can be compared with text without memory for either.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Name {
    /// The path; `[]` is where the index of a repetition belongs.
    path: &'static str,
    repetition: usize,
    /// The accessor of a group of components; may be empty.
    group: &'static str,
    component: Option<char>,
}

impl Name {
    pub(super) const fn new(path: &'static str, repetition: usize) -> Self {
        Name { path, repetition, group: "", component: None }
    }

    pub(super) const fn with(self, group: &'static str, component: Option<char>) -> Self {
        Name { group, component, ..self }
    }

    /// Returns the index of the repetition, if the element belongs to a repeated part.
    #[must_use]
    pub fn repetition(&self) -> Option<usize> {
        self.path.contains("[]").then_some(self.repetition)
    }

    /// Returns the path without the index of the repetition: `joint[].angle` is the path `joint` and the accessor
    /// `angle`.
    #[must_use]
    pub fn path(&self) -> &'static str {
        self.path.split_once("[]").map_or(self.path, |(path, _)| path)
    }
}

impl Display for Name {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if f.width().is_some() {
            return self.padded(f);
        }
        self.write(f)
    }
}

impl Name {
    /// Returns the path up to the index of the repetition and after it, the group and the component.
    #[cfg(feature = "defmt")]
    pub(crate) fn pieces(
        &self,
    ) -> ((&'static str, Option<&'static str>), &'static str, Option<char>) {
        let path = match self.path.split_once("[]") {
            None => (self.path, None),
            Some((before, after)) => (before, Some(after)),
        };
        (path, self.group, self.component)
    }

    fn write(&self, f: &mut impl Write) -> fmt::Result {
        match self.path.split_once("[]") {
            None => f.write_str(self.path)?,
            Some((before, after)) => write!(f, "{before}[{}]{after}", self.repetition)?,
        }
        if !self.group.is_empty() {
            write!(f, ".{}", self.group)?;
        }
        match self.component {
            Some(component) => write!(f, ".{component}"),
            None => Ok(()),
        }
    }

    /// Writes the name with the width and the alignment of the formatter.
    fn padded(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut length = Length(0);
        self.write(&mut length)?;
        let missing = f.width().unwrap_or(0).saturating_sub(length.0);
        let before = match f.align() {
            Some(fmt::Alignment::Right) => missing,
            Some(fmt::Alignment::Center) => missing / 2,
            Some(fmt::Alignment::Left) | None => 0,
        };
        let fill = f.fill();
        (0..before).try_for_each(|_| f.write_char(fill))?;
        self.write(f)?;
        (before..missing).try_for_each(|_| f.write_char(fill))
    }
}

/// The number of characters written.
struct Length(usize);

impl Write for Length {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        self.0 += text.chars().count();
        Ok(())
    }
}

/// The rest of a text, of which the characters written are removed.
struct Rest<'a>(&'a str);

impl Write for Rest<'_> {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        self.0 = self.0.strip_prefix(text).ok_or(fmt::Error)?;
        Ok(())
    }
}

impl PartialEq<str> for Name {
    fn eq(&self, text: &str) -> bool {
        let mut rest = Rest(text);
        self.write(&mut rest).is_ok() && rest.0.is_empty()
    }
}

impl PartialEq<&str> for Name {
    fn eq(&self, text: &&str) -> bool {
        self == *text
    }
}

/// Returns the index in the first brackets of a name, zero if there are none.
pub fn repetition_in(name: &str) -> Option<usize> {
    let Some((_, rest)) = name.split_once('[') else { return Some(0) };
    let (index, _) = rest.split_once(']')?;
    index.parse().ok()
}
