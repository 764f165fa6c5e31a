//! The files of a new project.

mod dependency;

pub use dependency::Dependency;

use mstmm_codegen::CheckedChain;
use mstmm_codegen::model::{Dimension, Results};

/// The text of the chain of a project without a file.
pub const FIRST: &str = include_str!("crane.chain");

/// The program, with placeholders in braces.
const PROGRAM: &str = include_str!("main.rs.txt");

/// Returns the program for a chain with this text from a file of this name, which may be empty.
#[must_use]
pub fn program(chain: &CheckedChain, text: &str, file: &str) -> String {
    let from = if file.is_empty() { String::new() } else { format!(" of `{file}`") };
    PROGRAM
        .replace("{from}", &from)
        .replace("{Chain}", &chain.chain.name.to_string())
        .replace("{loads}", loads(chain))
        // Last, since a text may contain braces.
        .replace("{chain}", &indented(text))
}

/// Returns the files of a project for a microcontroller, with their paths, except for `Cargo.toml`.
#[must_use]
pub fn firmware(
    chain: &CheckedChain,
    text: &str,
    file: &str,
    package: &str,
) -> Vec<(&'static str, String)> {
    let from = if file.is_empty() { String::new() } else { format!(" of `{file}`") };
    let library = include_str!("firmware/lib.rs.txt")
        .replace("{from}", &from)
        .replace("{Chain}", &chain.chain.name.to_string())
        .replace("{chain}", &indented(text));
    let main =
        include_str!("firmware/main.rs.txt").replace("{package}", &package.replace('-', "_"));
    vec![
        ("src/lib.rs", library),
        ("src/main.rs", main),
        ("build.rs", include_str!("firmware/build.rs.txt").to_owned()),
        ("memory.x", include_str!("firmware/memory.x.txt").to_owned()),
    ]
}

/// Returns the end of the `Cargo.toml` of a project for a microcontroller, after its heading `[dependencies]`.
#[must_use]
pub fn firmware_dependencies(dependency: &Dependency) -> String {
    include_str!("firmware/Cargo.toml.txt").replace("{mstmm}", &dependency.without_std())
}

/// Returns the statements that print the results of the last state.
fn loads(chain: &CheckedChain) -> &'static str {
    match (chain.chain.results, chain.chain.dimension) {
        (Results { z: false, .. }, _) => include_str!("accelerations.rs.txt"),
        (_, Dimension::Space) => include_str!("loads_in_space.rs.txt"),
        (_, Dimension::Plane) => include_str!("loads_in_plane.rs.txt"),
        (_, Dimension::Line) => include_str!("loads_on_line.rs.txt"),
    }
}

/// Returns the lines of a text as the content of a macro call.
#[must_use]
pub fn indented(text: &str) -> String {
    let lines: Vec<&str> = text.lines().collect();
    let is_blank = |line: &&str| line.trim().is_empty();
    let first = lines.iter().position(|line| !is_blank(line)).unwrap_or(0);
    let last = lines.iter().rposition(|line| !is_blank(line)).map_or(0, |last| last + 1);
    let lines = &lines[first.min(last)..last];
    let width = |line: &&str| line.len() - line.trim_start_matches(' ').len();
    let margin = lines.iter().filter(|line| !is_blank(line)).map(width).min().unwrap_or(0);
    let indent = |line: &&str| match is_blank(line) {
        true => String::new(),
        false => format!("    {}", line[margin..].trim_end()),
    };
    lines.iter().map(indent).collect::<Vec<_>>().join("\n")
}
