//! Instructions of a step on this machine, one step at a time.

use std::fmt;
use std::fs;
use std::path::Path;
use std::process::Command;

use anyhow::{Context, Result, ensure};
use object::{Object, ObjectSymbol};

use crate::case::Case;

/// The argument with which this program only takes steps.
pub const STEPS: &str = "--steps";

/// Fewest and most instructions of a step over random states.
#[derive(Clone, Copy, Debug)]
pub struct Counts {
    pub fewest: u64,
    pub most: u64,
}

impl fmt::Display for Counts {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} to {} instructions a step", self.fewest, self.most)
    }
}

/// Returns valgrind's version, if it is installed.
pub fn version() -> Option<String> {
    let output = Command::new("valgrind").arg("--version").output().ok()?;
    output.status.success().then(|| String::from_utf8_lossy(&output.stdout).trim().into())
}

/// Counts the instructions of each step of this program: callgrind writes the count of one step at a
/// time.
pub fn steps(case: Case) -> Result<Counts> {
    let folder = tempfile::tempdir()?;
    let program = std::env::current_exe()?;
    let mut command = Command::new("valgrind");
    command.args(["--tool=callgrind", "--demangle=no", "--toggle-collect=*counted_step*"]);
    for step in symbols(&program, "counted_step")? {
        command.arg(format!("--dump-after={step}"));
    }
    command.arg(format!("--callgrind-out-file={}", folder.path().join("step").display()));
    let output = command.arg(&program).args([STEPS, case.name()]).output()?;
    ensure!(output.status.success(), "valgrind: {}", String::from_utf8_lossy(&output.stderr));

    let mut counts = Vec::new();
    for file in fs::read_dir(folder.path())? {
        // The file at the end of the program contains no step.
        counts.extend(total(&file?.path())?.filter(|&count| count > 0));
    }
    let found = || format!("callgrind saw no step of {case}");
    Ok(Counts {
        fewest: *counts.iter().min().with_context(found)?,
        most: *counts.iter().max().with_context(found)?,
    })
}

/// Returns the symbols of a program with a word in their names: callgrind needs full names.
fn symbols(program: &Path, word: &str) -> Result<Vec<String>> {
    let bytes = fs::read(program)?;
    let file = object::File::parse(&*bytes)?;
    let names = file.symbols().filter_map(|symbol| symbol.name().ok().map(String::from));
    Ok(names.filter(|name| name.contains(word)).collect())
}

/// Returns the number of instructions in a file of callgrind, if it has a summary.
fn total(path: &Path) -> Result<impl Iterator<Item = u64> + use<>> {
    let text = fs::read_to_string(path)?;
    let summary = text.lines().find_map(|line| line.strip_prefix("summary: "));
    Ok(summary.map(str::parse).transpose()?.into_iter())
}
