//! The package that holds a chain: written, built and run.

use std::hash::{DefaultHasher, Hash, Hasher};
use std::io::{self, IsTerminal};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::{env, fs};

use mstmm_precision::Task;
use serde_json::Value;

/// Where the library lies in its package, as the compiler names it.
const LIBRARY: &str = "src/subject.rs";

const PROGRAM: &str = "fn main() -> mstmm_precision::ExitCode {
    <subject::MstmmPrecision as mstmm_precision::Chosen>::compare()
}
";

/// Builds the program around this library, which has its places from `file`, and says where it is.
pub fn build(file: &Path, library: &str) -> Result<PathBuf, String> {
    let name = package_name(file);
    let (target, package) = write(&name, library).map_err(|error| format!("error: {error}"))?;
    let colours = if io::stderr().is_terminal() { "-diagnostic-rendered-ansi" } else { "" };
    // What the user's crate denies is no matter here.
    let flags = env::var("RUSTFLAGS").unwrap_or_default() + " --cap-lints=warn";
    let cargo = env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let built = Command::new(cargo)
        .args(["build", "--release", &format!("--message-format=json{colours}")])
        .arg("--manifest-path")
        .arg(package.join("Cargo.toml"))
        .arg("--target-dir")
        .arg(target)
        .env("RUSTFLAGS", flags)
        .stderr(Stdio::inherit())
        .output()
        .map_err(|error| format!("error: cargo cannot be run: {error}"))?;
    let messages = String::from_utf8_lossy(&built.stdout);
    let messages = messages.lines().filter_map(|line| serde_json::from_str::<Value>(line).ok());
    let (mut mistakes, mut executable) = (String::new(), None);
    for message in messages {
        if message["message"]["level"] == "error" {
            let rendered = message["message"]["rendered"].as_str().unwrap_or_default();
            mistakes += &rendered.replace(LIBRARY, &file.display().to_string());
        }
        if let Some(path) = message["executable"].as_str() {
            executable = Some(PathBuf::from(path));
        }
    }
    match executable {
        Some(executable) if built.status.success() => Ok(executable),
        _ if mistakes.is_empty() => Err("error: the chain cannot be built".to_owned()),
        _ => Err(mistakes.trim_end().to_owned()),
    }
}

/// Runs the program, and hands on what it prints.
pub fn run(executable: &Path, task: &Task) -> Result<String, String> {
    let task = serde_json::to_string(task).map_err(|error| format!("error: {error}"))?;
    let run = Command::new(executable).arg(task).output();
    let run = run.map_err(|error| format!("error: {}: {error}", executable.display()))?;
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    match run.status.success() {
        true => Ok(text(&run.stdout)),
        false if run.stderr.is_empty() => Err(format!("error: the comparison: {}", run.status)),
        false => Err(text(&run.stderr).trim_end().to_owned()),
    }
}

/// A name for this file that no other one has.
fn package_name(file: &Path) -> String {
    let stem = file.file_stem().unwrap_or_default().to_string_lossy();
    let plain = |c: char| if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { '-' };
    let mut hasher = DefaultHasher::new();
    fs::canonicalize(file).unwrap_or_else(|_| file.to_owned()).hash(&mut hasher);
    let place = hasher.finish() as u32;
    format!("precision-{}-{place:08x}", stem.chars().map(plain).collect::<String>())
}

/// Writes the package; the folder that all packages are built in, and its own.
fn write(name: &str, library: &str) -> io::Result<(PathBuf, PathBuf)> {
    let examples = Path::new(env!("CARGO_MANIFEST_DIR"));
    let workspace = examples.parent().unwrap_or(examples);
    let target = match env::var_os("CARGO_TARGET_DIR") {
        Some(folder) => std::path::absolute(folder)?,
        None => workspace.join("target"),
    };
    let folder = target.join("precision");
    let package = folder.join(name);
    fs::create_dir_all(package.join("src"))?;
    let manifest = format!(
        "[package]\nname = \"{name}\"\nedition = \"2024\"\npublish = false\n\n\
         [lib]\nname = \"subject\"\npath = {LIBRARY:?}\n\n\
         [dependencies]\nmstmm = {{ path = {workspace:?} }}\n\
         mstmm-precision = {{ path = {comparison:?} }}\n\n\
         # Not a member of a workspace around it.\n[workspace]\n\n\
         # Of all that this needs only the runtime takes time when it runs.\n\
         [profile.release.package.\"*\"]\nopt-level = 0\n\n\
         [profile.release.package.mstmm-runtime]\nopt-level = 3\n",
        comparison = examples.join("precision").join("comparison"),
    );
    for (path, text) in
        [("Cargo.toml", manifest.as_str()), (LIBRARY, library), ("src/main.rs", PROGRAM)]
    {
        let path = package.join(path);
        // What is as it was need not be built again.
        if !fs::read_to_string(&path).is_ok_and(|before| before == text) {
            fs::write(path, text)?;
        }
    }
    // The versions that everything here is tried with.
    let (locked, lock) = (workspace.join("Cargo.lock"), package.join("Cargo.lock"));
    if locked.exists() && !lock.exists() {
        fs::copy(locked, lock)?;
    }
    Ok((folder.join("target"), package))
}
