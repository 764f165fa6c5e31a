//! The README: its figures, its program and its picture; and the files that the guide for contributors names.
//!
//! The picture is drawn from the results of the README's program. `MSTMM_BLESS=1 cargo test --test readme` writes it.

#[path = "readme/figures.rs"]
mod figures;
#[path = "readme/picture.rs"]
mod picture;

use std::path::{Path, PathBuf};

/// A file of the repository.
fn path(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(name)
}

fn read(name: &str) -> String {
    std::fs::read_to_string(path(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// The guide for contributors leads to files that exist.
#[test]
fn the_guide_for_contributors_names_files_that_exist() {
    let guide = read("CONTRIBUTING.md");
    let code = guide.split('`').skip(1).step_by(2);
    let paths = code.filter(|code| code.contains('/') && !code.contains([' ', '…', '\n']));
    let paths = paths.map(|name| match name.strip_prefix("codegen/") {
        Some(inside) => format!("mstmm-macros/codegen/{inside}"),
        None => name.to_owned(),
    });
    let paths: Vec<String> = paths.map(|name| name.replace("KIND", "pin")).collect();
    assert!(paths.len() > 20);
    let missing: Vec<_> = paths.iter().filter(|name| !path(name).exists()).collect();
    assert!(missing.is_empty(), "{missing:?}");
}

/// Everyday examples need only this library without the lines about their page, as `examples/README.md` says.
#[test]
fn lines_about_the_page_of_an_example_can_be_deleted() {
    let folder = std::fs::read_dir(path("examples")).expect("a folder");
    let names =
        folder.map(|entry| entry.expect("an entry").file_name().into_string().expect("text"));
    let examples = names.filter(|name| name.ends_with(".rs") && name != "page.rs");
    let examples: Vec<_> = examples.map(|name| read(&format!("examples/{name}"))).collect();
    let with_page = examples.iter().filter(|example| example.contains("mod page;"));
    assert_eq!(with_page.clone().count(), 9);
    for line in with_page.flat_map(|example| example.lines()) {
        let code = line.trim_start();
        let about_page = code.contains("page") || code.contains("Page");
        let starts = ["mod page;", "use page::Page;", "let mut page = ", "page."];
        let is_statement =
            starts.iter().any(|start| code.starts_with(start)) && code.ends_with(';');
        assert!(!about_page || code.starts_with("//") || is_statement, "{line}");
    }
    // No other file that they use needs another crate.
    let needs_look = examples.iter().filter(|example| example.contains("mstmm_look")).count();
    assert_eq!(needs_look, 0);
}
