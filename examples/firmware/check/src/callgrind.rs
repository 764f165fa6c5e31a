//! Instructions of a step on this machine, one step at a time.

use std::fmt;
use std::fs;
use std::path::Path;
use std::process::Command;

use anyhow::{Context, Result, ensure};
use object::{Object, ObjectSymbol};

use crate::case::Case;

/// The argument with which this program takes steps and does nothing else.
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

/// Valgrind and its version, if there is one.
pub fn version() -> Option<String> {
    let output = Command::new("valgrind").arg("--version").output().ok()?;
    output.status.success().then(|| String::from_utf8_lossy(&output.stdout).trim().into())
}

/// Counts each step that this program takes when it is started for that: what callgrind writes after
/// each of them holds the instructions of that one alone.
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
        // What is left at the end of the program holds no step.
        counts.extend(total(&file?.path())?.filter(|&count| count > 0));
    }
    let found = || format!("callgrind saw no step of {case}");
    Ok(Counts {
        fewest: *counts.iter().min().with_context(found)?,
        most: *counts.iter().max().with_context(found)?,
    })
}

/// The symbols of a program that have a word in their names: after which to write, callgrind wants
/// to know in full.
fn symbols(program: &Path, word: &str) -> Result<Vec<String>> {
    let bytes = fs::read(program)?;
    let file = object::File::parse(&*bytes)?;
    let names = file.symbols().filter_map(|symbol| symbol.name().ok().map(String::from));
    Ok(names.filter(|name| name.contains(word)).collect())
}

/// The instructions that a file of callgrind sums up, if it does.
fn total(path: &Path) -> Result<impl Iterator<Item = u64> + use<>> {
    let text = fs::read_to_string(path)?;
    let summary = text.lines().find_map(|line| line.strip_prefix("summary: "));
    Ok(summary.map(str::parse).transpose()?.into_iter())
}
