//! Mistakes in dimensions, ends, loads and repeated parts.

use super::{edited, expect, expect_all};

const PLANE: &str = "
    plane chain Swing {
        gravity = [0, -9.8] m/s^2;
        body Rod { mass = 1 kg; com = [0.5, 0] m; output = [1, 0] m; inertia = 0.1 kg*m^2 about com; }
        ground -> pin a -> Rod first -> slider b -> Rod last;
        load push { on = last; force = [1, 2] N; }
    }";

#[track_caller]
fn expect_plane(from: &str, to: &str, mistakes: &[(&str, &str)]) {
    assert_eq!(PLANE.matches(from).count(), 1, "`{from}` must stand once in {PLANE}");
    expect_all(&PLANE.replace(from, to), mistakes);
}

#[test]
fn nothing_leads_out_of_the_plane() {
    expect_plane(
        "gravity = [0, -9.8]",
        "gravity = [0, -9.8, 0]",
        &[("[0, -9.8, 0]", "a vector of a plane chain has 2 components, here are 3")],
    );
    expect_plane(
        "output = [1, 0] m",
        "output = [1, 0] m turned rpy(1, 0, 0)",
        &[("rpy(1, 0, 0)", "expected an angle, found `rpy(…)`")],
    );
    expect_plane(
        "pin a",
        "pin(z) a",
        &[("(z)", "`pin` of a plane chain takes nothing in parentheses")],
    );
    expect_plane(
        "slider b",
        "slider(z) b",
        &[("z", "expected an axis: `x`, `y`, `-x`, `-y` or `[a, b]`")],
    );
    expect_plane(
        "slider b",
        "ball b",
        &[(
            "ball",
            "a plane chain has no `ball`: its hinges are `weld`, `pin`, `slider`, `planar`, `floating` and `elastic`",
        )],
    );
    expect_plane(
        "slider b",
        "planar(x) b",
        &[("(x)", "`planar` of a plane chain takes nothing in parentheses")],
    );
    expect_plane(
        "force = [1, 2] N",
        "torque = [0, 0, 1] N*m",
        &[("[0, 0, 1]", "expected a torque: a single number")],
    );
}

#[test]
fn inertias_in_the_plane_are_numbers() {
    let written = "0.1 kg*m^2 about com";
    expect_plane(
        written,
        "diag(1, 1, 1) about com",
        &[(
            "diag(1, 1, 1)",
            "in a plane chain an inertia is a number as in `0.1 kg*m^2 about com`, found `diag(…)`",
        )],
    );
    expect_plane(
        written,
        "0.1 kg*m^2",
        &[("0.1 kg*m^2", "an inertia is about a point: end with `about com` or `about input`")],
    );
    expect_plane(written, "-0.1 about com", &[("-0.1", "a moment of inertia cannot be negative")]);
    expect_plane(
        written,
        "0.2 about input",
        &[(
            "0.2 about input",
            "no body with this mass and centre of mass has so little inertia about its input; is it `about com`?",
        )],
    );
    expect_plane(written, "0.25 about input", &[]);
    expect_plane(
        "mass = 1 kg",
        "mass = 1 kg about com",
        &[("1 kg about com", "expected a mass, found a number about a point")],
    );
}

#[test]
fn nothing_leads_off_the_line() {
    let line = |hinge: &str, fields: &str, more: &str| {
        format!(
            "line chain Train {{
            body Car {{ mass = 1 kg; output = 1 m; {fields} }}
            ground at 1 m -> {hinge} a -> Car first -> slider b -> Car last;
            {more}
        }}"
        )
    };
    expect_all(&line("slider", "", ""), &[]);
    expect_all(
        &line("pin", "", ""),
        &[(
            "pin",
            "a line chain has no `pin`: its hinges are `weld`, `slider`, `floating` and `elastic`",
        )],
    );
    expect_all(
        &line("slider(x)", "", ""),
        &[("(x)", "`slider` of a line chain takes nothing in parentheses")],
    );
    expect_all(
        &line("slider", "com = [1, 0, 0] m;", ""),
        &[("[1, 0, 0]", "expected a length: a single number")],
    );
    expect_all(
        &line("slider", "inertia = 1 about com;", ""),
        &[(
            "inertia",
            "body `Car` of a line chain has no field `inertia`; it has `mass`, `com` and `output`",
        )],
    );
    expect_all(
        &line("slider", "", "").replace("1 m ->", "1 m turned 2 ->"),
        &[("2", "nothing is turned in a line chain")],
    );
    expect_all(
        &line("slider", "", "load push { on = last; torque = 1; }"),
        &[("torque", "load `push` of a line chain has no field `torque`; did you mean `force`?")],
    );
}

