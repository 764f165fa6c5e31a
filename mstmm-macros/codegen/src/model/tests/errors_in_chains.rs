//! Errors in dimensions, ends, loads and repeated parts.

use super::each_error_once::expect_rods;
use super::{edited, expect, expect_all};

const PLANE: &str = "
    plane chain Swing {
        gravity = [0, -9.8] m/s^2;
        body Rod { mass = 1 kg; com = [0.5, 0] m; output = [1, 0] m; inertia = 0.1 kg*m^2 about com; }
        ground -> pin a -> Rod first -> slider b -> Rod last;
        load push { on = last; force = [1, 2] N; }
    }";

#[track_caller]
fn expect_plane(from: &str, to: &str, errors: &[(&str, &str)]) {
    assert_eq!(PLANE.matches(from).count(), 1, "`{from}` must stand once in {PLANE}");
    expect_all(&PLANE.replace(from, to), errors);
}

#[test]
fn plane_chains_have_two_components() {
    expect_plane(
        "gravity = [0, -9.8]",
        "gravity = [0, -9.8, 0]",
        &[("[0, -9.8, 0]", "expected 2 components …, found 3")],
    );
    expect_plane(
        "output = [1, 0] m",
        "output = [1, 0] m turned rpy(1, 0, 0)",
        &[("rpy(1, 0, 0)", "expected an angle, found `rpy(…)`")],
    );
    expect_plane("pin a", "pin(z) a", &[("(z)", "… rotates about z: …")]);
    expect_plane(
        "slider b",
        "planar(x) b",
        &[("(x)", "`planar` of a plane chain has no arguments: remove the parentheses")],
    );
    expect_plane(
        "force = [1, 2] N",
        "torque = [0, 0, 1] N*m",
        &[("[0, 0, 1]", "expected a torque as a single number, found a vector")],
    );
}

#[test]
fn inertias_in_the_plane_are_numbers() {
    let original = "0.1 kg*m^2 about com";
    expect_plane(
        original,
        "diag(1, 1, 1) about com",
        &[("diag(1, 1, 1)", "expected one moment of inertia in a plane chain, …")],
    );
    expect_plane(
        original,
        "0.1 kg*m^2",
        &[("0.1 kg*m^2", "an inertia needs a reference point: …")],
    );
    expect_plane(original, "-0.1 about com", &[("-0.1", "a moment of inertia cannot be negative")]);
    expect_plane(
        original,
        "0.2 about input",
        &[("0.2 about input", "this inertia about the input is too small …")],
    );
    expect_plane(original, "0.25 about input", &[]);
    expect_plane(
        "mass = 1 kg",
        "mass = 1 kg about com",
        &[("1 kg about com", "expected a mass, found a number about a point")],
    );
}

#[test]
fn line_chains_have_one_component() {
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
        &line("slider", "com = [1, 0, 0] m;", ""),
        &[("[1, 0, 0]", "expected a length as a single number, …")],
    );
    expect_all(
        &line("slider", "", "").replace("1 m ->", "1 m turned 2 ->"),
        &[("2", "a line chain has no orientations: …")],
    );
    expect_all(
        &line("slider", "", "load push { on = last; torque = 1; }"),
        &[("torque", "load `push` of a line chain has no field `torque`; did you mean `force`?")],
    );
}

