//! Tests that the compiler answers every text with code that parses or with errors: valid chains with several changes, random
//! words in the order of the grammar, and texts that once failed. `PROPTEST_CASES` sets the number of cases.
//!
//! A failing text is minimised and printed. If the process aborts, the failing text is the last one in `any_text.*.txt` in
//! `target/tmp`.

#[path = "any_text/base.rs"]
mod base;
#[path = "any_text/grammar.rs"]
mod grammar;
#[path = "any_text/mutation.rs"]
mod mutation;
#[path = "common/property.rs"]
mod property;
#[path = "any_text/words.rs"]
mod words;

use proptest::prelude::*;
use proptest::test_runner::FileFailurePersistence;
use std::fmt;
use std::path::Path;
use std::time::{Duration, Instant};

/// The number of cases of a test, which take a few seconds in an unoptimised build.
const CASES: u32 = 200;

/// The time limit of a text, far above the time of any text of this length, even in an unoptimised build on a busy machine.
const LONGEST: Duration = Duration::from_secs(100);

/// A text whose `Debug` form is the text itself.
#[derive(Clone)]
struct Text(String);

impl fmt::Debug for Text {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "\n{}\n", self.0)
    }
}

fn config() -> ProptestConfig {
    let cases = std::env::var("PROPTEST_CASES").ok().and_then(|text| text.parse().ok());
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/any_text/proptest-regressions.txt");
    ProptestConfig {
        cases: cases.unwrap_or(CASES),
        failure_persistence: Some(Box::new(FileFailurePersistence::Direct(file))),
        max_shrink_time: 60_000,
        ..ProptestConfig::default()
    }
}

/// Tests on one text what must hold for every text.
fn check(test: &str, text: &str) -> Option<bool> {
    let file = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("any_text.{test}.txt"));
    std::fs::write(file, text).expect("a writable folder");
    let start = Instant::now();
    let right = property::check(text);
    assert!(start.elapsed() < LONGEST, "it took {:?}", start.elapsed());
    right
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn right_chains_changed_in_several_places(text in mutation::changed(base::any()).prop_map(Text)) {
        check("changed", &text.0);
    }

    #[test]
    fn random_words(text in grammar::text().prop_map(Text)) {
        check("words", &text.0);
    }
}

#[test]
fn the_chains_that_are_changed_are_right() {
    for text in base::committed() {
        assert_eq!(check("written", &text), Some(true), "{text}");
    }
}

#[test]
fn former_crashes() {
    for (name, text) in base::files("crashes", ".txt") {
        println!("{name}");
        check("crashes", &text);
    }
}
