//! `EQUATIONS.md` and the tags in the compiler's and the runtime's files say the same.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

/// Equation number to the files that carry its tag.
type Index = BTreeMap<u32, BTreeSet<String>>;

const LAST_EQUATION: u32 = 66;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The numbers in a tag such as `[P, Eqs. (17) to (19), (21)]`.
fn numbers(tag: &str) -> Vec<u32> {
    let mut all: Vec<u32> = Vec::new();
    for (position, part) in tag.split('(').enumerate().skip(1) {
        let Some(number) = part.split(')').next().and_then(|number| number.parse().ok()) else {
            continue;
        };
        let range = tag.split('(').nth(position - 1).is_some_and(|before| before.ends_with(" to "));
        let first = if range { all.last().map_or(number, |last| last + 1) } else { number };
        all.extend(first..=number);
    }
    all
}

/// All tags of the files in `folder`, under their names with `prefix` before.
fn tags(folder: &str, prefix: &str, index: &mut Index) {
    for entry in fs::read_dir(root().join(folder)).expect("a readable folder") {
        let path = entry.expect("an entry").path();
        let name = path.file_name().expect("a name").to_string_lossy().into_owned();
        if path.is_dir() {
            tags(&format!("{folder}/{name}"), &format!("{prefix}{name}/"), index);
        } else {
            let text = fs::read_to_string(&path).expect("a readable file");
            for tag in text.split("[P, Eq").skip(1).filter_map(|rest| rest.split(']').next()) {
                for number in numbers(tag) {
                    index.entry(number).or_default().insert(format!("{prefix}{name}"));
                }
            }
        }
    }
}

/// The rows of the table, and those equations that name no file but give no reason either.
fn rows() -> (Index, Vec<u32>) {
    let text = fs::read_to_string(root().join("EQUATIONS.md")).expect("the index");
    let (mut index, mut silent) = (Index::new(), Vec::new());
    for row in text.lines().filter(|line| line.starts_with("| (")) {
        let cells: Vec<&str> = row.split('|').map(str::trim).collect();
        let number = cells[1].trim_matches(['(', ')']).parse().expect("a number");
        let files: BTreeSet<String> = cells[3]
            .split(',')
            .map(|file| file.trim().to_owned())
            .filter(|file| !file.is_empty())
            .collect();
        if files.is_empty() && cells[4].is_empty() {
            silent.push(number);
        }
        assert!(index.insert(number, files).is_none(), "({number}) stands twice");
    }
    (index, silent)
}

#[test]
fn the_index_and_the_tags_agree() {
    let mut tagged = Index::new();
    tags("src", "", &mut tagged);
    tags("../../mstmm-runtime/src", "runtime/", &mut tagged);
    let (rows, silent) = rows();
    let mut differences = Vec::new();
    for number in 1..=LAST_EQUATION {
        let row = rows.get(&number).unwrap_or_else(|| panic!("({number}) has no row"));
        let files = tagged.get(&number).cloned().unwrap_or_default();
        if *row != files {
            differences.push(format!("({number}): index {row:?}, tags {files:?}"));
        }
    }
    assert!(differences.is_empty(), "\n{}", differences.join("\n"));
    assert!(silent.is_empty(), "neither a file nor a reason for {silent:?}");
}

#[test]
fn ranges_are_read() {
    assert_eq!(numbers("s. (17) to (19), (21)"), [17, 18, 19, 21]);
    assert_eq!(numbers(". (8)"), [8]);
}