#[test]
fn ends_are_at_the_ends() {
    expect("ground -> pin(z) shoulder", "moving hand -> pin(z) shoulder", &[]);
    expect(
        "ground -> pin(z) shoulder",
        "moving shoulder -> pin(z) a",
        &[("shoulder", "`shoulder` is a moving end and has no properties: its motion is an input")],
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
    expect_all(source, &[("moving", "… welds or prescribed: …")]);
    expect_all(&source.replace("hinge b { motion = input; }", ""), &[]);
}

/// A load on the example's rod.
#[track_caller]
fn expect_load(load: &str, errors: &[(&str, &str)]) {
    expect_all(&edited(&[("hinge wrist", &format!("{load} hinge wrist"))]), errors);
}

#[test]
fn loads_are_complete() {
    expect_load(
        "load push { on = rod; forc = [1, 0, 0]; }",
        &[("forc", "load `push` has no field `forc`; did you mean `force`?")],
    );
    expect_load(
        "spring rope { on = rod; to = [1, 0, 0]; }",
        &[("rope", "spring `rope` needs a `stiffness` or a `force`")],
    );
    expect_load(
        "spring ram { on = rod; to = [1, 0, 0]; force = input; length = 1; }",
        &[("ram", "spring `ram` needs `stiffness`")],
    );
    expect_load(
        "spring ram { on = rod; to = [1, 0, 0]; force = [1, 0, 0] N; }",
        &[("[1, 0, 0]", "expected a force as a single number, found a vector")],
    );
    expect_load(
        "spring ram { on = rod; to = [1, 0, 0]; force = 3 N/m; }",
        &[("N/m", "expected a force, found a stiffness")],
    );
    expect_load(
        "spring ram { on = rod; to = [1, 0, 0]; force = input; } load ram_force { on = rod; force = input; }",
        &[("ram_force", "`ram_force` is reserved for an input of spring `ram`: …")],
    );
    expect_load(
        "spring rope { on = rod; to = [1, 0, 0]; stiffness = -1; damping = -2; length = 1 - ratio; }",
        &[
            ("-1", "a stiffness cannot be negative"),
            ("-2", "a damping cannot be negative"),
            ("1 - ratio", "a length cannot be negative; …"),
        ],
    );
    expect_load(
        "load push, pull { on = rod; force = input; }",
        &[("pull", "a block describes one load: write a block for each")],
    );
    expect(
        "ground ->",
        "load push { on = rod; force = input; } ground ->",
        &[("load", "write a load after the route")],
    );
}

#[test]
fn loads_act_at_points_of_bodies() {
    let at = |at: &str| format!("load push {{ on = rod; force = input; at = {at}; }}");
    expect_load(
        "load push { on = rd; force = input; }",
        &[("rd", "no body `rd` on a route; did you mean `rod`?")],
    );
    expect_load(
        "load push { on = wrist; force = input; }",
        &[("wrist", "`wrist` is a hinge: name the body that the force acts on")],
    );
    expect_load(
        "load push { on = 3; force = input; }",
        &[("3", "expected the name of a body on a route, found a number")],
    );
    expect_load(
        &at("inptu"),
        &[("inptu", "body `Rod` has no point `inptu`; did you mean `input`?")],
    );
    expect_load(
        &at("output"),
        &[("output", "body `Rod` has no output: give its type an `output`")],
    );
    expect_load(&at("[1, 2] m"), &[("[1, 2]", "expected 3 components …, found 2; …")]);
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
        "output = [1, 0, 0] m point tip = 3;",
        &[("m", "expected `;` after this"), ("3", "expected a vector …, found a number")],
    );
    expect(
        "hinge wrist {",
        "hinge wrist { point tip = [1, 0, 0];",
        &[("tip", "write points in the block of a body type, before the route")],
    );
    let after = |fields: &str| format!("ground -> pin(z) j -> Rod rod; body {fields}");
    let before = "write the block of a body type …";
    expect_rods(&after("Bar { mass = 1; point tip = [1, 0, 0]; }"), &[("Bar", before)]);
    let of_type = "`rod` is a body of type `Rod`: write what describes the type in `body Rod { … }`, before the route";
    expect_rods(&after("rod { point tip = [1, 0, 0]; }"), &[("rod", of_type)]);
    expect_rods(&after("rod { mass = 1; }"), &[("rod", of_type)]);
}

#[test]
fn names_of_loads_are_free() {
    let load = |name: &str| format!("load {name} {{ on = rod; force = input; }}");
    expect_load(&load("rod"), &[("rod", "the name `rod` is used twice")]);
    expect_load(
        &load("closure"),
        &[("closure", "`closure` is reserved for the generated types and cannot be a name")],
    );
    expect_load(
        &[load("push"), load("push_force")].concat(),
        &[("push_force", "`push_force` is reserved …")],
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
    let count = "expected a repeat count from …";
    for wrong in ["0", "1.5", "10_000_001", "2kg", "\"3\"", "'a'", "99999999999999999999999"] {
        expect_all(
            &route(&good.replace("repeat 3", &format!("repeat {wrong}"))),
            &[(wrong, count)],
        );
    }
    expect_all(
        &route(&good.replace("repeat 3", "repeat N")),
        &[("N", "write a repeat count in digits: the macro cannot read the value of `N`")],
    );
    expect_all(
        &route(&good.replace("repeat 3", "repeat -3")),
        &[("-", "expected a repeat count, found `-`")],
    );
    expect_all(
        &route(&good.replace("{ ball a -> Cube b }", "")),
        &[("-", "expected `{`, found `-`")],
    );
    expect_all(
        &route(&good.replace("ball a -> Cube b", "")),
        &[("{  }", &format!("this `repeat` is empty: {example}"))],
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
        &[("Cube", "expected `->`, `;` or `}`, found `Cube`")],
    );
    // The last body is followed by its own hinge.
    expect_all(
        &route(&format!("{rest} repeat 3 {{ ball a -> Rod b }};")),
        &[("Rod", "body `Rod` needs `output`")],
    );
    expect_all(&route(&format!("{rest} repeat 1 {{ ball a -> Rod b }};")), &[]);
}

#[test]
fn parameters_with_many_numbers_belong_to_one_repeated_part() {
    let expect_rope = |count: u32, base: &str, link: &str, errors: &[(&str, &str)]| {
        let rest = "com = [0, 0, 0]; output = [1, 0, 0]; inertia = diag(1, 1, 1) about com;";
        let source = format!(
            "chain Rope {{
                param m[3] = 1 kg;
                body Base {{ mass = {base}; {rest} }}
                body Link {{ mass = {link}; {rest} }}
                ground -> pin a -> Base base -> repeat {count} {{ pin b -> Link link }};
            }}"
        );
        expect_all(&source, errors);
    };
    expect_rope(3, "1 kg", "m", &[]);
    let count = "`m` has 3 values, but its part is repeated 2 times: write the same count in both";
    expect_rope(2, "1 kg", "m", &[("m", count)]);
    let outside = "`m` has a value for each of 3 repetitions: only a part that is repeated as many times can use it";
    expect_rope(3, "m", "1 kg", &[("m", outside)]);
    let both = "`m` has one value for each repetition of a part, and is used elsewhere too: \
                write a separate parameter for the other uses";
    expect_rope(3, "m", "m", &[("m", both)]);
}
