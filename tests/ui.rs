//! Error messages of descriptions: the folder `ui` has the message and the place of each error, and nothing
//! else is reported. `mstmm-macros/codegen/tests/messages.rs` checks that every message occurs here or in
//! the tests of the compiler's model.
//!
//! Cases contain only macro calls, so that every message is the macro's, in folders by topic.
//! `TRYBUILD=overwrite cargo test --test ui` rewrites the messages; their layout depends on the version of
//! rustc.

use std::fs;
use std::path::{Path, PathBuf};

#[test]
fn mistakes_are_reported_where_they_are() {
    let cases = trybuild::TestCases::new();
    cases.compile_fail("tests/ui/*.rs");
    cases.compile_fail("tests/ui/*/*.rs");
}

/// A message about anything but the description would not be the user's to mend. In the folder `quiet`
/// programs use the chains that are wrong, of which nothing may be said (see `emit/wrong.rs`); in `reading` they read what right
/// ones do not have, in `writing` they write what only setters change, and in `warnings` they deny
/// warnings, which would not be seen otherwise.
#[test]
fn cases_are_macro_calls_alone() {
    let folders = ["quiet", "reading", "writing", "warnings"];
    let programs = folders.map(|folder| root().join("tests/ui").join(folder));
    let is_call = |case: &PathBuf| !programs.iter().any(|folder| case.starts_with(folder));
    for case in cases().into_iter().filter(is_call) {
        let source = fs::read_to_string(&case).expect("a case");
        assert!(source.starts_with("mstmm::mstmm_chain! {"), "{}", case.display());
        assert!(source.ends_with("}\n\nfn main() {}\n"), "{}", case.display());
    }
}

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

/// All cases in the folders of topics.
fn cases() -> Vec<PathBuf> {
    let folders = entries(&root().join("tests/ui"));
    let files = folders.iter().filter(|path| path.is_dir()).flat_map(|folder| entries(folder));
    files.filter(|path| path.extension().is_some_and(|extension| extension == "rs")).collect()
}

fn entries(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("a folder");
    entries.map(|entry| entry.expect("an entry").path()).collect()
}
