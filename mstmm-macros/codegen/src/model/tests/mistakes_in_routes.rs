//! Mistakes in the route.

use super::{expect, expect_all};

const ROUTE: &str = "ground -> pin(z) shoulder -> Cube upper -> ball wrist -> Rod rod;";

#[test]
fn hinges_and_bodies_alternate() {
    expect(
        "-> Cube upper -> ball",
        "-> Cube upper -> ball elbow -> ball",
        &[("wrist", "hinges `elbow` and `wrist` have no body between them")],
    );
    expect(
        "-> Rod rod",
        "-> Rod rod -> Rod end",
        &[
            ("end", "bodies `rod` and `end` have no hinge between them"),
            ("Rod", "body `Rod` needs `output`"),
        ],
    );
    expect(
        "ground -> pin(z) shoulder ->",
        "ground -> weld shoulder -> Rod a -> pin b -> ground ->",
        &[
            ("start", "a weld has no field `start`"),
            ("torque", "a weld has no field `torque`"),
            ("ground", "`ground` can only stand at an end of the route"),
            ("Rod", "body `Rod` needs `output`"),
        ],
    );
    expect(
        "ground -> pin(z) shoulder ->",
        "ground -> Rod shoulder -> ball x ->",
        &[
            ("shoulder", "`shoulder` is a body: `body shoulder { … }`"),
            ("shoulder", "`ground` and body `shoulder` have no hinge between them"),
            ("Rod", "body `Rod` needs `output`"),
        ],
    );
}

#[test]
fn ends_are_free_or_held() {
    expect(
        "-> Rod rod;",
        "-> Rod rod -> pin last;",
        &[
            ("last", "hinge `last` joins nothing: end the route with a body or with `ground`"),
            ("Rod", "body `Rod` needs `output`"),
        ],
    );
    expect(
        "ground -> pin",
        "pin",
        &[(
            "shoulder",
            "hinge `shoulder` joins nothing: begin the route with a body or with `ground`",
        )],
    );
    expect(
        "-> Rod rod;",
        "-> Rod rod -> pin last -> moving;",
        &[
            ("moving", "a moving end needs a name: `moving name`"),
            ("Rod", "body `Rod` needs `output`"),
        ],
    );
}

#[test]
fn there_is_one_route_with_a_body() {
    expect_all("chain Empty {}", &[("Empty", "chain `Empty` has no route")]);
    expect_all("chain Empty { ground; }", &[("ground", "there is no body on the route")]);
    expect_all("chain Empty { ground -> pin j; }", &[("ground", "there is no body on the route")]);
    let twice = format!("{ROUTE} {ROUTE}");
    expect(ROUTE, &twice, &[("ground", "a second route; a chain has one")]);
}

#[test]
fn stops_are_known() {
    expect(
        "ball wrist",
        "bal wrist",
        &[("bal", "unknown kind of hinge `bal`; did you mean `ball`?")],
    );
    expect(
        "Cube upper",
        "Cub upper",
        &[("Cub", "unknown type of body `Cub`; did you mean `Cube`?")],
    );
    expect(
        "ball wrist",
        "slidr wrist",
        &[("slidr", "unknown kind of hinge `slidr`; did you mean `slider`?")],
    );
    expect(
        "ground ->",
        "grond ->",
        &[("grond", "unknown kind of hinge `grond`; did you mean `ground`?")],
    );
    expect(
        "body Rod {",
        "body Beam { mass = 1; com = [0, 0, 0]; inertia = diag(1, 1, 1) about com; } body Rod {",
        &[("Beam", "body `Beam` is not on the route")],
    );
}

#[test]
fn stops_are_well_formed() {
    expect("ball wrist", "ball(z) wrist", &[("(z)", "`ball` takes nothing in parentheses")]);
    expect("Cube upper", "Cube(1) upper", &[("(1)", "a body takes nothing in parentheses")]);
    expect(
        "pin(z)",
        "pin(w)",
        &[("w", "expected an axis: `x`, `y`, `z`, `-x`, `-y`, `-z` or `[a, b, c]`")],
    );
    expect("pin(z)", "pin(x, y)", &[("(x, y)", "a pin has one axis, such as `pin(z)`")]);
    expect("pin(z)", "pin([0, 0, 0])", &[("[0, 0, 0]", "an axis of zeros has no direction")]);
    expect(
        "-> Cube upper -> ball wrist ->",
        "-> Cube upper -> ball ->",
        &[("ball", "a hinge needs a name: `ball name`")],
    );
}

#[test]
fn a_route_that_cannot_be_read_is_not_judged() {
    expect(
        "-> ball wrist",
        "-> 7 -> ball wrist",
        &[("7", "expected a hinge, a body or `ground`, found `7`")],
    );
    expect(
        "Cube upper -> ball wrist",
        "Cube upper ball wrist",
        &[("ball", "expected `->` or `;`, found `ball`")],
    );
    expect("Rod rod;", "Rod rod", &[("rod", "expected `;` after this")]);
    expect("Rod rod;", "Rod", &[("Rod", "expected `;` after this")]);
    expect("upper -> ball", "upper; -> ball", &[("-", "expected an item, found `-`")]);
    expect("upper -> ball", "upper; ball", &[("ball", "a second route; a chain has one")]);
    expect("Rod rod;", "Rod rod ->;", &[(";", "expected a hinge, a body or `ground`, found `;`")]);
}
