//! The subcommands, one file for each.

pub mod import;

use std::fmt;
use std::path::Path;

/// The reason why a command failed, for standard error.
#[derive(Debug)]
pub struct Failure(pub String);

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for Failure {}

/// Reads a file.
fn read(file: &Path) -> Result<String, Failure> {
    std::fs::read_to_string(file).map_err(|error| Failure(format!("{}: {error}", file.display())))
}

/// Writes a result to a file or, without one, to standard output.
fn write(text: &str, file: Option<&Path>) -> Result<(), Failure> {
    use std::io::Write;
    let written = match file {
        Some(file) => {
            return std::fs::write(file, text)
                .map_err(|error| Failure(format!("{}: {error}", file.display())));
        }
        None => std::io::stdout().write_all(text.as_bytes()),
    };
    written.map_err(|error| Failure(format!("standard output: {error}")))
}
