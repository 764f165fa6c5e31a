//! `cargo mstmm import`

use clap::Args;
use std::path::{Path, PathBuf};

use super::{Failure, write};
use crate::import::{Options, import};
use crate::source::Source;

/// Write a URDF file or a MuJoCo model as the text of a chain.
#[derive(Args, Debug)]
pub struct Import {
    /// The URDF or MJCF file; `-` is standard input
    file: PathBuf,
    /// Only joints between the root and this link move; others are held at zero
    #[arg(long, value_name = "LINK")]
    tip: Option<String>,
    /// The name of the chain, otherwise that of the robot
    #[arg(long)]
    name: Option<String>,
    /// Angles this close to whole degrees, in rad, become whole degrees
    #[arg(long, value_name = "RAD", default_value = "1e-12")]
    snap: f64,
    /// Refuse the file instead of a warning
    #[arg(long)]
    strict: bool,
    /// The root link is a free body instead of the ground
    #[arg(long)]
    floating: bool,
    /// Write to this file instead of standard output
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

/// Runs the command: the text is its result, warnings are messages.
///
/// # Errors
///
/// If a file cannot be read or written, or the robot cannot be a chain.
pub fn run(arguments: &Import) -> Result<(), Failure> {
    let Source { file: shown, text } = Source::read(&arguments.file)?;
    let name = Path::new(&shown).file_name().unwrap_or_default().to_string_lossy().into_owned();
    let options = Options {
        name: arguments.name.clone(),
        tip: arguments.tip.clone(),
        snap: arguments.snap,
        strict: arguments.strict,
        floating: arguments.floating,
        file: name.chars().filter(|letter| !letter.is_control()).collect(),
    };
    let imported = import(&text, &options).map_err(|error| {
        let separator = if error.place.is_some() { "" } else { " " };
        Failure(format!("{shown}:{separator}{error}"))
    })?;
    for warning in &imported.warnings {
        eprintln!("warning: {shown}: {warning}");
    }
    write(&imported.text, arguments.output.as_deref())
}
