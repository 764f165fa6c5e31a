//! `cargo mstmm export`

use clap::Args;
use std::path::PathBuf;

use super::{Failure, write};
use crate::export::{NOT_FROM_CHAIN, export, select};
use crate::source::Source;
use mstmm_codegen::model::Chain;

/// Write a chain in the format of another tool.
#[derive(Args, Debug)]
pub struct Export {
    /// Write a URDF file
    #[arg(long, required = true)]
    urdf: bool,
    /// The file with the chain; `-` is standard input
    #[arg(value_name = "FILE")]
    file: PathBuf,
    /// The chain, if the file has several
    #[arg(long)]
    name: Option<String>,
    /// Write to this file instead of standard output
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

/// Runs the command.
///
/// # Errors
///
/// If a file cannot be read or written, the chain has errors, or it has what the format cannot have.
pub fn run(arguments: &Export) -> Result<(), Failure> {
    let source = Source::read(&arguments.file)?;
    let checked = source.chains()?;
    let chains: Vec<&Chain> = checked.iter().map(|checked| &checked.chain).collect();
    let refused = |reasons: &[String]| {
        let lines: Vec<String> =
            reasons.iter().map(|reason| format!("{}: {reason}", source.file)).collect();
        Failure(lines.join("\nerror: "))
    };
    let chain = select(&chains, arguments.name.as_deref()).map_err(|reason| refused(&[reason]))?;
    let exported = export(chain).map_err(|reasons| refused(&reasons))?;
    if exported.contains(NOT_FROM_CHAIN) {
        eprintln!("note: {}: {NOT_FROM_CHAIN}", source.file);
    }
    write(&exported, arguments.output.as_deref())
}
