//! Tests that every kind of hinge is in every registry that the Rust compiler cannot check.

use std::fs;
use std::path::{Path, PathBuf};

/// The kinds that are the planar form of another kind and share its keyword, page and sample.
const IN_A_PLANE: &[(&str, &str)] = &[("plane_elastic", "elastic")];

/// The kinds of the reference solver that the compiler describes as another kind.
const REFERENCE_ALONE: &[&str] = &["line_elastic", "line_floating", "plane_floating"];

/// The kinds without coordinates, which have no view.
const WITHOUT_VIEW: &[&str] = &["weld"];

/// The files with lists of all keywords of hinges.
const LISTS_OF_WORDS: [&str; 6] = [
    "mstmm-macros/codegen/src/syntax/lookahead.rs",
    "mstmm-macros/codegen/src/syntax/grammar.md",
    "mstmm-macros/codegen/tests/any_text/words.rs",
    "mstmm-macros/codegen/tests/any_text/grammar.rs",
    "bridges/cargo-mstmm/src/import/names.rs",
    "fuzz/words.dict",
];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn text(file: &str) -> String {
    fs::read_to_string(root().join(file)).unwrap_or_else(|error| panic!("{file}: {error}"))
}

/// Converts `PlaneElastic` to `plane_elastic`.
fn snake(name: &str) -> String {
    let mut snake = String::new();
    for (place, letter) in name.char_indices() {
        if letter.is_uppercase() && place > 0 {
            snake.push('_');
        }
        snake.extend(letter.to_lowercase());
    }
    snake
}

/// Returns the variants of an enum in a file.
fn variants(file: &str, name: &str) -> Vec<String> {
    let parsed = syn::parse_file(&text(file)).expect("a Rust file");
    let found = parsed.items.into_iter().find_map(|item| match item {
        syn::Item::Enum(item) if item.ident == name => Some(item.variants),
        _ => None,
    });
    let variants = found.unwrap_or_else(|| panic!("{file} has no `{name}`"));
    variants.iter().map(|variant| snake(&variant.ident.to_string())).collect()
}

/// Returns the kinds of the model.
fn kinds() -> Vec<String> {
    variants("mstmm-macros/codegen/src/model/hinge/mod.rs", "HingeKind")
}

/// Returns the kinds that have a separate keyword.
fn words() -> Vec<String> {
    let other = |kind: &String| IN_A_PLANE.iter().any(|(plane, _)| plane == kind);
    kinds().into_iter().filter(|kind| !other(kind)).collect()
}

/// Returns the names of a folder's files with an extension.
fn files(folder: &str, ending: &str) -> Vec<String> {
    let entries = fs::read_dir(root().join(folder)).expect("a readable folder");
    let names = entries.map(|entry| entry.expect("an entry").file_name());
    let names = names.map(|name| name.to_string_lossy().into_owned());
    names.filter_map(|name| name.strip_suffix(ending).map(str::to_owned)).collect()
}

fn sorted(mut names: Vec<String>) -> Vec<String> {
    names.sort();
    names
}

#[test]
fn every_kind_has_its_numbers_its_law_and_its_view() {
    let [models, laws] = ["model", "equations"]
        .map(|part| files(&format!("mstmm-macros/codegen/src/{part}/hinge"), ".rs"));
    let views = files("mstmm-runtime/src/hinge", ".rs");
    for kind in kinds() {
        assert!(models.contains(&kind), "model/hinge has no `{kind}`");
        assert!(laws.contains(&kind), "equations/hinge has no `{kind}`");
        assert!(
            views.contains(&kind) || WITHOUT_VIEW.contains(&kind.as_str()),
            "the runtime has no view of `{kind}`"
        );
    }
}

#[test]
fn every_word_is_read_explained_and_tried() {
    let lower = text("mstmm-macros/codegen/src/model/lower/hinge/mod.rs");
    let (_, listed) = lower.split_once("const KINDS").expect("the list of words");
    let listed = listed.split_once("];").map_or(listed, |(list, _)| list);
    let listed = listed.split("::KIND,").filter_map(|part| part.split_whitespace().last());
    let words = words();
    let listed: Vec<String> = listed.map(str::to_owned).filter(|word| word != "];").collect();
    assert_eq!(sorted(listed), sorted(words.clone()), "words of the language");
    let pages = files("src/hinges", ".md").into_iter().filter(|page| page != "hinges").collect();
    assert_eq!(sorted(pages), sorted(words.clone()), "pages on hinges");
    let book = text("src/hinges.rs");
    let lists = LISTS_OF_WORDS.map(|file| (file, text(file)));
    for word in &words {
        assert!(book.contains(&format!("hinges/{word}.md")), "src/hinges.rs leaves out `{word}`");
        for (file, list) in &lists {
            let mut names = list.split(|letter: char| !letter.is_alphanumeric() && letter != '_');
            assert!(names.any(|name| name == word), "{file} leaves out `{word}`");
        }
    }
}

#[test]
fn the_reference_knows_every_kind_and_random_chains_have_it() {
    let reference = variants("tests/reference/src/hinge.rs", "HingeKind");
    let known = reference.iter().filter(|kind| !REFERENCE_ALONE.contains(&kind.as_str()));
    assert_eq!(sorted(known.cloned().collect()), sorted(kinds()), "kinds of the reference");
    let random = variants("tests/reference/src/recipe.rs", "HingeChoice");
    assert_eq!(sorted(random), sorted(words()), "kinds of random chains");
    let seeds = text("tests/random.rs");
    for kind in kinds() {
        let named = format!("(\"{}\",", kind.replace('_', " "));
        assert!(seeds.contains(&named), "no seed is asked for `{kind}`");
    }
}
