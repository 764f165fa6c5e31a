//! Errors in the route.

use super::each_error_once::{ITEMS, expect_rods};
use super::{expect, expect_all};

const BODY_BETWEEN: &str = "; add a body there, with a small mass";

/// Hinges in a row.
#[track_caller]
fn expect_row(hinges: &str, at: &str, message: &str) {
    expect_rods(&format!("ground -> {hinges} -> Rod rod;"), &[(at, message)]);
}

#[test]
fn hinges_in_a_row_may_be_one() {
    let two = |advice: &str| format!("hinges `a` and `b` have no body between them{advice}");
    let one = |kind: &str| two(&format!("; write one hinge `{kind}` instead"));
    expect_row("pin(x) a -> pin([0, 1, 1]) b", "b", &one("universal"));
    expect_row("slider(x) a -> pin(-x) b", "b", &one("cylindrical"));
    expect_row("pin([0, 2, 0]) a -> slider(y) b", "b", &one("cylindrical"));
    expect_row("pin(x) a -> pin(x) b", "b", &two(BODY_BETWEEN));
    expect_row("pin(x) a -> slider(y) b", "b", &two(BODY_BETWEEN));
    expect_row("ball a -> pin(y) b", "b", &two(BODY_BETWEEN));
    let weld =
        |name: &str| two(&format!("; remove weld `{name}`: it has no effect next to a hinge"));
    expect_row("weld a -> pin(y) b", "b", &weld("a"));
    expect_row("ball a -> weld b", "b", &weld("b"));
    let three = "hinges `a`, `b` and `c` have no body between them";
    let one = |kind: &str| format!("{three}; write one hinge `{kind}` instead");
    expect_row("pin(x) a -> pin(y) b -> pin(z) c", "b", &one("gimbal"));
    expect_row("pin(x) a -> pin([1, 1, 0]) b -> pin(z) c", "b", &one("ball"));
    expect_row("pin(x) a -> pin(y) b -> pin(x) c", "b", &format!("{three}{BODY_BETWEEN}"));
}

#[test]
fn hinges_and_bodies_alternate() {
    expect(
        "-> Cube upper -> ball",
        "-> Cube upper -> ball elbow -> ball",
        &[(
            "wrist",
            &format!("hinges `elbow` and `wrist` have no body between them{BODY_BETWEEN}"),
        )],
    );
    expect(
        "-> Rod rod",
        "-> Rod rod -> Rod end",
        &[
            ("Rod", "body `Rod` needs `output`"),
            (
                "end",
                "bodies `rod` and `end` have no hinge between them: add one, such as `weld \
                     name`",
            ),
        ],
    );
    expect(
        "ground -> pin(z) shoulder ->",
        "ground -> weld shoulder -> Rod a -> pin b -> ground ->",
        &[
            ("Rod", "body `Rod` needs `output`"),
            ("ground", "`ground` can only be at an end …"),
            ("start", "a weld has no field `start`"),
            ("torque", "a weld has no field `torque`"),
        ],
    );
    expect(
        "ground -> pin(z) shoulder ->",
        "ground -> Rod shoulder -> ball x ->",
        &[
            ("Rod", "body `Rod` needs `output`"),
            (
                "shoulder",
                "`ground` and body `shoulder` have no hinge between them: add one, such \
                          as `weld name`",
            ),
            ("shoulder", "`shoulder` is a body: write the name of a hinge"),
        ],
    );
}

#[test]
fn ends_are_free_or_held() {
    expect(
        "-> Rod rod;",
        "-> Rod rod -> pin last;",
        &[("last", "hinge `last` connects nothing: …")],
    );
    expect(
        "ground -> pin",
        "pin",
        &[(
            "shoulder",
            "hinge `shoulder` connects nothing: begin the route with a body or with `ground`",
        )],
    );
    expect(
        "-> Rod rod;",
        "-> Rod rod -> pin last -> moving;",
        &[("Rod", "body `Rod` needs `output`"), ("moving", "a moving end needs a name: …")],
    );
}

#[test]
fn there_is_one_route_with_a_body() {
    expect_all("chain Empty { ground -> pin j; }", &[("ground", "the route has no body: …")]);
}

#[test]
fn stops_are_known() {
    expect("Cube upper", "Cub upper", &[("Cub", "unknown body type `Cub`; did you mean `Cube`?")]);
    expect(
        "ball wrist",
        "slidr wrist",
        &[("slidr", "unknown kind of hinge `slidr`; did you mean `slider`?")],
    );
    expect(
        "body Rod {",
        "body Beam { mass = 1; com = [0, 0, 0]; inertia = diag(1, 1, 1) about com; } body Rod {",
        &[(
            "Beam",
            "type `Beam` is not used on the route: add a body of this type, or remove the \
                    block",
        )],
    );
}