#[test]
fn ends_are_at_the_ends() {
    expect(
        "-> Cube upper ->",
        "-> Cube upper -> pin a -> moving b -> pin c -> Cube d ->",
        &[(
            "moving",
            "`moving` can only be at an end of the route: end this chain here, and write what follows as a second chain",
        )],
    );
    expect("ground -> pin(z) shoulder", "moving hand -> pin(z) shoulder", &[]);
    expect(
        "ground -> pin(z) shoulder",
        "moving shoulder -> pin(z) a",
        &[("shoulder", "nothing can be said of `shoulder`: its motion is given at each step")],
    );
    expect(
        "ground -> pin(z) shoulder",
        "moving upper -> pin(z) shoulder",
        &[("upper", "the name `upper` is used twice")],
    );
    let source = "chain Stiff {
        body Rod { mass = 1; com = [0, 0, 0]; inertia = diag(1, 1, 1) about com; output = [1, 0, 0]; }
        ground -> weld a -> Rod -> pin b -> moving c;
        hinge b { motion = input; }
    }";
    expect_all(
        source,
        &[("moving", "the chain is held at both ends and no hinge between them is free to move")],
    );
    expect_all(&source.replace("hinge b { motion = input; }", ""), &[]);
}

/// A load on the example's rod.
#[track_caller]
fn expect_load(written: &str, mistakes: &[(&str, &str)]) {
    expect_all(&edited(&[("hinge wrist", &format!("{written} hinge wrist"))]), mistakes);
}

#[test]
fn loads_are_complete() {
    expect_load("load push { }", &[("push", "load `push` needs `on` and a `force` or a `torque`")]);
    expect_load(
        "load push { on = rod; forc = [1, 0, 0]; }",
        &[("forc", "load `push` has no field `forc`; did you mean `force`?")],
    );
    expect_load(
        "spring rope { on = rod; to = [1, 0, 0]; }",
        &[("rope", "spring `rope` needs `stiffness`")],
    );
    expect_load(
        "spring rope { on = rod; to = [1, 0, 0]; stiffness = -1; damping = -2; length = 1 - ratio; }",
        &[
            ("-1", "a stiffness cannot be negative"),
            ("-2", "a damping cannot be negative"),
            ("1 - ratio", "a length cannot be negative; with its parameters' defaults it is -1"),
        ],
    );
    expect_load(
        "load push, pull { on = rod; force = input; }",
        &[("pull", "a block describes one load")],
    );
    expect(
        "ground ->",
        "load push { on = rod; force = input; } ground ->",
        &[("load", "loads are described after the route")],
    );
}

#[test]
fn loads_act_at_points_of_bodies() {
    let at = |at: &str| format!("load push {{ on = rod; force = input; at = {at}; }}");
    expect_load(
        "load push { on = rd; force = input; }",
        &[("rd", "no body `rd` on the route; did you mean `rod`?")],
    );
    expect_load(
        "load push { on = wrist; force = input; }",
        &[("wrist", "`wrist` is a hinge: only a body can be pulled at")],
    );
    expect_load(
        "load push { on = 3; force = input; }",
        &[("3", "expected the name of a body on the route, found a number")],
    );
    expect_load(
        &at("inptu"),
        &[("inptu", "body `Rod` has no point `inptu`; did you mean `input`?")],
    );
    expect_load(&at("output"), &[("output", "body `Rod` has no output")]);
    expect_load(&at("[1, 2] m"), &[("[1, 2]", "a vector has 3 components, here are 2")]);
    expect_load(
        "load push { on = rod; force = input; axes = bdy; }",
        &[("bdy", "expected `inertial` or `body`, found `bdy`; did you mean `body`?")],
    );
    expect_load(
        "load push { on = rod; force = [1, 0, 0] N*m; torque = [1, 0, 0] N; }",
        &[("N*m", "expected a force, found a torque"), ("N", "expected a torque, found a force")],
    );
    let point = "output = [1, 0, 0] m;";
    expect(
        point,
        "output = [1, 0, 0] m; point tip = [1, 0, 0]; point tip = [1, 0, 0];",
        &[("tip", "body `Cube` has two points `tip`")],
    );
    expect(
        point,
        "output = [1, 0, 0] m; point com = [1, 0, 0];",
        &[("com", "every body has a point `com`")],
    );
    expect(
        point,
        "output = [1, 0, 0] m point tip = 3;",
        &[("m", "expected `;` after this"), ("3", "expected a vector `[x, y, z]`, found a number")],
    );
    expect(
        "hinge wrist {",
        "hinge wrist { point tip = [1, 0, 0];",
        &[("tip", "points are described with a type of body, before the route")],
    );
}

