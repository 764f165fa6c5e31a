//! `cargo mstmm header`

use clap::Args;
use std::path::{Path, PathBuf};

use super::dependency::DependencyArguments;
use super::{Failure, write};
use crate::header::{Library, MARK, Method, Scalar};
use crate::source::Source;

/// Write a C header for chains, and the Rust crate behind it
///
/// Without `-o`, and with a file that ends in `.h`, the result is the header. Otherwise it is a folder with a crate:
/// the header in `include`, and sources that `cargo build --release` makes into a static library. An existing
/// `Cargo.toml` is kept. All chains of the file are in one library, since a program can have only one of Rust.
#[derive(Args, Debug)]
#[command(disable_version_flag = true)]
pub struct Header {
    /// The file with the chains; `-` is standard input
    #[arg(value_name = "FILE")]
    file: PathBuf,
    /// The scalar of all computations
    #[arg(long, value_enum, default_value_t = Scalar::F64)]
    scalar: Scalar,
    /// The method of a step
    #[arg(long, value_enum, default_value_t = Method::Rk4)]
    method: Method,
    /// The name of the header and the library, otherwise mstmm_ and the name of the first chain
    #[arg(long)]
    name: Option<String>,
    /// Write the header to this file, or the crate to this folder
    #[arg(short, long, value_name = "FILE or FOLDER")]
    output: Option<PathBuf>,
    #[command(flatten)]
    dependency: DependencyArguments,
}

/// Runs the command.
///
/// # Errors
///
/// If the chains have errors, or what a library cannot have, or a file cannot be written.
pub fn run(arguments: &Header) -> Result<(), Failure> {
    let source = Source::read(&arguments.file)?;
    let chains = source.chains()?;
    let refused = |reasons: Vec<String>| {
        let lines: Vec<String> =
            reasons.iter().map(|reason| format!("{}: {reason}", source.file)).collect();
        Failure(lines.join("\nerror: "))
    };
    if chains.is_empty() {
        return Err(refused(vec!["the file has no chain".into()]));
    }
    let text = source.inside().map_err(|message| Failure(message.message))?;
    let properties = (arguments.scalar, arguments.method);
    let library =
        Library::new(&chains, text, arguments.name.as_deref(), properties).map_err(refused)?;
    for warning in library.warnings() {
        eprintln!("warning: {}: {warning}", source.file);
    }
    match &arguments.output {
        Some(output) if output.extension().is_none_or(|extension| extension != "h") => {
            make(&library, output, &arguments.dependency)
        }
        file => write(&library.header(), file.as_deref()),
    }
}

/// Writes the crate.
fn make(library: &Library, folder: &Path, dependency: &DependencyArguments) -> Result<(), Failure> {
    let files: Vec<(PathBuf, String)> =
        library.files().into_iter().map(|(path, text)| (folder.join(path), text)).collect();
    let foreign = |path: &&PathBuf| {
        let is_rust = path.extension().is_some_and(|extension| extension == "rs");
        is_rust && std::fs::read_to_string(path).is_ok_and(|text| !text.starts_with(MARK))
    };
    if let Some(path) = files.iter().map(|(path, _)| path).find(foreign) {
        return Err(Failure(format!(
            "{}: this file is not generated; write to another folder",
            path.display()
        )));
    }
    for (path, text) in &files {
        if let Some(parent) = path.parent() {
            let failed = |error| Failure(format!("{}: {error}", parent.display()));
            std::fs::create_dir_all(parent).map_err(failed)?;
        }
        write(text, Some(path))?;
    }
    let manifest = folder.join("Cargo.toml");
    if !manifest.exists() {
        let dependency = dependency.choose()?;
        write(&library.manifest(&dependency), Some(&manifest))?;
        eprintln!("note: the crate depends on {dependency}");
    }
    Ok(())
}
