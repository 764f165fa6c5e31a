//! Tests that `EQUATIONS.md` lists exactly the tags in the compiler's and the runtime's files, each with its file and the
//! item that it documents.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

/// For each equation number the files with its tag, and the items that the tags document. A tag in the docs of a file has no
/// item.
type Index = BTreeMap<u32, BTreeMap<String, BTreeSet<String>>>;

const LAST_EQUATION: u32 = 66;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Returns the numbers in a tag such as `[P, Eqs. (17) to (19), (21)]`.
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

/// Returns a text without line breaks and the comment slashes after them.
fn unbroken(text: &str) -> String {
    let words = text.lines().map(|line| line.trim_start().trim_start_matches(['/', '!']).trim());
    words.collect::<Vec<_>>().join(" ")
}

/// Returns the tags of a text, each with its position.
fn tags(text: &str) -> Vec<(usize, String)> {
    let tag = |(at, _): (usize, &str)| {
        let words = unbroken(text[at..].split(']').next()?);
        words.strip_prefix("[P, Eq").map(|words| (at, words.to_owned()))
    };
    text.match_indices("[P,").filter_map(tag).collect()
}

/// Returns the name that a line declares: of a function, a type, a constant, a field or a variant.
fn declared(line: &str) -> Option<&str> {
    let words = line.split(|c: char| !c.is_alphanumeric() && c != '_');
    let marks =
        ["pub", "super", "crate", "in", "const", "fn", "struct", "enum", "type", "trait", ""];
    let mut names = words.skip_while(|word| marks.contains(word));
    names.next().filter(|name| *name != "mod" && *name != "impl")
}

/// Returns whether a line starts a function, a type or a constant.
fn declares_item(line: &str) -> bool {
    let line = line.trim_start_matches("pub").trim_start_matches("(super)").trim_start();
    let words = ["fn ", "const ", "struct ", "enum ", "type "];
    words.iter().any(|word| line.starts_with(word))
}

/// Returns the item of a tag: the item that it documents, or the item that contains it.
fn item(text: &str, at: usize) -> Option<String> {
    let lines: Vec<&str> = text.lines().map(str::trim_start).collect();
    let line = text[..at].matches('\n').count();
    let found = if lines[line].starts_with("//!") {
        None
    } else if lines[line].starts_with("///") {
        lines[line..].iter().find(|line| !line.starts_with("///") && !line.starts_with('#'))
    } else {
        lines[..=line].iter().rev().find(|line| declares_item(line))
    };
    found.and_then(|line| declared(line)).map(str::to_owned)
}

/// Collects all tags of the files in `folder`, under their names with a `prefix`.
fn collect(folder: &str, prefix: &str, index: &mut Index) {
    for entry in fs::read_dir(root().join(folder)).expect("a readable folder") {
        let path = entry.expect("an entry").path();
        let name = path.file_name().expect("a name").to_string_lossy().into_owned();
        if path.is_dir() {
            collect(&format!("{folder}/{name}"), &format!("{prefix}{name}/"), index);
            continue;
        }
        let text = fs::read_to_string(&path).expect("a readable file");
        for (at, tag) in tags(&text) {
            for number in numbers(&tag) {
                let files = index.entry(number).or_default();
                let items = files.entry(format!("{prefix}{name}")).or_default();
                items.extend(item(&text, at));
            }
        }
    }
}

/// Formats a cell of the table: `file: item, item; file`.
fn cell(files: &BTreeMap<String, BTreeSet<String>>) -> String {
    let file = |(file, items): (&String, &BTreeSet<String>)| {
        let items: Vec<&str> = items.iter().map(String::as_str).collect();
        if items.is_empty() { file.clone() } else { format!("{file}: {}", items.join(", ")) }
    };
    files.iter().map(file).collect::<Vec<_>>().join("; ")
}

/// Returns the rows of the table: files and remark, by equation number.
fn rows() -> BTreeMap<u32, (String, String)> {
    let text = fs::read_to_string(root().join("EQUATIONS.md")).expect("the index");
    let mut rows = BTreeMap::new();
    for row in text.lines().filter(|line| line.starts_with("| (")) {
        let cells: Vec<&str> = row.split('|').map(str::trim).collect();
        let number = cells[1].trim_matches(['(', ')']).parse().expect("a number");
        let row = (cells[3].to_owned(), cells[4].to_owned());
        assert!(rows.insert(number, row).is_none(), "({number}) stands twice");
    }
    rows
}

#[test]
fn the_index_and_the_tags_agree() {
    let mut tagged = Index::new();
    collect("src", "", &mut tagged);
    collect("../../mstmm-runtime/src", "runtime/", &mut tagged);
    let rows = rows();
    let outside =
        tagged.keys().chain(rows.keys()).find(|number| !(1..=LAST_EQUATION).contains(*number));
    assert_eq!(outside, None, "the paper has no such equation");
    let mut differences = Vec::new();
    for number in 1..=LAST_EQUATION {
        let (row, remark) = rows.get(&number).unwrap_or_else(|| panic!("({number}) has no row"));
        let tags = tagged.get(&number).map(cell).unwrap_or_default();
        if *row != tags {
            differences
                .push(format!("({number}): the index has\n  {row}\nand the tags are\n  {tags}"));
        }
        let compiled = tagged
            .get(&number)
            .is_some_and(|files| files.keys().any(|file| !file.starts_with("runtime/paper/")));
        let said = compiled || !remark.is_empty();
        assert!(said, "({number}) is not in the compiler, and there is no reason why");
    }
    assert!(differences.is_empty(), "\n{}", differences.join("\n"));
}

#[test]
fn ranges_are_read() {
    assert_eq!(numbers("s. (17) to (19), (21)"), [17, 18, 19, 21]);
    assert_eq!(numbers(". (8)"), [8]);
}

#[test]
fn tags_are_found_with_their_items() {
    let text = "//! Of all [P, Eq. (1)].\n\n/// A field of [P,\n/// Eqs. (2) to\n/// (4)].\n#[inline]\n\
                pub fn turn() {\n    // [P, Eq. (5)]\n}\n\nstruct B {\n    /// [P, Eq. (6)]\n    pub e1: T,\n}\n";
    let found: Vec<_> =
        tags(text).into_iter().map(|(at, tag)| (numbers(&tag), item(text, at))).collect();
    let at = |name: &str| Some(name.to_owned());
    let expected =
        [(vec![1], None), (vec![2, 3, 4], at("turn")), (vec![5], at("turn")), (vec![6], at("e1"))];
    assert_eq!(found, expected);
}
