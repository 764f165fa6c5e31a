//! The structure of the compiler: which module may use which, unique type names, and the length of files.

#[path = "architecture/imports.rs"]
mod imports;
#[path = "architecture/type_names.rs"]
mod type_names;

use imports::Imports;
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use type_names::type_names;

/// Each folder or file of `src`, and the modules of the compiler that it may use.
const MAY_USE: &[(&str, &[&str])] = &[
    ("diag.rs", &[]),
    ("ids.rs", &[]),
    ("syntax", &["diag"]),
    ("model", &["diag", "ids", "math", "syntax"]),
    ("math", &[]),
    ("equations", &["ids", "math", "model"]),
    ("examine", &["diag", "equations", "ids", "math", "model"]),
    ("expr", &["ids", "math"]),
    ("program", &["diag", "ids"]),
    ("function", &["diag", "equations", "expr", "ids", "program"]),
    ("passes", &["diag", "expr", "function", "ids", "math", "program"]),
    (
        "compile",
        &[
            "diag",
            "equations",
            "examine",
            "expr",
            "function",
            "ids",
            "math",
            "model",
            "passes",
            "program",
        ],
    ),
    ("emit", &["compile", "diag", "examine", "ids", "model", "program", "syntax"]),
    ("lib.rs", &[]),
];

/// The folders and files that may use `syn` and `quote`.
const MAY_QUOTE: &[&str] = &["emit", "lib.rs", "diag.rs", "compile", "syntax", "model"];

const LONGEST_FILE: usize = 400;

fn source() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("src")
}

fn files(path: &Path) -> Vec<PathBuf> {
    if path.ends_with("tests") || path.ends_with("tests.rs") {
        return Vec::new();
    }
    if path.is_file() {
        return vec![path.to_owned()];
    }
    let entries = fs::read_dir(path).expect("a readable folder");
    let mut all: Vec<PathBuf> =
        entries.flat_map(|entry| files(&entry.expect("an entry").path())).collect();
    all.sort();
    all
}

/// Returns the modules that a text names after `crate::`.
fn named(text: &str) -> Vec<&str> {
    let lines = without_tests(text).lines().filter(|line| !line.trim_start().starts_with("//"));
    lines
        .flat_map(|line| line.split("crate::").skip(1))
        .filter_map(|rest| rest.split(|c: char| !c.is_alphanumeric() && c != '_').next())
        .filter(|name| !name.is_empty())
        .collect()
}

