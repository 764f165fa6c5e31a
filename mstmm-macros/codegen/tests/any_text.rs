//! Whatever is written, the compiler answers with code that parses or with mistakes: right chains
//! changed in several places, random words in the order of the language, and texts that once broke
//! it. `PROPTEST_CASES` asks for more of them.
//!
//! A text that breaks it is printed, the smallest of its kind that was found. Where the process dies
//! of it, it is the last one written to `any_text.*.txt` in `target/tmp`.

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

/// Cases of a test, a few seconds of an unoptimised build.
const CASES: u32 = 200;

/// No text of this length takes longer, by far, even in an unoptimised build on a busy machine.
const LONGEST: Duration = Duration::from_secs(100);

/// Shown as it is written.
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

/// Asks of a text what holds of any.
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
    for text in base::written() {
        assert_eq!(check("written", &text), Some(true), "{text}");
    }
}

#[test]
fn what_once_broke_it() {
    for (name, text) in base::files("crashes", ".txt") {
        println!("{name}");
        check("crashes", &text);
    }
}
