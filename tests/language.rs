//! Every feature of the language compiles and has its documented meaning, tested by public items.

// Expansions must be quiet under whatever a crate forbids. The examples in the documentation of
// `mstmm_chain!` are held to `missing_docs`, which is silent in tests.
#![deny(warnings, missing_docs, clippy::all)]

mod language {
    mod constants;
    mod frames;
    mod hidden;
    mod items;
    mod motion;
    mod names;
    mod numbers;
    mod parameters;
    mod robot;
}

/// Asserts that numbers agree up to the rounding of a few dozen operations on numbers near one.
#[track_caller]
fn assert_close(found: impl AsRef<[f64]>, expected: impl AsRef<[f64]>) {
    let (found, expected) = (found.as_ref(), expected.as_ref());
    assert_eq!(found.len(), expected.len());
    for (a, b) in found.iter().zip(expected) {
        assert!((a - b).abs() < 1e-13, "{found:?} is not {expected:?}");
    }
}
