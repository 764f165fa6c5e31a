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
    /// The element and the reason.
    pub message: String,
}

/// The result of a step of an import.
pub type Result<T> = std::result::Result<T, ImportError>;

impl ImportError {
    /// Makes an error about a whole file.
    pub fn new(message: impl Into<String>) -> Self {
        ImportError { place: None, message: message.into() }
    }

    /// Makes an error about an element.
    pub fn at(place: Place, message: impl Into<String>) -> Self {
        ImportError { place: Some(place), message: message.into() }
    }
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
