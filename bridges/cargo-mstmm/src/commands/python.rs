//! `cargo mstmm python`

use clap::Args;
use std::path::{Path, PathBuf};
use std::process::Command;

use super::{Failure, write};
use crate::new::{Dependency, indented};
use crate::python::{Module, module_name};
use crate::source::Source;

/// Build a Python wheel of chains
///
/// The wheel has a class for each chain, with type stubs. The command needs Rust, Python 3.10 or newer with numpy, and
/// maturin (`pip install maturin numpy`).
#[derive(Args, Debug)]
pub struct Python {
    /// Files with chains; `-` is standard input
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
    /// The name of the module, otherwise that of the first chain in snake case
    #[arg(long)]
    name: Option<String>,
    /// The version of the wheel, three numbers
    #[arg(long, value_name = "VERSION", default_value = "0.1.0")]
    version: String,
    /// The folder for the wheel
    #[arg(short, long, value_name = "FOLDER", default_value = ".")]
    output: PathBuf,
    /// Build for the processor of this machine, with fused operations: faster, not portable, and with other bits
    #[arg(long)]
    native: bool,
    /// Depend on the crates of this checkout of mstmm; without it on the one that this command was built from
    #[arg(long, value_name = "FOLDER")]
    path: Option<PathBuf>,
    /// The folder for the Rust project, otherwise one in the folder for temporary files
    #[arg(long, value_name = "FOLDER")]
    project: Option<PathBuf>,
}

/// Runs the command.
///
/// # Errors
///
/// If a file cannot be read or written, a chain has errors, or maturin is not installed or fails.
pub fn run(arguments: &Python) -> Result<(), Failure> {
    let (mut texts, mut chains) = (Vec::new(), Vec::new());
    for file in &arguments.files {
        let source = Source::read(file)?;
        let names = source.chains()?.into_iter().map(|checked| checked.chain.name.to_string());
        chains.extend(names);
        let text = source.inside().map_err(|message| Failure(message.message))?;
        texts.push(indented(text));
    }
    let name = match (&arguments.name, chains.first()) {
        (Some(name), _) => name.clone(),
        (None, Some(first)) => module_name(first),
        (None, None) => return Err(Failure("the files have no chain".into())),
    };
    let dependency = match &arguments.path {
        Some(path) => Dependency::in_folder(path)?,
        None => Dependency::default(),
    };
    let module = Module::new(&name, &arguments.version, &chains, &texts)?;
    let project = arguments.project.clone();
    let project =
        project.unwrap_or_else(|| std::env::temp_dir().join(format!("mstmm-python-{name}")));
    for (file, text) in module.files(&dependency, arguments.native) {
        let path = project.join(file);
        let folder = path.parent().unwrap_or(&project);
        let failed = |error| Failure(format!("{}: {error}", folder.display()));
        std::fs::create_dir_all(folder).map_err(failed)?;
        write(&text, Some(&path))?;
    }
    let stubs = project.join(format!("{name}.pyi"));
    // The first build is only for the stubs, which the module itself writes.
    let built = project.join("built");
    build(arguments, &project, &built)?;
    write(&stub_text(&built, &name)?, Some(&stubs))?;
    build(arguments, &project, &arguments.output)
}

/// Builds the wheel.
fn build(arguments: &Python, project: &Path, output: &Path) -> Result<(), Failure> {
    let mut maturin = Command::new("maturin");
    maturin.args(["build", "--release", "--quiet", "--manifest-path"]);
    maturin.arg(project.join("Cargo.toml")).arg("--out").arg(output);
    maturin.args(["--interpreter", "python3"]);
    if arguments.native {
        let flags = std::env::var("RUSTFLAGS").unwrap_or_default();
        maturin.env("RUSTFLAGS", format!("{flags} -C target-cpu=native"));
    }
    match maturin.status() {
        Ok(status) if status.success() => Ok(()),
        Ok(_) => Err(Failure(format!("maturin has failed in {}", project.display()))),
        Err(_) => {
            let text = "maturin is not installed: write `pip install maturin numpy`, or activate the environment that has it";
            Err(Failure(text.into()))
        }
    }
}

/// A program that prints the stubs of the only wheel in a folder.
const STUBS: &str = "\
import pathlib, sys, tempfile, zipfile
wheel = max(pathlib.Path(sys.argv[1]).glob('*.whl'), key=lambda path: path.stat().st_mtime)
with tempfile.TemporaryDirectory() as folder:
    zipfile.ZipFile(wheel).extractall(folder)
    sys.path.insert(0, folder)
    module = __import__(sys.argv[2])
    sys.stdout.write(getattr(module, sys.argv[2])._stubs())
";

/// Returns the stubs that a wheel writes of itself.
fn stub_text(wheels: &Path, name: &str) -> Result<String, Failure> {
    let python = Command::new("python3").args(["-c", STUBS]).arg(wheels).arg(name).output();
    let output = python.map_err(|error| Failure(format!("python3 does not start: {error}")))?;
    if !output.status.success() {
        let reason = String::from_utf8_lossy(&output.stderr).into_owned();
        let hint = if reason.contains("'numpy'") { "write `pip install numpy`\n" } else { "" };
        return Err(Failure(format!("the wheel cannot be imported: {hint}{reason}")));
    }
    String::from_utf8(output.stdout).map_err(|error| Failure(error.to_string()))
}
