//! A description with an error is read as it was meant, so that the error is the only one.

use super::each_error_once::expect_rods;
use super::expect_all;

#[test]
fn fields_in_other_brackets_are_read() {
    for (open, close) in [("[", "]"), ("(", ")")] {
        let message = format!("expected `{{`, found `{open}`");
        expect_rods(
            &format!(
                "ground -> pin j -> Rod rod; hinge j {open} start = 1 kg; {close} load l {{ on = rod; }}"
            ),
            &[
                (open, &message),
                ("kg", "expected an angle, found a mass"),
                ("l", "load `l` needs a `force` or a `torque`"),
            ],
        );
    }
}

#[test]
fn a_word_too_many_hides_no_names() {
    let rest = "rod.output -> pin j -> Rod end; load l { on = rod; force = input; } \
                body rod { start_velocity = [0, 0, 1]; }";
    expect_rods(&format!("Rod rod rod; {rest}"), &[("rod", "expected `->` or `;`, found `rod`")]);
    let keyword = "`ground` is a keyword …";
    let rest = "hinge j { damping = 1; } load l { on = rod; force = input; }";
    expect_rods(&format!("moving ground -> pin j -> Rod rod; {rest}"), &[("ground", keyword)]);
}

#[test]
fn text_without_a_chain_is_one_error() {
    let found = |word: &str| format!("expected `chain`, found `{word}`");
    expect_all("fn main() { 1; } struct A { b: C } use d;", &[("fn", &found("fn"))]);
    expect_all("body A { mass = 1; } ground -> pin a -> A b;", &[("body", &found("body"))]);
    // A chain may follow.
    let chain = "chain A { gravity = 1 kg; body Rod { mass = 1; com = [0, 0, 0]; inertia = diag(1, 1, 1) about com; } ground -> pin a -> Rod b; }";
    let vector = ("1 kg", "expected a vector …, found a number");
    expect_all(&format!("fn main() {{}} {chain}"), &[("fn", &found("fn")), vector]);
}

#[test]
fn a_name_twice_in_a_block_is_one_error() {
    expect_rods(
        "ground -> pin j -> Rod rod; hinge j, j { damping = 1; stiffness = 1; start = 1; }",
        &[("j", "`j` is in this block twice: remove one")],
    );
}

#[test]
fn a_part_without_its_parameters_is_one_error() {
    let message = "part `Leg` has no parameters: …";
    expect_rods(
        "part Leg { body Foot { mass = weight; com = [side, 0, 0]; inertia = diag(1, 1, 1) about com; } pin k -> Foot foot; } \
         ground -> pin j -> Rod rod; rod.output -> Leg(-1, 2) lf; rod.output -> Leg(1, 2) rf;",
        &[("(-1, 2)", message)],
    );
}

/// A chain whose vectors have two components is read as one in a plane.
#[test]
fn a_forgotten_plane_is_one_error() {
    let chain = |gravity: &str, start: &str| {
        format!(
            "chain A {{ gravity = {gravity}; \
             body Rod {{ mass = 1; com = [1, 0]; inertia = 1 about com; output = [1, 0]; point tip = [1, 1]; }} \
             ground at [0, 1] -> pin a -> Rod one -> pin b -> Rod two; hinge a {{ start = {start}; }} \
             load push {{ on = two; force = [1, 2]; }} spring s {{ on = two; to = [1, 1]; stiffness = 1; }} }}"
        )
    };
    let plane = ("A", "all vectors of this chain have 2 components: write `plane chain A`");
    expect_all(&chain("[0, -9.8]", "1"), &[plane]);
    expect_all(&chain("[0, -9.8]", "1 m"), &[plane, ("m", "expected an angle, found a length")]);
}