#[test]
fn stops_are_well_formed() {
    expect(
        "Cube upper",
        "Cube(1) upper",
        &[(
            "(1)",
            "a body has no arguments: remove the \
                                                     parentheses",
        )],
    );
}

#[test]
fn a_route_that_cannot_be_read_is_not_judged() {
    expect(
        "-> ball wrist",
        "-> 7 -> ball wrist",
        &[("7", "expected a hinge, a body or `ground`, found `7`")],
    );
    expect("Rod rod;", "Rod rod", &[("rod", "expected `;` after this")]);
    expect("Rod rod;", "Rod", &[("Rod", "expected `;` after this")]);
    expect("upper -> ball", "upper; ball", &[("ball", "… `->` instead of the `;` before it")]);
    expect("Rod rod;", "Rod rod ->;", &[(";", "expected a hinge, a body or `ground`, found `;`")]);
}

#[test]
fn names_of_other_programs_are_known() {
    let expect_kind = |kind: &str, meant: &str| {
        let message = format!("unknown kind of hinge `{kind}`; did you mean `{meant}`?");
        let route = format!("ground -> {kind} j -> Rod rod; hinge j {{ start = 1; }}");
        expect_rods(&route, &[(kind, &message)]);
    };
    expect_kind("Pin", "pin");
    expect_kind("BALL", "ball");
    expect_kind("Revolute", "pin");
    expect_kind("prismatic", "slider");
    expect_kind("spherical", "ball");
    expect_kind("fixed", "weld");
    expect_kind("continuous", "pin");
    expect_kind("hinge", "pin");
    for free in ["freeflyer", "free_flyer", "freejoint"] {
        let message = format!("unknown kind of hinge `{free}`; did you mean `floating`?");
        expect_rods(&format!("ground -> {free} j -> Rod rod;"), &[(free, &message)]);
    }
    expect_rods(
        "ground -> Pin(z) j -> Rod rod; hinge j { start = 1; }",
        &[("Pin", "unknown kind of hinge `Pin`; did you mean `pin`?")],
    );
    for ground in ["world", "base", "Ground"] {
        let message = format!("unknown route item `{ground}`; did you mean `ground`?");
        expect_rods(&format!("{ground} -> pin j -> Rod rod;"), &[(ground, &message)]);
    }
    // Beside it nothing is judged.
    expect_rods(
        "ground -> Bar j -> Rod rod; hinge j { start = 1; }",
        &[("Bar", "unknown body type `Bar`")],
    );
}

#[test]
fn the_name_comes_last() {
    expect_rods(
        "ground -> pin j -> rod Rod;",
        &[("rod", "the type comes first, then the name: `Rod rod`")],
    );
    expect_rods(
        "ground -> j pin -> Rod rod; hinge j { start = 1; }",
        &[("j", "the kind comes first, then the name: `pin j`")],
    );
}

#[test]
fn arguments_of_a_kind_follow_it_in_parentheses() {
    expect_rods(
        "ground -> pin z Rod rod; load push { on = rod; force = input; }",
        &[("z", "write `pin(z) name -> Rod`")],
    );
    let message = "write `pin(z) j`";
    let rest = "-> Rod rod; hinge j { start = 1; }";
    expect_rods(&format!("ground -> pin j(z) {rest}"), &[("(z)", message)]);
    expect_rods(&format!("ground -> pin[z] j {rest}"), &[("[z]", message)]);
    expect_rods(&format!("ground -> pin<z> j {rest}"), &[("<", message)]);
    expect_rods(
        &format!("ground -> pin {{ axis = z; }} j {rest}"),
        &[("{ axis = z; }", "write `pin(…) j`")],
    );
    expect_rods("pin { axis = z; } j -> Rod r;", &[("{ axis = z; }", "write `pin(…) j`")]);
}

#[test]
fn stops_are_joined_by_arrows() {
    let message = "join the items of a route by `->`";
    expect_rods("ground => pin j => Rod rod;", &[("=", message)]);
    expect_rods("ground - pin j -> Rod rod;", &[("-", message)]);
    expect_rods("ground, pin j, Rod rod;", &[(",", message)]);
    expect_rods(
        "pin j => Rod rod => pin k;",
        &[
            ("j", "hinge `j` connects nothing: begin the route with a body or with `ground`"),
            ("=", message),
            ("k", "hinge `k` connects nothing: end the route with a body or with `ground`"),
        ],
    );
    expect_rods(
        "route = ground -> pin j -> Rod rod;",
        &[("route", "the route has no name: write only `ground -> …`")],
    );
}

