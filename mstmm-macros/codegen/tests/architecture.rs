//! The structure of the compiler: who may know whom, and how long a file may be.

use std::fs;
use std::path::{Path, PathBuf};

/// Each folder or file of `src`, and what of ours it may name.
const MAY_USE: &[(&str, &[&str])] = &[
    ("diag.rs", &[]),
    ("ids.rs", &[]),
    ("syntax", &["diag"]),
    ("model", &["diag", "ids", "syntax"]),
    ("math", &[]),
    ("equations", &["ids", "math", "model"]),
    ("examine", &["diag", "equations", "math", "model"]),
    ("expr", &["math"]),
    ("program", &["ids"]),
    ("passes", &["expr", "ids", "math", "program"]),
    ("symbols.rs", &["model"]),
    ("weave.rs", &["equations", "expr", "ids"]),
    (
        "compile",
        &["equations", "examine", "expr", "ids", "model", "passes", "program", "symbols", "weave"],
    ),
    ("emit", &["compile", "diag", "examine", "ids", "model", "program", "syntax"]),
    ("lib.rs", &[]),
];

/// Words that name foreign crates, and who alone may use them.
const MAY_QUOTE: &[&str] = &["emit", "lib.rs", "diag.rs", "symbols.rs", "syntax", "model"];

const LONGEST_FILE: usize = 400;

fn source() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("src")
}

fn files(path: &Path) -> Vec<PathBuf> {
    if path.is_file() {
        return vec![path.to_owned()];
    }
    if path.ends_with("tests") {
        return Vec::new();
    }
    let entries = fs::read_dir(path).expect("a readable folder");
    let mut all: Vec<PathBuf> =
        entries.flat_map(|entry| files(&entry.expect("an entry").path())).collect();
    all.sort();
    all
}

/// The modules of ours that a text names behind `crate::`.
fn named(text: &str) -> Vec<&str> {
    let code = text.split("#[cfg(test)]").next().unwrap_or(text);
    let lines = code.lines().filter(|line| !line.trim_start().starts_with("//"));
    lines
        .flat_map(|line| line.split("crate::").skip(1))
        .filter_map(|rest| rest.split(|c: char| !c.is_alphanumeric() && c != '_').next())
        .filter(|name| !name.is_empty())
        .collect()
}

#[test]
fn every_part_knows_only_what_stands_before_it() {
    for (part, allowed) in MAY_USE {
        for file in files(&source().join(part)) {
            let text = fs::read_to_string(&file).expect("a readable file");
            let itself = part.trim_end_matches(".rs");
            assert!(!text.contains("crate::{"), "{}: name one part a line", file.display());
            for name in named(&text) {
                assert!(
                    name == itself || allowed.contains(&name),
                    "{} names `{name}`, which `{part}` must not know",
                    file.display()
                );
            }
        }
    }
}

#[test]
fn the_model_knows_the_syntax_only_where_it_is_lowered_and_checked() {
    for file in files(&source().join("model")) {
        let text = fs::read_to_string(&file).expect("a readable file");
        let entry = file.ends_with("model/mod.rs");
        let reads = |part| part == "lower" || part == "check";
        let reads = entry || file.iter().any(reads);
        assert!(reads || !named(&text).contains(&"syntax"), "{} names it", file.display());
    }
}

#[test]
fn every_part_is_listed() {
    for entry in fs::read_dir(source()).expect("a readable folder") {
        let name = entry.expect("an entry").file_name();
        let name = name.to_string_lossy();
        assert!(MAY_USE.iter().any(|(part, _)| *part == name), "{name} is not listed");
    }
}

#[test]
fn tokens_are_known_to_both_ends_of_the_pipeline_only() {
    for file in files(&source()) {
        let text = fs::read_to_string(&file).expect("a readable file");
        let part = file.strip_prefix(source()).expect("a part of the source");
        let part = part.iter().next().expect("a name").to_string_lossy().into_owned();
        let uses = ["syn::", "quote::", "quote!"].iter().any(|word| {
            text.lines().any(|line| !line.trim_start().starts_with("//") && line.contains(word))
        });
        assert!(!uses || MAY_QUOTE.contains(&part.as_str()), "{} knows tokens", file.display());
    }
}

#[test]
fn files_are_short() {
    for file in files(&source()) {
        let lines = fs::read_to_string(&file).expect("a readable file").lines().count();
        assert!(lines <= LONGEST_FILE, "{} has {lines} lines; split it by idea", file.display());
    }
}
