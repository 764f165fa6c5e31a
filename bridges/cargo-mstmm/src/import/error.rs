//! The errors of an import, each with its place in the file.

use std::fmt;

/// A line and a column, from 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    /// The line.
    pub line: u32,
    /// The column, in characters.
    pub column: u32,
}

/// The reason why a file is refused.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ImportError {
    /// The place in the file, if the error has one.
    pub place: Option<Place>,
    /// The element and the reason, on one line.
    pub message: String,
}

/// The result of a step of an import.
pub type Result<T> = std::result::Result<T, ImportError>;

impl ImportError {
    /// Makes an error about a whole file.
    pub fn new(message: impl fmt::Display) -> Self {
        ImportError { place: None, message: on_one_line(message) }
    }

    /// Makes an error about an element.
    pub fn at(place: Place, message: impl fmt::Display) -> Self {
        ImportError { place: Some(place), message: on_one_line(message) }
    }
}

/// Returns a message with escaped control characters: a name of the file may have line breaks, and a
/// message has one line, as has the comment that repeats it.
pub fn on_one_line(message: impl fmt::Display) -> String {
    let mut line = String::new();
    for letter in message.to_string().chars() {
        match letter.is_control() {
            true => line.extend(letter.escape_debug()),
            false => line.push(letter),
        }
    }
    line
}

impl fmt::Display for ImportError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(Place { line, column }) = self.place {
            write!(f, "{line}:{column}: ")?;
        }
        f.write_str(&self.message)
    }
}

impl std::error::Error for ImportError {}
