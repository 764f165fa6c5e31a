//! A fuzz target: any text inside `mstmm_chain!`.

#![no_main]

#[path = "../../mstmm-macros/codegen/tests/common/property.rs"]
mod property;

use libfuzzer_sys::{Corpus, fuzz_target};

fuzz_target!(|text: &str| -> Corpus {
    match property::check(text) {
        Some(_) => Corpus::Keep,
        // The text is not a sequence of Rust tokens.
        None => Corpus::Reject,
    }
});