#[test]
fn names_of_loads_are_free() {
    let load = |name: &str| format!("load {name} {{ on = rod; force = input; }}");
    expect_load(&load("rod"), &[("rod", "the name `rod` is used twice")]);
    expect_load(&load("fn"), &[("fn", "`fn` is a keyword of Rust and cannot be a name")]);
    expect_load(
        &load("closure"),
        &[("closure", "`closure` is a method of every chain and cannot be a name")],
    );
    expect_load(
        &load("gravity"),
        &[("gravity", "`gravity` is an input of chains and cannot be a name")],
    );
    expect_load(
        &[load("push"), load("push_force")].concat(),
        &[("push_force", "`push_force` is what an input of load `push` is called")],
    );
}

#[test]
fn repeats_are_well_formed() {
    let route = |route: &str| {
        edited(&[
            ("-> Cube upper -> ball wrist -> Rod rod;", route),
            ("hinge wrist { start_rate = [0, 0.1, 0] rad/s; }", ""),
        ])
    };
    let example = "write it as in `repeat 100 { pin joint -> Rod rod }`";
    let rest = "-> Cube upper ->";
    let good = format!("{rest} repeat 3 {{ ball a -> Cube b }} -> weld w -> Rod rod;");
    expect_all(&route(&good), &[]);
    let count = "how many times is a whole number from 1 to 10000000";
    for wrong in ["0", "1.5", "10_000_001", "2kg", "\"3\"", "'a'", "99999999999999999999999"] {
        expect_all(
            &route(&good.replace("repeat 3", &format!("repeat {wrong}"))),
            &[(wrong, count)],
        );
    }
    expect_all(
        &route(&good.replace("repeat 3", "repeat N")),
        &[("N", "expected how many times, a number, found `N`")],
    );
    expect_all(
        &route(&good.replace("repeat 3", "repeat -3")),
        &[("-", "expected how many times, a number, found `-`")],
    );
    expect_all(
        &route(&good.replace("{ ball a -> Cube b }", "")),
        &[("-", "expected `{`, found `-`")],
    );
    expect_all(
        &route(&good.replace("ball a -> Cube b", "")),
        &[("{  }", &format!("nothing is repeated here: {example}"))],
    );
    expect_all(
        &route(&good.replace("ball a -> Cube b", "ball a -> Cube b -> ball c")),
        &[("c", &format!("`repeat` ends with a body, not with hinge `c`: {example}"))],
    );
    expect_all(
        &route(&good.replace("ball a -> Cube b", "Cube b -> ball a -> Cube c")),
        &[("b", &format!("`repeat` begins with a hinge, not with body `b`: {example}"))],
    );
    expect_all(
        &route(&good.replace("ball a -> Cube b", "ball a -> Cube b ->")),
        &[(">", "expected a hinge, a body or `ground` after this")],
    );
    expect_all(
        &route(&good.replace("ball a -> Cube b", "ball a Cube b")),
        &[("Cube", "expected `->` or `}`, found `Cube`")],
    );
    expect_all(
        &route(&good.replace("ball a -> Cube b", "repeat 2 { ball a -> Cube b }")),
        &[("repeat", "`repeat` cannot stand within `repeat`")],
    );
    expect_all(
        &route(&good.replace("Cube b", "ground")),
        &[("ground", "`ground` cannot stand in `repeat`")],
    );
    // The last body is followed by its own hinge.
    expect_all(
        &route(&format!("{rest} repeat 3 {{ ball a -> Rod b }};")),
        &[("Rod", "body `Rod` needs `output`")],
    );
    expect_all(&route(&format!("{rest} repeat 1 {{ ball a -> Rod b }};")), &[]);
}

#[test]
fn a_route_does_not_begin_with_repeat() {
    let source = "chain Rope {
        body Rod { mass = 1; com = [0, 0, 0]; inertia = diag(1, 1, 1) about com; output = [1, 0, 0]; }
        repeat 3 { ball a -> Rod b };
    }";
    expect_all(
        source,
        &[(
            "repeat",
            "a route cannot begin with `repeat`: begin it with a body, with `ground` or with `moving`",
        )],
    );
}