#[test]
fn items_next_to_the_route_are_not_a_second_route() {
    let route = "ground -> pin j -> Rod rod;";
    for (stray, word) in [
        ("use x;", "use"),
        ("units mm;", "units"),
        ("fn f() {}", "fn"),
        ("foo x { a = 1; }", "foo"),
    ] {
        let message = format!("unknown item `{word}`{ITEMS}");
        expect_rods(&format!("{stray} {route}"), &[(word, &message)]);
        expect_rods(&format!("{route} {stray}"), &[(word, &message)]);
    }
    let place = "write the position of the ground on the route: `ground at [x, y, z] turned …`";
    expect_rods(&format!("{route} ground {{ at = [1, 0, 0]; }}"), &[("ground", place)]);
    expect_rods(&format!("ground {{ at = [1, 0, 0]; }} {route}"), &[("ground", place)]);
    expect_rods(&format!("# the route\n{route}"), &[("#", "a comment begins with `//`")]);
}

#[test]
fn repeated_parts_in_branches_have_no_errors_of_their_own() {
    expect_rods(
        "ground -> { pin j -> Rod rod -> repeat 2 { pin k -> Rod last } }; hinge k { damping = 1; }",
        &[("{", "write a branch as another route, after the `;` of this one: …")],
    );
}

#[test]
fn moving_ends_are_on_routes() {
    let message =
        "a moving end begins or ends a route: write `moving name -> …` or `… -> moving name`";
    expect_rods("moving deck; moving deck -> pin j -> Rod rod;", &[("moving", message)]);
    expect_rods("moving; moving deck -> pin j -> Rod rod;", &[("moving", message)]);
    expect_rods("moving = deck -> pin j -> Rod rod;", &[("=", "write `moving deck`")]);
    let last = "ground -> ball a -> Rod rod -> ball b -> Rod rod2 -> ball c -> moving: hand;";
    expect_rods(last, &[(":", "write `moving hand`")]);
}

#[test]
fn the_last_end_follows_an_arrow() {
    let route = "ground -> pin a -> Rod rod -> pin b -> Rod rod2 -> pin k";
    expect_rods(
        &format!("{route} ground at [1, 0, 0];"),
        &[("ground", "expected `->`, found `ground`")],
    );
    expect_rods(&format!("{route} moving hand;"), &[("moving", "expected `->`, found `moving`")]);
    let at = "write `ground` before the position: `ground at …`";
    expect_rods(&format!("{route} -> at [1, 0, 0];"), &[("at", at)]);
    // This end begins the next route.
    let next = "ground at [1, 0, 0] -> pin c -> Rod rod3;";
    expect_rods(&format!("{route} {next}"), &[("k", "expected `;` after this")]);
}

#[test]
fn moving_ends_have_no_place() {
    let message = "a moving end has no position: its motion is an input";
    expect_rods("moving deck at [1, 0, 0] -> pin j -> Rod rod;", &[("at", message)]);
    expect_rods("moving deck turned rpy(0, 0, 1) -> pin j -> Rod rod;", &[("turned", message)]);
    expect_rods(
        "moving deck -> pin j -> Rod rod; moving deck { at = [1, 0, 0]; }",
        &[("moving", message)],
    );
}

#[test]
fn fields_of_a_hinge_are_after_the_route() {
    let rest = "Rod rod;";
    let message = "the fields of a hinge are not on the route: write `hinge a { … }` after it";
    let block = "{ damping = 1; torque = input; }";
    expect_rods(&format!("ground -> pin(y) a {block} -> {rest}"), &[(block, message)]);
    expect_rods(&format!("ground -> ball a {block} -> {rest}"), &[(block, message)]);
    let unnamed = "… `hinge name { … }` …";
    expect_rods(&format!("ground -> pin(y) {block} -> {rest}"), &[(block, unnamed)]);
    expect_rods(&format!("ground -> pin {block} a -> {rest}"), &[(block, unnamed)]);
    let argument = "… `hinge a { damping = …; }` …";
    expect_rods(&format!("ground -> pin(y, damping = 1) a -> {rest}"), &[("damping", argument)]);
    let axis = "arguments have no names: remove `axis =`";
    expect_rods(&format!("ground -> pin(axis = y) a -> {rest}"), &[("axis", axis)]);
}

#[test]
fn blocks_of_hinges_name_hinges() {
    let route = |route: &str| format!("{route}; hinge link {{ start = 1; }}");
    expect_rods(
        &route("ground -> pin joint -> Rod link"),
        &[("link", "`link` is a body: write the name of its hinge, `joint`")],
    );
    expect_rods(
        "part Leg { pin hip -> Rod thigh; hinge thigh { start = 1; } } ground -> pin joint -> Rod trunk -> Leg left;",
        &[("thigh", "`thigh` is a body: write the name of its hinge, `hip`")],
    );
    expect_rods(
        &route("Rod link -> pin joint -> Rod end"),
        &[("link", "`link` is a body: write `body link { … }`")],
    );
}
