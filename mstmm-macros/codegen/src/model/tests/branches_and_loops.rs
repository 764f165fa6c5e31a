//! Messages for branches, loops and springs between bodies.

use super::each_error_once::expect_rods;

const BRANCHES: &str = "write a branch as another route, …";

const TRUNK: &str = "ground -> pin a -> Rod crank -> pin b -> Rod bar";

fn begins_at(name: &str) -> String {
    format!(
        "a later route begins at a place: `{name}.output -> …`; `{name}` has `input` and `output`"
    )
}

fn closes_over(name: &str) -> String {
    format!(
        "`{name}` is on a route already, and a loop can close only at the ground or at a moving \
         end: end the route before this hinge, and hold the two bodies together by a `spring` that \
         is stiff and damped, or by constraints as in `mstmm::tutorial::several_loops`; for a branch end \
         the route, and begin another one at a place of `{name}`"
    )
}

#[test]
fn a_route_ends_in_a_body_unless_it_is_the_first() {
    let closes = "this closes a loop: …";
    expect_rods(
        &format!("{TRUNK}; bar.output -> pin c -> Rod x -> pin d -> ground;"),
        &[("ground", closes)],
    );
    expect_rods(
        &format!("{TRUNK}; ground -> pin c -> Rod x -> pin d -> moving hand;"),
        &[("moving", closes)],
    );
    expect_rods(&format!("{TRUNK}; bar.output -> pin c;"), &[("c", "the route has no body: …")]);
    expect_rods(&format!("{TRUNK}; bar.output -> pin c -> ground;"), &[("ground", closes)]);
    expect_rods(
        &format!("{TRUNK}; bar.output -> pin c -> Rod x -> pin d;"),
        &[("d", "hinge `d` connects nothing: end the route with a body")],
    );
    expect_rods(
        &format!("{TRUNK}; bar.output -> Rod x;"),
        &[("x", "`bar.output` and body `x` have no hinge between them: …")],
    );
    expect_rods(
        "moving m -> pin a -> Rod x; moving m -> pin b -> Rod y;",
        &[(
            "m",
            "the name `m` is used twice; give this end another name, and both ends the same motion",
        )],
    );
}

#[test]
fn a_later_route_begins_with_an_end_or_at_a_place() {
    for start in ["bar", "Rod bar", "bar at output", "bar at [1, 0, 0] m", "from bar", "branch bar"]
    {
        let first = start.split([' ', '.']).next().expect("a word");
        expect_rods(&format!("{TRUNK}; {start} -> pin c -> Rod x;"), &[(first, &begins_at("bar"))]);
    }
    expect_rods(
        &format!("{TRUNK}; Rod x -> pin c -> Rod y;"),
        &[("Rod", "only the first route begins with a body: …")],
    );
    expect_rods(
        &format!("{TRUNK}; pin c -> Rod x;"),
        &[("pin", "hinge `c` connects nothing: begin the route at a place, …")],
    );
}

#[test]
fn branches_are_other_routes() {
    let joined = format!("join the items of a route by `->`; {BRANCHES}");
    for sign in [",", "|", "&"] {
        expect_rods(&format!("{TRUNK} {sign} pin c -> Rod x;"), &[(sign, &joined)]);
    }
    expect_rods(
        "ground -> pin a -> Rod hub -> { pin b -> Rod x, pin c -> Rod y }; hinge b, c { start = 1; }",
        &[("{", BRANCHES)],
    );
    expect_rods(
        "ground -> pin a -> Rod hub -> (pin b -> Rod x) -> pin c -> Rod y; hinge b { start = 1; }",
        &[("(", BRANCHES)],
    );
    expect_rods("ground -> pin a -> Rod hub -> [pin b -> Rod x];", &[("[", BRANCHES)]);
    expect_rods(
        &format!("{TRUNK}; branch {{ crank -> pin c -> Rod x; }}"),
        &[("branch", BRANCHES)],
    );
}

