//! The generated code of small chains, committed to be read: `MSTMM_BLESS=1 cargo test -p
//! mstmm-codegen --test expand` writes it anew, and a diff then shows what a change has moved.

use std::path::{Path, PathBuf};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/expand")
}

/// The expansion of a chain as `rustfmt` would print it.
fn expand(text: &str) -> String {
    let items = mstmm_codegen::compile(text.parse().expect("tokens")).expect("a right chain");
    let file = syn::parse2(items.clone()).unwrap_or_else(|error| panic!("{error}\n{items}"));
    prettyplease::unparse(&file)
}

fn check(name: &str) {
    let text = std::fs::read_to_string(folder().join(format!("{name}.chain"))).expect("a chain");
    let path = folder().join(format!("{name}.expanded.rs"));
    let expanded = expand(&text);
    assert_eq!(expanded, expand(&text), "the expansion differs from one run to the next");
    if std::env::var_os("MSTMM_BLESS").is_some() {
        std::fs::write(&path, &expanded).expect("a writable folder");
    }
    let golden = std::fs::read_to_string(&path).expect("the committed expansion");
    if let Some((line, (now, then))) =
        expanded.lines().zip(golden.lines()).enumerate().find(|(_, (now, then))| now != then)
    {
        panic!("{name}, line {}:\n  was {then}\n  is  {now}\nMSTMM_BLESS=1 accepts it", line + 1);
    }
    assert_eq!(expanded.len(), golden.len(), "{name}: MSTMM_BLESS=1 accepts it");
}

#[test]
fn pendulum_with_a_motor_and_a_parameter() {
    check("pendulum");
}

#[test]
fn a_body_on_a_ball() {
    check("top");
}

#[test]
fn two_pins_by_transfer() {
    check("two_pins");
}

#[test]
fn a_rope_as_loops() {
    check("rope");
}

#[test]
fn a_four_bar_in_the_plane() {
    check("four_bar");
}

/// A repeated part is a loop: the code for ten thousand is that for ten, but for the numbers in it.
#[test]
fn code_does_not_grow_with_the_count_of_a_repeat() {
    let rope = std::fs::read_to_string(folder().join("rope.chain")).expect("a chain");
    let length = |count: &str| {
        let text = rope.replace("repeat 10 ", &format!("repeat {count} "));
        let text = text.replace("[10]", &format!("[{count}]"));
        let items = mstmm_codegen::compile(text.parse().expect("tokens")).expect("a right chain");
        items.to_string().chars().filter(|letter| !letter.is_ascii_digit()).count()
    };
    assert_eq!(length("10"), length("10000"));
}
