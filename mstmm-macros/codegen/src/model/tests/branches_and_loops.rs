//! Messages for branches, loops and springs between bodies. They name alternatives, which
//! `tests/ways_round.rs` tries.

use super::each_error_once::expect_rods;

const BRANCHES: &str = "a chain has no branches: …";

const SPRING: &str = "a spring connects a body to the ground: …";

const SECOND: &str = "a chain has one route: write this one as a second chain; …";

const TRUNK: &str = "ground -> pin a -> Rod crank -> pin b -> Rod bar";

fn continues(name: &str) -> String {
    format!("a chain has one route: to continue it, write `->` instead of the `;` after `{name}`")
}

fn branches_at(name: &str) -> String {
    format!(
        "a chain has no branches, and `{name}` is on the route already: write the branch as a \
         separate chain, and couple the two by a `load` with `force = input` in each"
    )
}

fn closes_over(name: &str) -> String {
    format!(
        "`{name}` is on the route already, and a loop can close only at the ground or at a \
         moving end: end the route before this hinge, and hold the two bodies together by two \
         loads with `force = input`"
    )
}

#[test]
fn a_second_route_is_a_second_chain() {
    expect_rods(&format!("{TRUNK}; ground -> pin c -> Rod x;"), &[("ground", SECOND)]);
    expect_rods(&format!("{TRUNK}; moving m -> pin c -> Rod x;"), &[("moving", SECOND)]);
    expect_rods(
        &format!("{TRUNK}; Rod x -> pin c -> Rod y;"),
        &[("Rod", "a chain has one route: write this one as a second chain")],
    );
    // Names that are on the moving end's route already are of one end.
    expect_rods("moving m -> pin a -> Rod x; moving m -> pin b -> Rod y;", &[("moving", SECOND)]);
    // Hinges of both routes are known.
    let both = format!("{TRUNK}; ground -> pin c -> Rod x; hinge a, b, c {{ start = 1; }}");
    expect_rods(&both, &[("ground", SECOND)]);
    expect_rods(
        &format!("{both} load l {{ on = x; force = input; }} hinge d {{ start = 1; }}"),
        &[("ground", SECOND)],
    );
}

#[test]
fn the_rest_of_a_route_follows_on_an_arrow() {
    let rest = "… `->` instead of the `;` before this";
    expect_rods(&format!("{TRUNK}; pin c -> Rod x;"), &[("pin", rest)]);
    for start in ["bar", "Rod bar", "bar.tip", "bar at tip", "bar at [1, 0, 0] m", "from bar"] {
        let first = start.split([' ', '.']).next().expect("a word");
        let message = continues("bar");
        expect_rods(&format!("{TRUNK}; {start} -> pin c -> Rod x;"), &[(first, &message)]);
    }
}

#[test]
fn a_branch_is_a_separate_chain() {
    for start in ["crank", "Rod crank", "crank.tip", "crank at tip", "branch crank"] {
        let first = start.split([' ', '.']).next().expect("a word");
        let message = branches_at("crank");
        expect_rods(&format!("{TRUNK}; {start} -> pin c -> Rod x;"), &[(first, &message)]);
    }
    expect_rods(&format!("{TRUNK}; Rod x -> pin c -> crank;"), &[("Rod", &branches_at("crank"))]);
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
fn a_route_can_pass_through_a_body_with_two_branches() {
    let message = "… a route can pass through `hub`: …";
    expect_rods("Rod hub -> pin a -> Rod left; hub -> pin b -> Rod right;", &[("hub", message)]);
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
        &format!("{TRUNK}; bar -> pin c -> crank;"),
        &[("bar", "a loop can close only at the ground or at a moving end, not at `bar`: …")],
    );
    expect_rods(
        "moving m -> pin a -> Rod x -> pin b -> moving m;",
        &[(
            "m",
            "the name `m` is used twice; give this end another name, and both ends the same motion",
        )],
    );
    let message = "a closed chain is a route that ends as it began, …";
    expect_rods(&format!("{TRUNK}; loop {{ bar -> pin c -> crank; }}"), &[("loop", message)]);
}

#[test]
fn hinges_are_at_outputs() {
    let message = "the next hinge is always at the `output` of a body: …";
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
fn a_spring_goes_to_the_ground() {
    let expect_spring = |fields: &str, at: &str, message: &str| {
        expect_rods(&format!("{TRUNK}; spring s {{ {fields} stiffness = 1; }}"), &[(at, message)]);
    };
    for to in ["bar", "bar.tip", "bar at tip", "bar at [1, 0, 0] m"] {
        expect_spring(&format!("on = crank; to = {to};"), "bar", SPRING);
    }
    expect_spring("on = [crank, bar];", "bar", SPRING);
    expect_spring("on = crank; to = ground;", "ground", "write the point on the ground: …");
    let point = "a point is a separate field: write `on = crank; at = …;`";
    expect_spring("on = crank.tip; to = [0, 0, 0];", "crank.tip", point);
    let ground = "the ground is fixed: name a body on the route";
    expect_spring("on = ground; to = [0, 0, 0];", "ground", ground);
    expect_rods(
        &format!("{TRUNK}; load l {{ on = [crank, bar]; force = input; }}"),
        &[("bar", "a load acts on one body: write a `load` for each")],
    );
    expect_rods(
        &format!("{TRUNK}; load l {{ on = crank.tip; force = input; }}"),
        &[("crank.tip", point)],
    );
}