#[test]
fn a_loop_closes_over_the_ground_or_a_moving_end() {
    for end in ["crank", "crank.tip", "crank at tip", "crank at [1, 0, 0] m turned rpy(0, 0, 1)"] {
        expect_rods(&format!("{TRUNK} -> pin c -> {end};"), &[("crank", &closes_over("crank"))]);
    }
    expect_rods(
        &format!("{TRUNK} -> pin c -> crank -> pin d -> Rod x;"),
        &[("crank", &closes_over("crank"))],
    );
    expect_rods(
        &format!("{TRUNK} -> pin c -> Rod crank;"),
        &[(
            "crank",
            "the name `crank` is used twice; a loop can close only at the ground or at a moving \
             end",
        )],
    );
    expect_rods(
        &format!("{TRUNK}; bar.output -> pin c -> crank;"),
        &[("crank", &closes_over("crank"))],
    );
    expect_rods(
        "moving m -> pin a -> Rod x -> pin b -> moving m;",
        &[(
            "m",
            "the name `m` is used twice; give this end another name, and both ends the same motion",
        )],
    );
    let message = "a closed chain is a first route that ends as it began, …";
    expect_rods(&format!("{TRUNK}; loop {{ bar -> pin c -> crank; }}"), &[("loop", message)]);
}

#[test]
fn hinges_are_at_outputs() {
    let message = "on a route the next hinge is at the `output` of a body: …";
    for (place, at) in [(".tip", "tip"), (" at tip", "at"), (" at [1, 0, 0] m", "at")] {
        expect_rods(
            &format!("ground -> pin a -> Rod x{place} -> pin b -> Rod y;"),
            &[(at, message)],
        );
    }
    expect_rods(
        "ground -> pin a at [1, 0, 0] m -> Rod x;",
        &[("at", "a hinge is at the `output` of the body before it: …")],
    );
}

#[test]
fn a_spring_is_between_two_points() {
    let expect_spring = |fields: &str, at: &str, message: &str| {
        expect_rods(&format!("{TRUNK}; spring s {{ {fields} stiffness = 1; }}"), &[(at, message)]);
    };
    let ends = "a spring is between two bodies …";
    expect_spring("on = [crank, bar];", "bar", ends);
    expect_spring("on = crank; to = bar;", "bar", "name the place on `bar`: `to …");
    for to in ["bar at tip", "bar at [1, 0, 0] m"] {
        let message = "write a point after the body, …";
        expect_spring(&format!("on = crank; to = {to};"), to, message);
    }
    expect_spring(
        "on = crank at tip; to = bar.output;",
        "crank at tip",
        "write a point after the body, …",
    );
    for to in ["ground", "ground at [1, 0, 0] m"] {
        let message = "write the point on the ground: …";
        expect_spring(&format!("on = crank; to = {to};"), to, message);
    }
    let ground = "the ground is fixed: name a body on a route";
    expect_spring("on = ground; to = [0, 0, 0];", "ground", ground);
    expect_spring("on = ground at [1, 0, 0] m; to = [0, 0, 0];", "ground", ground);
    let brackets = "write the body without brackets: `on = crank`";
    expect_spring("on = [crank]; to = [0, 0, 0];", "[crank]", brackets);
    let one = |field: &str| format!("`{field}` has one value: remove the others");
    expect_spring("on = crank, bar; to = [0, 0, 0];", ",", &one("on"));
    expect_spring("on = bar; to = crank.output, bar.input;", ",", &one("to"));
    let no_place = "`crank` has no place `tip`; it has `input` and `output`";
    expect_spring("on = crank.tip; to = [0, 0, 0];", "tip", no_place);
    expect_spring("on = bar; to = crank.tip;", "tip", no_place);
    expect_spring(
        "on = bar.output; at = input; to = crank.input;",
        "at",
        "`on` has a point already: remove …",
    );
    expect_spring(
        "on = bar.output; to = bar.input;",
        "bar",
        "both ends of this spring are on `bar`",
    );
    expect_rods(
        &format!("{TRUNK}; load l {{ on = [crank, bar]; force = input; }}"),
        &[("bar", "a load acts on one body: write a `load` for each")],
    );
    expect_rods(
        &format!("{TRUNK}; load l {{ on = crank.tip; force = input; }}"),
        &[("tip", no_place)],
    );
}
