//! `cargo mstmm new`

use clap::Args;
use std::path::{Path, PathBuf};
use std::process::Command;

use super::dependency::DependencyArguments;
use super::{Failure, read};
use crate::import::{Options, import};
use crate::new::{FIRST, firmware, firmware_dependencies, program};
use crate::source::Source;

/// Make a project that simulates a chain
///
/// The project is a package with a program, which prints a motion and the forces in the chain, and a test. `cargo new`
/// makes the package, so its rules for names, version control and workspaces hold. Without `--chain` and `--urdf` the
/// chain is a crane. With `--no-std` it is firmware of a Cortex-M in single precision, without heap and operating system.
#[derive(Args, Debug)]
#[command(disable_version_flag = true)]
pub struct New {
    /// The folder of the project, which must not exist
    #[arg(value_name = "FOLDER")]
    folder: PathBuf,
    /// The name of the package, otherwise that of the folder
    #[arg(long)]
    name: Option<String>,
    /// A file with the chain; `-` is standard input
    #[arg(long, value_name = "FILE", conflicts_with = "urdf")]
    chain: Option<PathBuf>,
    /// A URDF file with the chain, imported as by `cargo mstmm import`
    #[arg(long, value_name = "FILE")]
    urdf: Option<PathBuf>,
    /// The root link of the URDF file is a free body instead of the ground
    #[arg(long, requires = "urdf")]
    floating: bool,
    /// Firmware for a microcontroller of the family Cortex-M instead of a program for this computer
    #[arg(long)]
    no_std: bool,
    /// The version control of `cargo new`: git, hg, pijul, fossil or none
    #[arg(long, value_name = "VCS")]
    vcs: Option<String>,
    #[command(flatten)]
    dependency: DependencyArguments,
}

/// Runs the command.
///
/// # Errors
///
/// If the chain has errors, `cargo new` refuses the package, or a file cannot be written.
pub fn run(arguments: &New) -> Result<(), Failure> {
    let (source, origin) = chain(arguments)?;
    let chains = source.chains()?;
    let [chain] = &chains[..] else {
        let count = chains.len();
        let file = &source.file;
        return Err(Failure(format!("{file}: a project has one chain, and the file has {count}")));
    };
    let text = source.inside().map_err(|message| Failure(message.message))?;
    let dependency = arguments.dependency.choose()?;
    cargo_new(arguments)?;
    let folder = &arguments.folder;
    let manifest = folder.join("Cargo.toml");
    let begun = read(&manifest)?;
    let (dependencies, files) = match arguments.no_std {
        true => {
            let package = name_in(&begun).unwrap_or_default();
            (firmware_dependencies(&dependency), firmware(chain, text, &origin, package))
        }
        false => (
            format!("mstmm = {}\n", dependency.requirement()),
            vec![("src/main.rs", program(chain, text, &origin))],
        ),
    };
    super::write(&format!("{begun}{dependencies}"), Some(&manifest))?;
    for (path, text) in files {
        super::write(&text, Some(&folder.join(path)))?;
    }
    eprintln!("note: the package depends on {dependency}");
    if arguments.no_std {
        eprintln!(
            "note: `memory.x` and `CLOCK` in `src/main.rs` are those of an emulated board; set yours"
        );
        eprintln!(
            "note: to build it: cd {} && cargo build --release --target thumbv7em-none-eabihf",
            folder.display()
        );
    } else {
        eprintln!("note: to run the program: cd {} && cargo run", folder.display());
    }
    Ok(())
}

/// Returns the name of the package in a manifest of `cargo new`.
fn name_in(manifest: &str) -> Option<&str> {
    let line = manifest.lines().find_map(|line| line.strip_prefix("name = \""))?;
    line.strip_suffix('"')
}

/// Returns the source of the chain, and the name of its file for the program.
fn chain(arguments: &New) -> Result<(Source, String), Failure> {
    let name = |file: &Path| file.file_name().unwrap_or_default().to_string_lossy().into_owned();
    if let Some(file) = &arguments.chain {
        return Ok((Source::read(file)?, name(file)));
    }
    let Some(file) = &arguments.urdf else {
        return Ok((Source::new("crane.chain", FIRST), String::new()));
    };
    let options = Options { floating: arguments.floating, file: name(file), ..Options::default() };
    let Source { file: shown, text } = Source::read(file)?;
    let imported = import(&text, &options).map_err(|error| {
        let separator = if error.place.is_some() { "" } else { " " };
        Failure(format!("{shown}:{separator}{error}"))
    })?;
    for warning in &imported.warnings {
        eprintln!("warning: {shown}: {warning}");
    }
    Ok((Source::new(&shown, &imported.text), name(file)))
}

/// Makes the package by `cargo new`, whose messages are those of this command.
fn cargo_new(arguments: &New) -> Result<(), Failure> {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let mut command = Command::new(&cargo);
    command.args(["new", "--quiet", "--bin", "--edition", "2024"]);
    if let Some(name) = &arguments.name {
        command.arg("--name").arg(name);
    }
    if let Some(vcs) = &arguments.vcs {
        command.arg("--vcs").arg(vcs);
    }
    let status = command.arg("--").arg(&arguments.folder).status();
    let failed = |reason: String| Failure(format!("`cargo new` {reason}"));
    match status {
        Ok(status) if status.success() => Ok(()),
        Ok(_) => Err(failed("has refused the package".into())),
        Err(error) => Err(failed(format!("does not start: {error}"))),
    }
}
