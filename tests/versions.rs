//! Texts of earlier versions of the language: they compile, and their chains have the same names, units and
//! accelerations as when they were written. `LANGUAGE.md` says what each version added.
//!
//! A released version's folder does not change. `MSTMM_BLESS=1 cargo test --test versions` writes the facts of new
//! texts of the version that is not released.

use mstmm::description::Quantities;
use mstmm::{Described, GeneratedChain, mstmm_chain};
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

/// The largest relative change of an acceleration. Its rounding may change with the compiler of chains: to some
/// thousand operations of 1.1e-16 in models whose masses differ by less than a factor of a thousand.
const TOLERANCE: f64 = 1e-9;

/// Returns the facts of chains in scope.
macro_rules! facts_of {
    ($($chain:ident)*) => {{
        let mut text = String::new();
        $(
            let chain = $chain::<f64>::new();
            let (mut state, inputs) = (chain.initial_state(), chain.no_inputs());
            // So that no acceleration is zero only because everything rests.
            for (index, rate) in state.v.as_mut_slice().iter_mut().enumerate() {
                *rate += 0.1 * (index + 1) as f64;
            }
            let accelerations = chain.accelerations(&state, &inputs).expect("regular");
            text += &facts::<$chain<f64>>(accelerations.as_slice());
        )*
        text
    }};
}

mod version_0_1_0 {
    use super::{facts, mstmm_chain};
    include!("versions/0.1.0/arm.chain");
    include!("versions/0.1.0/closed.chain");
    include!("versions/0.1.0/tree.chain");
    include!("versions/0.1.0/repeated.chain");
    include!("versions/0.1.0/gimbal.chain");

    /// Some of the chains are private to this module.
    pub fn all_facts() -> String {
        facts_of!(Arm FourBar Animal Shaker Ladder Train Camera)
    }
}

fn path(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(name)
}

/// Writes the names and units of quantities.
fn quantities(kind: &str, all: Quantities, text: &mut String) {
    for quantity in all.iter() {
        writeln!(text, "{kind} {} [{}]", quantity.name, quantity.unit).expect("a text");
    }
}

/// Returns the facts of a chain: its answers, the names of its quantities, elements and points, and its
/// accelerations near the start.
fn facts<C: Described + GeneratedChain<Scalar = f64>>(accelerations: &[f64]) -> String {
    let all = C::DESCRIPTION;
    let mut text = format!("\nchain {}\n", all.name());
    for answer in all.answers() {
        writeln!(text, "answer {answer}").expect("a text");
    }
    quantities("coordinate", all.coordinates(), &mut text);
    quantities("rate", all.rates(), &mut text);
    quantities("input", all.inputs(), &mut text);
    quantities("parameter", all.parameters(), &mut text);
    let hinges = all.hinges().iter().map(|hinge| format!("hinge {}", hinge.name()));
    let bodies = all.bodies().iter().map(|body| format!("body {}", body.name()));
    let springs = all.springs().iter().map(|spring| format!("spring {}", spring.name()));
    let points = all.points().iter().map(|point| format!("point {}", point.name()));
    for line in hinges.chain(bodies).chain(springs).chain(points) {
        writeln!(text, "{line}").expect("a text");
    }
    for value in accelerations {
        writeln!(text, "acceleration {value:.12e}").expect("a text");
    }
    text
}

/// Returns the difference of two lines, if it is more than rounding relative to `scale`.
fn difference(found: &str, expected: &str, scale: f64) -> Option<String> {
    let number = |line: &str| line.strip_prefix("acceleration ")?.parse::<f64>().ok();
    let is_close = match (number(found), number(expected)) {
        (Some(a), Some(b)) => (a - b).abs() <= TOLERANCE * scale,
        _ => found == expected,
    };
    (!is_close).then(|| format!("`{expected}` has become `{found}`"))
}

fn check(version: &str, found: &str) {
    let file = path(&format!("tests/versions/{version}/facts.txt"));
    if std::env::var_os("MSTMM_BLESS").is_some() {
        fs::write(&file, found).expect("a writable file");
    }
    let expected = fs::read_to_string(file).expect("the facts");
    assert_eq!(found.lines().count(), expected.lines().count(), "{found}");
    let numbers =
        expected.lines().filter_map(|line| line.strip_prefix("acceleration ")?.parse().ok());
    let scale = numbers.map(f64::abs).fold(1.0, f64::max);
    let lines = found.lines().zip(expected.lines());
    let changed: Vec<_> = lines.filter_map(|(a, b)| difference(a, b, scale)).collect();
    assert!(changed.is_empty(), "version {version}: {changed:#?}");
}

#[test]
fn texts_of_0_1_0_mean_the_same() {
    check("0.1.0", &version_0_1_0::all_facts());
}

#[test]
fn every_version_of_the_language_has_texts_that_this_test_reads() {
    let this = fs::read_to_string(path("tests/versions.rs")).expect("this file");
    let changes = fs::read_to_string(path("LANGUAGE.md")).expect("the changes of the language");
    let heads = changes.lines().filter_map(|line| line.strip_prefix("## "));
    let mut versions: Vec<&str> = heads.filter_map(|head| head.split(' ').next()).collect();
    versions.sort_unstable();
    let entries = fs::read_dir(path("tests/versions")).expect("a folder");
    let folders = entries.map(|entry| entry.expect("an entry").file_name());
    let mut folders: Vec<String> =
        folders.map(|name| name.to_string_lossy().into_owned()).collect();
    folders.sort_unstable();
    assert_eq!(versions, folders);
    for folder in folders {
        for entry in fs::read_dir(path("tests/versions").join(&folder)).expect("a folder") {
            let name = entry.expect("an entry").file_name();
            let name = format!("versions/{folder}/{}", name.to_string_lossy());
            assert!(!name.ends_with(".chain") || this.contains(&name), "{name} is not read");
        }
    }
}
