//! `cargo mstmm check`

use clap::Args;
use std::path::PathBuf;

use super::{Failure, write};
use crate::messages::{Message, json_lines, rendered};
use crate::source::Source;

/// Report the errors and warnings of chains, as `mstmm_chain!` does
#[derive(Args, Debug)]
pub struct Check {
    /// Files with chains; `-` is standard input
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
    /// Write messages to standard output, each a line with a JSON object
    #[arg(long)]
    json: bool,
}

/// Runs the command. Messages go to standard error, as JSON to standard output.
///
/// # Errors
///
/// If a file cannot be read or has errors.
pub fn run(arguments: &Check) -> Result<(), Failure> {
    let mut errors = 0;
    for file in &arguments.files {
        let source = match Source::read(file) {
            Ok(source) => source,
            Err(failure) => {
                match arguments.json {
                    true => write(&json_lines(&[Message::of_file(file, &failure)]), None)?,
                    false => eprintln!("error: {failure}\n"),
                }
                errors += 1;
                continue;
            }
        };
        let (_, messages) = source.check();
        errors += Message::count_errors(&messages);
        match arguments.json {
            true => write(&json_lines(&messages), None)?,
            false => eprint!("{}", rendered(&source, &messages)),
        }
    }
    match errors {
        0 => Ok(()),
        _ => Err(Failure::of_errors(errors)),
    }
}
