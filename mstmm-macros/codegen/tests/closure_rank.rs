//! Tests that the rank of a loop closure that is found at compile time does not depend on the start of the chain, down to
//! deviations of the last bits.

mod common;

use common::read;
use mstmm_codegen::compile::compile;
use mstmm_codegen::diag::Diagnostics;
use mstmm_codegen::examine::{Mobility, examine};
use mstmm_codegen::model::{ClosureRank, Layout};
use mstmm_reference::Random;

/// The number of starts for each size of deviation.
const STARTS: usize = 10;

/// Returns a body of one kilogram between pins about z.
fn bar(name: &str, output: &str) -> String {
    format!(
        "body {name} {{ mass = 1; com = [0.2, 0.05, 0.1]; inertia = diag(0.05, 0.06, 0.07) about com; \
         output = {output}; }}\n"
    )
}

/// Returns Bennett's linkage: the lengths are proportional to the sines of the twists, 4/5 and 3/5.
fn bennett(start: &[f64]) -> String {
    let bars = bar("First", "[1, 0, 0] turned quaternion(2, 1, 0, 0)")
        + &bar("Second", "[0.75, 0, 0] turned quaternion(3, 1, 0, 0)")
        + &bar("Third", "[1, 0, 0] turned quaternion(2, 1, 0, 0)");
    linkage(
        &bars,
        &["First", "Second", "Third"],
        "[-0.75, 0, 0] turned quaternion(3, -1, 0, 0)",
        start,
    )
}

/// Returns Goldberg's linkage: two of Bennett's with sines 4/5, 3/5 and 5/13 that share a link.
fn goldberg(start: &[f64]) -> String {
    let bars = bar("First", "[0.45703125, 0, 0] turned quaternion(2, 1, 0, 0)")
        + &bar("Second", "[0.3427734375, 0, 0] turned quaternion(3, 1, 0, 0)")
        + &bar("Third", "[0.2197265625, 0, 0] turned quaternion(5, 1, 0, 0)")
        + &bar("Fourth", "[0.45703125, 0, 0] turned quaternion(2, 1, 0, 0)");
    let bodies = ["First", "Second", "Third", "Fourth"];
    linkage(&bars, &bodies, "[-0.5625, 0, 0] turned quaternion(7, -4, 0, 0)", start)
}

fn linkage(bars: &str, bodies: &[&str], end: &str, start: &[f64]) -> String {
    let mut text = format!("chain Linkage {{ {bars} ground");
    for (number, body) in bodies.iter().enumerate() {
        text += &format!(" -> pin p{number} -> {body}");
    }
    text += &format!(" -> pin last -> ground at {end};\n");
    for (number, angle) in start.iter().enumerate() {
        text += &format!("hinge p{number} {{ start = {angle:e} rad; }}\n");
    }
    text + "}"
}

fn check(text: impl Fn(&[f64]) -> String, start: &[f64], rank: usize) {
    let mut random = Random::new(1);
    for exponent in [-16, -12, -9, -6, -3, -2] {
        let size = 10_f64.powi(exponent);
        for _ in 0..STARTS {
            let near: Vec<f64> =
                start.iter().map(|angle| angle + size * random.between(-1.0, 1.0)).collect();
            let chain = read(&text(&near));
            let mut diagnostics = Diagnostics::default();
            let findings = examine(&chain, &mut diagnostics);
            assert!(diagnostics.finish().is_ok(), "refused at {near:?}");
            let expected = Mobility { dofs: 1, constraints: 5, redundant: 5 - rank };
            assert_eq!(findings.mobility, Some(expected), "{near:?}");
            let known = ClosureRank::Known { rank, directions: 5 };
            assert_eq!(findings.closure_rank, known, "{near:?}");
        }
    }
}

/// A final weld closes a chain next to a repeated part. Where the part is written out, the weld is merged, and the hinge
/// before it closes the chain with another number of constraints.
#[test]
fn a_weld_after_a_repeated_part_has_its_own_rank() {
    let text = "chain Hung {
        param length = 0.5 m;
        body Rod { mass = 1; com = [0.2, 0, 0]; inertia = diag(0.1, 0.2, 0.3) about com; output = [length, 0, 0]; }
        ground -> repeat 2 { floating joint -> Rod rod } -> weld last -> ground;
    }";
    let chain = read(text);
    let findings = examine(&chain, &mut Diagnostics::default());
    assert_eq!(findings.closure_rank, ClosureRank::Unknown);
    compile(&chain, &findings, &Layout::of(&chain));
}

#[test]
fn the_rank_of_bennetts_linkage_does_not_depend_on_its_start() {
    // tan(a/2) tan(b/2) = sin((α + β)/2) / sin((β − α)/2), with tan(α/2) = 1/2 and tan(β/2) = 1/3.
    let ratio: f64 = (1.0 / 3.0 + 0.5) / (1.0 / 3.0 - 0.5);
    let a: f64 = 2.0;
    let b = 2.0 * (ratio / (a / 2.0).tan()).atan();
    check(bennett, &[a, b, -a], 2);
}

#[test]
fn the_rank_of_goldbergs_linkage_does_not_depend_on_its_start() {
    let start = [2.0, -2.5376791448982257, -1.7345849733029404, -0.6039135086915678];
    check(goldberg, &start, 3);
}
