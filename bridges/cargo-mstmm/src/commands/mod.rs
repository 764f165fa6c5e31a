//! The subcommands, one file for each.

pub mod check;
pub mod dependency;
pub mod export;
pub mod header;
pub mod import;
pub mod new;
pub mod python;
pub mod show;

use std::fmt;
use std::path::Path;

/// The reason why a command failed, for standard error.
#[derive(Debug)]
pub struct Failure(pub String);

impl Failure {
    /// Makes the failure of a command that has reported this number of errors.
    #[must_use]
    pub fn of_errors(count: usize) -> Self {
        Failure(if count == 1 { "1 error".to_owned() } else { format!("{count} errors") })
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for Failure {}

/// Reads a file.
///
/// # Errors
///
/// If it cannot be read or is not UTF-8.
pub fn read(file: &Path) -> Result<String, Failure> {
    std::fs::read_to_string(file).map_err(|error| Failure(format!("{}: {error}", file.display())))
}

/// Writes a result to a file or, without one, to standard output.
///
/// # Errors
///
/// If it cannot be written.
pub fn write(text: &str, file: Option<&Path>) -> Result<(), Failure> {
    use std::io::Write;
    let written = match file {
        Some(file) => {
            return std::fs::write(file, text)
                .map_err(|error| Failure(format!("{}: {error}", file.display())));
        }
        None => std::io::stdout().write_all(text.as_bytes()),
    };
    match written {
        // The reader has seen enough, such as `head`.
        Err(error) if error.kind() == std::io::ErrorKind::BrokenPipe => Ok(()),
        written => written.map_err(|error| Failure(format!("standard output: {error}"))),
    }
}
