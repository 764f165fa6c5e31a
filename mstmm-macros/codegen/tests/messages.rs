//! Tests that every message about a description has exactly one case that shows it in full: in `tests/ui` of the workspace,
//! rendered by rustc, or in the tests of `model`.

use proc_macro2::{TokenStream, TokenTree};
use std::fs;
use std::path::{Path, PathBuf};

/// Shorter texts are names of quantities or parts of messages.
const WORDS: usize = 4;

/// The number of words of a long message, which the tests of `model` abbreviate with `…` if `tests/ui` shows it.
const LONG: usize = 8;

/// The macros and methods whose texts no user of the language sees.
const NOT_MESSAGES: [&str; 4] = ["bug", "panic", "unreachable", "debug_assert"];

/// A component takes no unit, and a wrong one is reported as such before its quantity is named.
const NEVER_SHOWN: &str = "a component of a quaternion";

#[test]
fn every_message_has_a_case() {
    let cases = [rendered(), texts_in(&source("model/tests"))].concat();
    let mut missing = Vec::new();
    for folder in ["model", "syntax", "diag.rs"] {
        let texts = texts_in(&source(folder));
        let messages = texts.iter().filter(|text| text.split_whitespace().count() >= WORDS);
        let is_shown = |text: &str| cases.iter().any(|case| shows(case, text));
        missing.extend(messages.filter(|text| *text != NEVER_SHOWN && !is_shown(text)).cloned());
    }
    assert!(missing.is_empty(), "no test shows {missing:#?}");
}

#[test]
fn long_messages_are_written_once() {
    let rendered = rendered();
    let texts = texts_in(&source("model/tests"));
    let long = texts.iter().filter(|text| text.split_whitespace().count() >= LONG);
    let twice: Vec<_> = long.filter(|text| rendered.contains(text)).collect();
    assert!(twice.is_empty(), "tests/ui has these already, write `…` for their ends: {twice:#?}");
}

/// Returns whether a message could be printed from this format string.
fn shows(message: &str, text: &str) -> bool {
    let mut rest = Some(message);
    for part in text.split('{') {
        // In a format `{{` and `}}` are braces.
        for part in part.split_once('}').map_or(part, |(_, part)| part).split("}}") {
            rest = rest.and_then(|rest| rest.split_once(part).map(|(_, rest)| rest));
        }
    }
    rest.is_some()
}

/// Returns the messages that `tests/ui` shows.
fn rendered() -> Vec<String> {
    let outputs = files(&root().join("../../tests/ui"), "stderr");
    let of_output = |output: &PathBuf| {
        let text = fs::read_to_string(output).expect("an output");
        let blocks = text.split("\n\n").filter_map(|block| {
            let (_, block) = block.split_once(": ")?;
            let lines = block.lines().map(str::trim).take_while(|line| !line.starts_with("-->"));
            Some(lines.collect::<Vec<_>>().join(" "))
        });
        blocks.collect::<Vec<_>>()
    };
    outputs.iter().flat_map(of_output).collect()
}

/// Returns all string literals of the sources in a folder or of one file, except docs and texts that no user sees.
fn texts_in(path: &Path) -> Vec<String> {
    let is_test =
        |file: &PathBuf| !path.ends_with("tests") && file.to_string_lossy().contains("/tests");
    let mut texts = Vec::new();
    for file in files(path, "rs").into_iter().filter(|file| !is_test(file)) {
        let source = fs::read_to_string(&file).expect("a source");
        let source = source.split("#[cfg(test)]").next().unwrap_or(&source);
        add_texts(source.parse().expect("tokens"), &mut texts);
    }
    assert!(!texts.is_empty(), "no texts in {}", path.display());
    texts
}

fn add_texts(tokens: TokenStream, texts: &mut Vec<String>) {
    let mut is_seen = true;
    for token in tokens {
        match token {
            TokenTree::Group(group) if is_seen => add_texts(group.stream(), texts),
            TokenTree::Literal(literal) => {
                let text = syn::parse_str::<syn::LitStr>(&literal.to_string());
                texts.extend(text.map(|text| text.value().replace('\n', " ")));
            }
            TokenTree::Punct(mark) if matches!(mark.as_char(), '#' | '!') => {
                is_seen &= mark.as_char() == '!';
                continue;
            }
            TokenTree::Ident(name) => {
                is_seen = NOT_MESSAGES.iter().all(|not| name != not);
                continue;
            }
            _ => {}
        }
        is_seen = true;
    }
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn source(path: &str) -> PathBuf {
    root().join("src").join(path)
}

/// Returns the files with an extension in a folder and its subfolders, or the file itself.
fn files(path: &Path, ending: &str) -> Vec<PathBuf> {
    if path.is_dir() {
        let entries = fs::read_dir(path).expect("a folder");
        entries.flat_map(|entry| files(&entry.expect("an entry").path(), ending)).collect()
    } else {
        let fits = path.extension().is_some_and(|extension| extension == ending);
        fits.then(|| path.to_owned()).into_iter().collect()
    }
}