#[test]
fn every_module_uses_only_earlier_modules() {
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
fn the_model_uses_the_syntax_only_to_lower_and_check() {
    for file in files(&source().join("model")) {
        let text = fs::read_to_string(&file).expect("a readable file");
        let entry = file.ends_with("model/mod.rs");
        let reads = |part| part == "lower" || part == "check";
        let reads = entry || file.iter().any(reads);
        assert!(reads || !named(&text).contains(&"syntax"), "{} names it", file.display());
    }
}

#[test]
fn every_module_is_listed() {
    for entry in fs::read_dir(source()).expect("a readable folder") {
        let name = entry.expect("an entry").file_name();
        let name = name.to_string_lossy();
        assert!(MAY_USE.iter().any(|(part, _)| *part == name), "{name} is not listed");
    }
}

#[test]
fn only_both_ends_of_the_pipeline_use_tokens() {
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
fn no_modules_of_a_folder_import_each_other_in_cycles() {
    let runtime = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../mstmm-runtime/src");
    for source in [source(), runtime] {
        let texts = files(&source).into_iter().map(|file| {
            let text = fs::read_to_string(&file).expect("a readable file");
            let name = file.strip_prefix(&source).expect("a part of the source");
            (name.to_string_lossy().into_owned(), code(&text))
        });
        let texts: Vec<(String, String)> = texts.collect();
        let imports = Imports::of(texts.iter().map(|(name, code)| (name.as_str(), code.as_str())));
        assert_eq!(imports.circles(), Vec::<String>::new());
    }
}

#[test]
fn no_type_name_is_defined_twice() {
    let mut definitions: BTreeMap<String, Vec<String>> = BTreeMap::new();
    let is_rust = |file: &PathBuf| file.extension().is_some_and(|extension| extension == "rs");
    for file in files(&source()).into_iter().filter(is_rust) {
        let text = fs::read_to_string(&file).expect("a readable file");
        let file = file.strip_prefix(source()).expect("a part of the source").display().to_string();
        for name in type_names(&text) {
            definitions.entry(name).or_default().push(file.clone());
        }
    }
    definitions.retain(|_, files| files.len() > 1);
    assert_eq!(definitions, BTreeMap::new(), "rename the less standard of each");
}

#[test]
fn type_names_are_found_in_all_modules_except_tests() {
    let text = "
        pub struct Body<T>(T);
        declare_id! { /// A body.
            BodyId, LinkId }
        mod inner { pub(crate) enum Kind { Pin } type Pair = (u8, u8); }
        trait Shape { type Area; }
        impl Shape for () { type Area = f64; }
        fn f() { union Bits { a: u32, b: f32 } quote!(struct Generated;); }
        #[cfg(test)]
        mod tests { struct Fixture; }
    ";
    assert_eq!(type_names(text), ["Body", "BodyId", "LinkId", "Kind", "Pair", "Shape", "Bits"]);
}

#[test]
fn import_cycles_are_found() {
    let circles = |files: &[(&str, &str)]| Imports::of(files.iter().copied()).circles();
    let emit = [
        ("emit/procedure.rs", "use super::{Plan, checks, loads::{self, once}}; struct Printer;"),
        ("emit/checks.rs", "use super::procedure::Printer;"),
        ("emit/loads.rs", "pub fn once() { crate::emit::loops::opened(); }"),
        ("emit/loops.rs", "pub fn opened() {}"),
        ("emit/mod.rs", "mod checks; use super::Chain;"),
    ];
    assert_eq!(circles(&emit), ["emit/{checks, procedure}"]);
    let handed_on = [
        ("math/mod.rs", "pub use matrix::{Mat3, Sym3}; pub use vector::Vec3;"),
        ("math/matrix.rs", "use super::Vec3;"),
        ("math/vector.rs", "fn skew() -> super::Mat3 {}"),
        ("math/scalar.rs", "pub trait Scalar { fn pair(self) -> (Self, Self); }"),
    ];
    assert_eq!(circles(&handed_on), ["math/{matrix, vector}"]);
    let folders = [
        ("equations/mod.rs", "mod hinge; mod kinematics; mod strategy;"),
        ("equations/hinge/law.rs", "use super::super::strategy::waits; pub struct Law;"),
        ("equations/hinge/mod.rs", "mod law; pub use law::Law;"),
        ("equations/strategy.rs", "use super::kinematics::Axes;"),
        ("equations/kinematics/mod.rs", "mod crossed; pub enum Axes {}"),
        ("equations/kinematics/crossed.rs", "use crate::equations::hinge::Law;"),
    ];
    assert_eq!(circles(&folders), ["equations/{hinge, kinematics, strategy}"]);
    assert_eq!(circles(&folders[..5]), [""; 0]);
}

/// Returns a text without the tests at its end. `#[cfg(test)] mod tests;` does not end the text.
fn without_tests(text: &str) -> &str {
    let begins_tests =
        |at: &usize| text[*at..].lines().nth(1).is_some_and(|line| line.ends_with('{'));
    let all = text.match_indices("#[cfg(test)]").map(|(at, _)| at);
    &text[..all.into_iter().find(begins_tests).unwrap_or(text.len())]
}

/// Returns a text's code without tests, comments and line breaks.
fn code(text: &str) -> String {
    let lines =
        without_tests(text).lines().map(|line| line.split("//").next().unwrap_or(line).trim());
    lines.collect::<Vec<_>>().join(" ")
}

/// Returns whether `text` contains `word` as a whole word.
fn has_word(text: &str, word: &str) -> bool {
    text.split(|c: char| !c.is_alphanumeric() && c != '_').any(|found| found == word)
}

/// Returns the iterated expressions of `for` loops, and the statements with `.rev()`.
fn loops(code: &str) -> Vec<&str> {
    let headers = code.split(" for ").skip(1).filter_map(|rest| {
        let (header, _) = rest.split_once('{')?;
        header.split_once(" in ").map(|(_, over)| over)
    });
    let statements = code.split([';', '{', '}']).filter(|statement| statement.contains(".rev()"));
    headers.chain(statements).collect()
}

/// Returns the loops over links, and those along paths of links.
fn sweeps_by_hand(code: &str) -> Vec<&str> {
    let statements = code.split([';', '{', '}']).filter(|statement| statement.contains(".fold("));
    let along_paths = loops(code).into_iter().chain(statements).filter(|it| has_word(it, "path"));
    loops(code).into_iter().filter(|over| has_word(over, "links")).chain(along_paths).collect()
}

#[test]
fn only_the_sweeps_loop_over_links() {
    let folder = source().join("equations");
    for file in files(&folder).into_iter().filter(|file| !file.ends_with("sweep.rs")) {
        let text = fs::read_to_string(&file).expect("a readable file");
        let by_hand = code(&text);
        assert_eq!(sweeps_by_hand(&by_hand), [""; 0], "{} sweeps by hand", file.display());
    }
}

#[test]
fn one_match_in_the_model_and_one_in_the_equations_are_over_all_hinge_kinds() {
    let all = |file: &&PathBuf| {
        let text = code(&fs::read_to_string(file).expect("a readable file"));
        ["Pin", "Ball", "Floating", "Elastic"].iter().all(|kind| {
            [" ", ",", ")"].iter().any(|end| text.contains(&format!("HingeKind::{kind}{end}")))
        })
    };
    let every = files(&source());
    let with_all: Vec<&PathBuf> = every.iter().filter(all).collect();
    let kinds = ["equations/hinge/kinds.rs", "model/hinge/mod.rs"].map(|file| source().join(file));
    assert_eq!(with_all, kinds.iter().collect::<Vec<_>>());
    for file in kinds {
        let text = fs::read_to_string(file).expect("a readable file");
        assert_eq!(code(&text).matches("match self").count(), 1, "one match over all kinds");
    }
}

#[test]
fn the_equations_name_hinge_kinds_in_one_place() {
    let kinds = source().join("equations/hinge/kinds.rs");
    for file in files(&source().join("equations")).into_iter().filter(|file| *file != kinds) {
        let text = fs::read_to_string(&file).expect("a readable file");
        assert!(!code(&text).contains("HingeKind::"), "{} names a kind", file.display());
    }
}

#[test]
fn hand_written_sweeps_are_found() {
    let sweeps = [
        "for (index, link) in situation.layout.links.iter().enumerate() {}",
        "for (index, link) in\n    links // all\n        .enumerate()\n{}",
        "for index in (0..links.len()).rev() {}",
        "while let Some(last) = links.iter().rev().next() {}",
        "let all = links\n    .iter()\n    .rev().map(pass);",
        "for &link in path.iter().rev() {}",
        "let force = path.iter().fold(force, to_child);",
    ];
    let others = [
        "for (index, load) in chain.loads.enumerate() {}",
        "links.iter().map(own).collect();",
        "tree.carry_outward(path, force, to_child);",
    ];
    let by_hand = |text: &str| !sweeps_by_hand(&code(&format!("fn f() {{\n{text}\n}}"))).is_empty();
    sweeps.iter().for_each(|text| assert!(by_hand(text), "{text}"));
    others.iter().for_each(|text| assert!(!by_hand(text), "{text}"));
}

#[test]
fn files_are_short() {
    for file in files(&source()) {
        let lines = fs::read_to_string(&file).expect("a readable file").lines().count();
        assert!(lines <= LONGEST_FILE, "{} has {lines} lines; split it by idea", file.display());
    }
}
