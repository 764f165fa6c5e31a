//! The grammar is written once: the documentation of the parser and the reference of the language have the same text, and
//! its keywords are those that the compiler knows.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

/// The grammar in the documentation of the parser.
const GRAMMAR: &str = include_str!("../../syntax/grammar.md");

/// Keywords that the compiler compares with directly, outside its tables and outside the parser.
const DIRECT: &[&str] = &["PI", "input", "last"];

#[test]
fn the_reference_has_the_grammar_of_the_parser() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../src/language.md");
    let reference = fs::read_to_string(path).expect("the reference of the language");
    assert!(
        reference.contains(GRAMMAR),
        "copy the block of `syntax/grammar.md` into `src/language.md`, or the other way round"
    );
}

#[test]
fn the_grammar_has_all_keywords_and_no_others() {
    let mut known: BTreeSet<String> = crate::syntax::keywords()
        .into_iter()
        .chain(crate::model::lower::keywords())
        .chain(DIRECT.iter().copied())
        .map(str::to_owned)
        .collect();
    known.extend(words_of_the_parser());
    let in_grammar: BTreeSet<String> = GRAMMAR
        .split('\'')
        .skip(1)
        .step_by(2)
        .filter(|text| is_word(text))
        .map(str::to_owned)
        .collect();
    let missing: Vec<_> = known.difference(&in_grammar).collect();
    let unknown: Vec<_> = in_grammar.difference(&known).collect();
    assert!(missing.is_empty() && unknown.is_empty(), "missing {missing:?}, unknown {unknown:?}");
}

/// Every production is used, and every name of a production has one.
#[test]
fn the_grammar_is_complete() {
    let plain: String = GRAMMAR.split('\'').step_by(2).collect();
    let productions: Vec<&str> =
        plain.lines().filter_map(|line| Some(line.split_once(":=")?.0.trim())).collect();
    let words: Vec<&str> = plain.split(|letter| !(is_word_letter(letter))).collect();
    for production in &productions[1..] {
        let uses = words.iter().filter(|word| *word == production).count();
        assert!(uses > 1, "`{production}` is not used");
    }
    for word in words.iter().filter(|word| word.contains('_') && **word != "rust_path") {
        assert!(productions.contains(word), "`{word}` has no production");
    }
}

fn is_word_letter(letter: char) -> bool {
    letter.is_ascii_alphabetic() || letter == '_'
}

fn is_word(text: &str) -> bool {
    text.chars().all(is_word_letter)
}

/// The keywords that the parser asks for by `word("…")`.
fn words_of_the_parser() -> Vec<String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/syntax");
    let files = fs::read_dir(folder).expect("the sources of the parser");
    let sources =
        files.map(|file| fs::read_to_string(file.expect("a file").path()).expect("a text"));
    let words = sources.flat_map(|source| {
        let calls =
            source.split(".word(\"").skip(1).map(|rest| rest.split('"').next().map(str::to_owned));
        calls.flatten().collect::<Vec<_>>()
    });
    // A Rust keyword that the parser skips.
    words.filter(|word| word != "let").collect()
}
