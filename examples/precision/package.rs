//! The package with a chain: writes, builds and runs it.

use std::hash::{DefaultHasher, Hash, Hasher};
use std::io::{self, IsTerminal};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::{env, fs};

use mstmm_precision::Task;
use serde_json::Value;

/// The path of the library in its package, as in the compiler's messages.
const LIBRARY: &str = "src/subject.rs";

const PROGRAM: &str = "fn main() -> mstmm_precision::ExitCode {
    <subject::MstmmPrecision as mstmm_precision::Chosen>::compare()
}
";

/// Builds the program with this library, whose positions are those of `file`, and returns its path.
pub fn build(file: &Path, library: &str) -> Result<PathBuf, String> {
    let name = package_name(file);
    let (target, package) = write(&name, library).map_err(|error| format!("error: {error}"))?;
    let colours = if io::stderr().is_terminal() { "-diagnostic-rendered-ansi" } else { "" };
    // Lints that the user's crate denies are ignored here.
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
    let (mut errors, mut executable) = (String::new(), None);
    for message in messages {
        if message["message"]["level"] == "error" {
            let rendered = message["message"]["rendered"].as_str().unwrap_or_default();
            errors += &rendered.replace(LIBRARY, &file.display().to_string());
        }
        if let Some(path) = message["executable"].as_str() {
            executable = Some(PathBuf::from(path));
        }
    }
    match executable {
        Some(executable) if built.status.success() => Ok(executable),
        _ if errors.is_empty() => Err("error: the chain cannot be built".to_owned()),
        _ => Err(errors.trim_end().to_owned()),
    }
}

/// Runs the program and returns its output.
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

/// Returns a unique name for this file.
fn package_name(file: &Path) -> String {
    let stem = file.file_stem().unwrap_or_default().to_string_lossy();
    let plain = |c: char| if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { '-' };
    let mut hasher = DefaultHasher::new();
    fs::canonicalize(file).unwrap_or_else(|_| file.to_owned()).hash(&mut hasher);
    let path_hash = hasher.finish() as u32;
    format!("precision-{}-{path_hash:08x}", stem.chars().map(plain).collect::<String>())
}

/// Writes the package; returns the folder in which all packages are built, and the package's folder.
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
        // An unchanged file is not written, so that cargo does not build it again.
        if !fs::read_to_string(&path).is_ok_and(|before| before == text) {
            fs::write(path, text)?;
        }
    }
    // The versions with which the workspace is tested.
    let (locked, lock) = (workspace.join("Cargo.lock"), package.join("Cargo.lock"));
    if locked.exists() && !lock.exists() {
        fs::copy(locked, lock)?;
    }
    Ok((folder.join("target"), package))
}
