//! Golden texts of functions in the order of their equations. A change of one equation changes only the sections that
//! contain it or that own values shared with it. `MSTMM_BLESS=1 cargo test -p mstmm-codegen --test text` updates them.

use mstmm_codegen::compile::chain_text;
use std::path::{Path, PathBuf};

/// The largest number of lines that a reader can review.
const LONGEST: usize = 330;

fn file(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests").join(name)
}

/// Returns the text of one function or of all functions of the chain in a file of `tests/expand`.
fn show(name: &str, function: Option<&str>) -> Result<String, Vec<&'static str>> {
    let text = std::fs::read_to_string(file(&format!("expand/{name}.chain"))).expect("the chain");
    show_text(&text, function)
}

/// Returns the text of one function or of all functions of a chain.
fn show_text(text: &str, function: Option<&str>) -> Result<String, Vec<&'static str>> {
    let read = mstmm_codegen::read_and_examine(text.parse().expect("tokens"));
    let (chain, findings) = &read.unwrap_or_else(|errors| panic!("{errors}"))[0];
    chain_text(chain, findings, function)
}

/// Compares the text of functions of a chain in `tests/expand` with its golden.
fn check(name: &str, functions: &[&str]) {
    let texts = functions.iter().map(|function| show(name, Some(function)));
    let texts: Vec<String> = texts.collect::<Result<_, _>>().expect("the chain has the functions");
    let text = texts.join("\n");
    let path = file(&format!("text/{name}.txt"));
    if std::env::var_os("MSTMM_BLESS").is_some() {
        std::fs::write(&path, &text).expect("a writable folder");
    }
    let golden = std::fs::read_to_string(&path).expect("the committed text");
    let changed = text.lines().zip(golden.lines()).position(|(now, then)| now != then);
    assert!(text == golden, "{name}, line {changed:?} from 0: MSTMM_BLESS=1 accepts it");
    assert!(text.lines().count() <= LONGEST, "{name} is too long to be read through");
}

/// Every function of chains with shapes has the same text as without.
#[test]
fn shapes_change_no_function() {
    for name in ["arm", "rope"] {
        let text =
            std::fs::read_to_string(file(&format!("expand/{name}.chain"))).expect("the chain");
        let shapes = "shape = [sphere(radius = 1) at [1, 2, 3], box([1, 2, 3])]; mass =";
        let shaped = text.replace("mass =", shapes);
        assert_ne!(text, shaped);
        assert_eq!(show_text(&text, None), show_text(&shaped, None), "{name}");
    }
}

#[test]
fn pendulum_with_a_motor_and_a_parameter() {
    check("pendulum", &["setup", "accelerations", "solution", "energy"]);
}

#[test]
fn a_body_on_a_ball() {
    check("top", &["accelerations", "solution", "coordinate_rates", "normalized"]);
}

#[test]
fn two_pins_by_transfer() {
    check("two_pins", &["accelerations", "solution"]);
}

#[test]
fn an_arm_of_three_pins() {
    check("arm", &["accelerations"]);
}

#[test]
fn a_rope_as_loops() {
    check("rope", &["setup", "accelerations"]);
}

#[test]
fn a_four_bar_in_the_plane() {
    check("four_bar", &["accelerations"]);
}

#[test]
fn answers_of_a_cart_with_a_pole() {
    check(
        "cart_pole",
        &[
            "inverse_dynamics",
            "mass_matrix",
            "coriolis_matrix",
            "regressor",
            "linearization",
            "pull",
        ],
    );
}

#[test]
fn all_functions_are_shown_one_after_the_other() {
    let all = show("four_bar", None).expect("a chain has functions");
    let names: Vec<&str> =
        all.lines().filter_map(|line| line.strip_prefix("fn ")?.strip_suffix("() {")).collect();
    let expected = ["setup", "accelerations", "solution", "energy", "coordinate_rates"];
    assert_eq!(names[..5], expected);
    assert_eq!(names[5..], ["normalized", "correction", "start"]);
}

#[test]
fn unknown_functions_are_errors_with_the_known_names() {
    let known = show("top", Some("forces")).expect_err("no such function");
    assert_eq!(known[..2], ["setup", "accelerations"]);
}
