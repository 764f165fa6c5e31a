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
