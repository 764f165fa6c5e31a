//! The pages of the words of `answers` (`src/keywords/answers.rs`): the text of the reference, and the names in
//! `src/terms.md` as aliases, so that a search of the documentation finds an answer by the name that other tools use. The
//! pages of the fields of hinges have such aliases, too.

use super::keywords::{Reference, linked, root};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::fs;

/// The tables of functions in `src/terms.md`: names of this library are in the first column here, in the last one below.
const FUNCTIONS: &str = "| here | MuJoCo | Drake | Pinocchio |";
const TEXTBOOKS: &str = "| textbooks | here |";

/// The tables of hinges and of the model, and the table of fields of hinges.
const MODELS: &str = "| here | URDF | MuJoCo | Drake | Pinocchio | Modelica |";
const FIELDS: &str = "| here | URDF | MuJoCo | Drake | Pinocchio | Modelica, at the axis flange |";

/// The page of a word.
struct Page {
    word: String,
    /// What the functions compute.
    about: String,
    /// The section of the reference.
    section: String,
    aliases: BTreeSet<String>,
}

impl Page {
    /// Returns whether the word generates a function of this name.
    fn has(&self, function: &str) -> bool {
        let begins = format!("`{function}(");
        let (cell, further) = (format!("| {begins}"), format!("`, {begins}"));
        let has = |line: &str| {
            line.starts_with(&begins)
                || line.starts_with(&cell)
                || line.starts_with('|') && line.contains(&further)
        };
        self.word == function || self.section.lines().any(has)
    }
}

/// Returns the identifiers in backticks, without arguments. The elements of MuJoCo's models have a slash.
fn names(cell: &str) -> impl Iterator<Item = &str> {
    let identifier = |name: &&str| {
        name.chars().all(|letter| letter.is_ascii_alphanumeric() || "_:/".contains(letter))
    };
    let code = cell.split('`').skip(1).step_by(2);
    code.map(|code| code.split('(').next().unwrap_or(code)).filter(identifier)
}

/// Returns the file of a page of the facade.
fn read(name: &str) -> String {
    fs::read_to_string(root().join("src").join(name)).expect("a page of the facade")
}

fn pages() -> Vec<Page> {
    let text = read("language.md");
    let reference = Reference(text.clone());
    let mut pages: Vec<Page> = reference
        .rows("| word | computes |")
        .into_iter()
        .map(|row| {
            let &[word, about] = &row[..] else { panic!("two cells: {row:?}") };
            let word = word.trim_matches('`').to_owned();
            let heading = format!("\n### `{word}`\n");
            let (_, rest) =
                text.split_once(&heading).unwrap_or_else(|| panic!("no section `{word}`"));
            let end = rest.find("\n##").expect("a section after those of the words");
            let section = rest[..end].to_owned();
            Page { word, about: about.to_owned(), section, aliases: BTreeSet::new() }
        })
        .collect();
    for (here, aliases) in named() {
        for page in &mut pages {
            if names(&here).any(|name| page.has(name)) {
                let aliases = aliases.iter().filter(|alias| **alias != page.word);
                page.aliases.extend(aliases.cloned());
            }
        }
    }
    pages.sort_by(|a, b| a.word.cmp(&b.word));
    pages
}

/// Returns the first cell of each row of the tables that begin with `head`, with the names that MuJoCo, Drake and
/// Pinocchio have.
fn of_tools(terms: &Reference, head: &str) -> Vec<(String, Vec<String>)> {
    let columns = if head == FUNCTIONS { 1..4 } else { 2..5 };
    let rows = terms.rows(head).into_iter().map(|row| {
        let cells = row[columns.clone()].iter();
        (row[0].to_owned(), cells.flat_map(|cell| names(cell).map(str::to_owned)).collect())
    });
    rows.collect()
}

/// Returns the names that other tools have for a field of `hinge` blocks, with a field's own name omitted.
pub(super) fn of_hinge_field(field: &str) -> BTreeSet<String> {
    let terms = Reference(read("terms.md"));
    let rows = of_tools(&terms, FIELDS).into_iter().filter(|(here, _)| {
        let here = here.replace(" = input", "");
        names(&here).any(|name| name == field)
    });
    rows.flat_map(|(_, others)| others).filter(|name| name != field).collect()
}

/// Returns the names of this library in each row of the tables of functions, with the names of others.
fn named() -> Vec<(String, Vec<String>)> {
    let terms = Reference(read("terms.md"));
    let of_tools = of_tools(&terms, FUNCTIONS);
    let of_textbooks = terms
        .rows(TEXTBOOKS)
        .into_iter()
        .map(|row| (row[1].to_owned(), row[0].split(", ").map(str::to_owned).collect()));
    of_tools.into_iter().chain(of_textbooks).collect()
}

/// Returns the words in alphabetical order, and the text of the module.
pub(super) fn module() -> (Vec<String>, String) {
    let mut text = String::from(
        "// Written by the test `keywords` of `mstmm-codegen` from `src/language.md` and `src/terms.md`: change the tables \
         there.\n",
    );
    let pages = pages();
    for Page { word, about, section, aliases } in &pages {
        write!(text, "\n/// `answers = {word};`: {about}.\n///\n").expect("a text");
        for line in linked(section.trim()).lines() {
            writeln!(text, "{}", format!("/// {line}").trim_end()).expect("a text");
        }
        text.push_str("///\n");
        let of_tools = aliases.iter().filter(|alias| names(&format!("`{alias}`")).next().is_some());
        let of_tools: Vec<String> = of_tools.map(|alias| format!("`{alias}`")).collect();
        if !of_tools.is_empty() {
            writeln!(text, "/// Other tools and textbooks: {}.\n///", of_tools.join(", "))
                .expect("a text");
        }
        text.push_str("/// See [answers](crate::mstmm_chain#answers).\n");
        for alias in aliases {
            writeln!(text, "#[doc(alias = {alias:?})]").expect("a text");
        }
        writeln!(text, "pub enum {word} {{}}").expect("a text");
    }
    (pages.into_iter().map(|page| page.word).collect(), text)
}

/// The documentation of the facade finds every name in the tables: by an alias, or as the name of a keyword or a module.
/// The search ignores case.
#[test]
fn names_of_other_tools_are_aliases() {
    let sources = ["src", "mstmm-runtime/src"].map(|folder| root().join(folder));
    let mut aliases = BTreeSet::new();
    let mut folders: Vec<_> = sources.into();
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).expect("a folder of sources") {
            let path = entry.expect("a file").path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|end| end == "rs") {
                let text = fs::read_to_string(path).expect("a text");
                let attributes = text.split("doc(alias").skip(1);
                let quoted = attributes.flat_map(|rest| {
                    let end = rest.find(")]").expect("the end of an attribute");
                    rest[..end].split('"').skip(1).step_by(2)
                });
                aliases.extend(quoted.map(str::to_lowercase));
                let items = ["pub mod ", "pub enum "].map(|item| text.split(item).skip(1));
                let items =
                    items.into_iter().flatten().filter_map(|rest| rest.split([' ', ';']).next());
                aliases.extend(items.map(str::to_lowercase));
            }
        }
    }
    let mut missing = BTreeMap::new();
    let terms = Reference(read("terms.md"));
    let models = [MODELS, FIELDS].into_iter().flat_map(|head| of_tools(&terms, head));
    for (here, others) in named().into_iter().chain(models) {
        let others = others.into_iter().filter(|name| !aliases.contains(&name.to_lowercase()));
        missing.extend(others.map(|name| (name, here.clone())));
    }
    assert!(missing.is_empty(), "names without `doc(alias)`: {missing:#?}");
}
