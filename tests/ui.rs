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
fn errors_are_reported_at_their_tokens() {
    let cases = trybuild::TestCases::new();
    cases.compile_fail("tests/ui/*.rs");
    cases.compile_fail("tests/ui/*/*.rs");
}

/// Tests that cases are only macro calls: a message about other code would not help the user. Four folders have programs
/// instead. Those in `quiet` use wrong chains, about which rustc must report nothing more (see `emit/error_types.rs`); those in
/// `reading` read what a chain does not have, or have a state in the place of a chain; those in `writing` write what only
/// setters change; those in `warnings` deny warnings, which the tests would not show otherwise.
#[test]
fn cases_are_only_macro_calls() {
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
