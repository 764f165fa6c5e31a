//! Messages name the cause of an error, once, and their advice can be followed.

use super::each_error_once::{expect_hinge, expect_rods};
use super::expect_all;

#[test]
fn a_suggested_unit_has_the_same_size() {
    let start = |unit: &str, error: &str| {
        expect_hinge("pin", &format!("start = 1 {unit};"), &[(unit, error)]);
    };
    start("mdeg", "unknown unit `mdeg`");
    start("dam", "unknown unit `dam`");
    start("degs", "unknown unit `degs`; did you mean `deg`?");
    start("MM", "unknown unit `MM`; units are case-sensitive: `mm`, `Mm`");
}

#[test]
fn a_pitch_is_a_length_per_angle() {
    let other = |pitch: &str, found: &str, unit: &str| {
        let message = format!("expected a pitch, found {found}");
        expect_hinge(&format!("screw(z, {pitch})"), "", &[(unit, &message)]);
    };
    other("5 mm*rev", "a quantity in m*rad", "mm*rev");
    other("5 mm/rev^2", "a quantity in m/rad^2", "mm/rev^2");
    expect_hinge("screw(z, 5 mm/deg)", "stiffness = 1 N*m; damping = 1 N*m*s/rad;", &[]);
}

#[test]
fn axis_letters_mean_axes() {
    let part = "part P(x, y, z) { pin(x) a -> Rod r -> screw(-z, z) b -> Rod s -> planar(y) c -> Rod t; \
                hinge a { damping = x; stiffness = y; } }";
    expect_rods(&format!("{part} ground -> P(1, 2, 3) p;"), &[]);
    let chain = "param z = 1; ground -> screw(-z, z) a -> Rod r;";
    expect_rods(chain, &[]);
}

#[test]
fn a_moving_end_may_have_the_name_of_a_place() {
    for name in ["at", "turned"] {
        expect_rods(&format!("moving {name} -> pin a -> Rod r;"), &[]);
        expect_rods(&format!("moving z -> pin {name} -> Rod r -> pin a -> moving hand;"), &[]);
        expect_rods(&format!("ground -> pin a -> Rod r -> pin b -> moving {name};"), &[]);
    }
    let place = "a moving end has no position: …";
    let name = ("moving", "a moving end needs a name: …");
    expect_rods("moving at [1, 0, 0] m -> pin a -> Rod r;", &[name, ("at", place)]);
    expect_rods("moving turned 30 deg -> pin a -> Rod r;", &[name, ("turned", place)]);
}

#[test]
fn a_chain_has_one_dimension() {
    let chain = "chain A { body Rod { mass = 1; com = [0, 0]; inertia = 1 about com; } ground -> pin j -> Rod rod; }";
    let one = "a chain has one word for its dimension: remove this one";
    expect_all(&format!("plane plane {chain}"), &[("plane", one)]);
    expect_all(&format!("line plane {chain}"), &[("plane", one)]);
}

#[test]
fn hinges_of_several_kinds_have_several_blocks() {
    let route = "ground -> pin a -> Rod rod -> slider b -> Rod r2;";
    let message =
        "a slider has no field `torque`, unlike a pin: write a block for each kind of hinge";
    let error = [("torque", message)];
    expect_rods(&format!("{route} hinge a, b {{ torque = input; }}"), &error);
    expect_rods(&format!("{route} hinge b, a {{ torque = input; }}"), &error);
    let near = "a pin has no field `force`; did you mean `torque`?";
    expect_rods(&format!("{route} hinge a {{ force = input; }}"), &[("force", near)]);
}

#[test]
fn a_given_field_is_not_suggested() {
    let spring = |fields: &str, error: (&str, &str)| {
        expect_rods(&format!("ground -> pin j -> Rod rod; spring s {{ {fields} }}"), &[error]);
    };
    let meant = |field: &str| format!("spring `s` has no field `from`; did you mean `{field}`?");
    let (to, at) = (meant("to"), meant("at"));
    spring("from = rod.output; to = [0, 0, 0]; stiffness = 1;", ("from", &meant("on")));
    spring("on = rod; from = [0, 0, 0]; to = [0, 0, 1]; stiffness = 1;", ("from", &at));
    spring("on = rod; from = [0, 0, 0]; stiffness = 1;", ("from", &to));
}

/// Expects an error in the mass of a body.
fn expect_mass(items: &str, mass: &str, errors: &[(&str, &str)]) {
    let body = format!(
        "body Bar {{ mass = {mass}; com = [0, 0, 0]; inertia = diag(1, 1, 1) about com; }}"
    );
    expect_all(&format!("chain A {{ {items} {body} ground -> pin j -> Bar; }}"), errors);
}

#[test]
fn only_possible_parameters_are_suggested() {
    let function = "unknown name `sin`; write the argument of the function: `sin(…)`";
    expect_mass("", "sin kg", &[("sin", function)]);
    for name in ["parameter", "gravity", "new", "hinge", "transfer"] {
        expect_mass("", name, &[(name, &format!("unknown name `{name}`"))]);
        expect_mass("", &format!("2 * {name}"), &[(name, &format!("unknown name `{name}`"))]);
    }
    expect_mass("new = 1 kg;", "1", &[("new", "unknown setting `new`")]);
    expect_mass("", "gen", &[("gen", "expected a number, found `gen`")]);
}

#[test]
fn keywords_of_rust_are_refused_where_they_are_declared() {
    for name in ["fn", "self", "async", "_"] {
        let refused = format!("`{name}` is a keyword of Rust and cannot be a name");
        expect_mass(&format!("param {name} = 1 kg;"), name, &[(name, &refused)]);
        expect_mass("", name, &[(name, &format!("expected a number, found `{name}`"))]);
        let part =
            format!("part P({name}) {{ pin a -> Rod rod; hinge a {{ damping = 2*{name}; }} }}");
        expect_rods(&format!("{part} ground -> P(1) p;"), &[(name, &refused)]);
    }
    let plain = "write this name without `r#`: `a`";
    expect_rods("ground -> pin r#a -> Rod rod;", &[("r#a", plain)]);
}

#[test]
fn a_word_that_is_no_type_is_one_error() {
    let body =
        "{ mass = 1; com = [0, 0, 0]; output = [0, 0, 0]; inertia = diag(1, 1, 1) about com; }";
    let keyword = [("pin", "`pin` is a keyword of this language …")];
    expect_rods(&format!("body pin {body} ground -> pin a -> pin b;"), &keyword);
    expect_rods("part pin { ball a -> Rod b; } ground -> pin a;", &keyword);
    expect_rods("part pin { ball a -> Rod b; } ground -> ball c -> Rod r -> pin a;", &keyword);
    let keyword = [("ground", "`ground` is a keyword of this language …")];
    expect_rods(
        &format!("body ground {body} ground -> pin a -> Rod r -> pin b -> ground g;"),
        &keyword,
    );
    let name = [("g", "the ground has no name: remove `g`")];
    expect_rods("ground g -> pin a -> Rod r;", &name);
    let both = [("Rod", "`Rod` is a part and a body type: …")];
    expect_rods("part Rod { pin a -> Rod b; } ground -> Rod r;", &both);
    expect_rods("part P { } ground -> P p;", &[("P", "part `P` has no route: …")]);
}

#[test]
fn several_names_are_one_error() {
    let each = "a `param` is one parameter: write a `param` for each";
    expect_mass("param p, r = 1 kg;", "p + r", &[(",", each)]);
    let branches = "join the items of a route by `->`; …";
    let route = "ground -> pin(z) a, b -> Rod rod; hinge a, b { damping = 1; }";
    expect_rods(route, &[(",", branches)]);
}

#[test]
fn a_chain_has_no_parameters_in_parentheses() {
    let body = "body Rod { mass = 1; com = [0, 0, 0]; inertia = diag(1, 1, 1) about com; }";
    let chain =
        |parameters: &str| format!("chain A{parameters} {{ {body} ground -> pin j -> Rod rod; }}");
    expect_all(&chain("()"), &[("(", "expected `{`, found `(`")]);
    expect_all(&chain("(m)"), &[("(", "expected `{`, found `(`")]);
}

#[test]
fn names_have_no_hyphens() {
    let hyphens = [("start", "a name has no hyphens: write `start_rate`")];
    expect_hinge("pin", "start-rate = 1;", &hyphens);
    let other = [("limit", "a name has no hyphens: write `limit_of_speed`")];
    expect_hinge("pin", "limit-of-speed = 1;", &other);
}

#[test]
fn arguments_of_parts_are_in_parentheses() {
    let part = "part Leg(x) { pin a -> Rod b; hinge a { damping = x; } }";
    expect_rods(
        &format!("{part} ground -> pin j -> Rod rod; rod.output -> Leg{{1}} left;"),
        &[("{1}", "write `Leg(…) left`")],
    );
}

#[test]
fn only_inertias_have_a_reference_point() {
    let body = |com: &str| {
        format!("body Bar {{ mass = 1; com = {com}; inertia = diag(1, 1, 1) about com; }}")
    };
    expect_rods(
        &format!("{} ground -> pin j -> Rod rod -> pin k -> Bar b;", body("[1, 0, 0] m about com")),
        &[("com", "only an inertia has a reference point: …")],
    );
}

#[test]
fn a_word_that_is_no_shape_is_refused_itself() {
    let body = |shape: &str| {
        format!("mass = 1; com = [0, 0, 0]; inertia = diag(1, 1, 1) about com; shape = {shape};")
    };
    for word in ["none", "input"] {
        let message = format!("expected a shape, such as `sphere(radius = 5 cm)`, found `{word}`");
        expect_rods(
            &format!("body Bar {{ {} }} ground -> pin j -> Rod rod -> pin k -> Bar b;", body(word)),
            &[(word, &message)],
        );
    }
}

#[test]
fn a_point_of_a_load_is_a_single_name() {
    let load = |at: &str| {
        format!("ground -> pin j -> Rod rod; load f {{ on = rod; at = {at}; force = input; }}")
    };
    let single = "a point of this body has a single name: `at = output`";
    expect_rods(&load("rod.output"), &[("rod.output", single)]);
    expect_rods(&load("output"), &[]);
}

#[test]
fn names_have_no_index() {
    let message = "remove the index: in a `repeat` a name means the same repetition, and after it a repeated body is the last one";
    let index = [("[0]", message)];
    let rest = "ground -> pin j -> Rod rod -> repeat 2 { pin k -> Rod link };";
    expect_rods(&format!("{rest} load f {{ on = link[0]; force = input; }}"), &index);
    expect_rods(&format!("{rest} load f {{ on = link[0].com; force = input; }}"), &index);
    expect_rods(&format!("{rest} load f {{ on = link.com[0]; force = input; }}"), &index);
    let each = format!("param each[2] = 1 kg*m^2; {rest}");
    expect_rods(&format!("{each} hinge k {{ armature = 2*each[0]; }}"), &index);
    expect_rods(&format!("{each} hinge k {{ armature = 2*each; }}"), &[]);
    let entry =
        [("[2]", "a number uses constants of type `f64`: write a separate `const` for this entry")];
    expect_hinge("pin", "damping = 2*DAMPINGS[2];", &entry);
    expect_hinge("pin", "damping = motors::DAMPINGS[2];", &entry);
    expect_hinge("pin", "damping = sqrt[4];", &[("[", "expected `(`, found `[`")]);
}

#[test]
fn a_frame_is_a_position_and_then_an_orientation() {
    let comma = [(",", "write `turned` instead of the comma: `turned rpy(…)`")];
    let first = [("at", "write the position first: `at [x, y, z] turned …`")];
    let rest = "-> pin j -> Rod rod;";
    expect_rods(&format!("ground at [1, 0, 0] m, rpy(0, 0, 1) {rest}"), &comma);
    expect_rods(&format!("ground turned rpy(0, 0, 1) at [1, 0, 0] m {rest}"), &first);
    let position = [("(1, 0, 0)", "write the position as `ground at [x, y, z] m`")];
    expect_rods(&format!("ground(1, 0, 0) {rest}"), &position);
    let body = |shape: &str, output: &str| {
        format!(
            "body Bar {{ mass = 1; com = [0, 0, 0]; inertia = diag(1, 1, 1) about com; \
             shape = {shape}; output = {output}; }} ground -> pin j -> Rod rod -> pin k -> Bar bar;"
        )
    };
    let [ball, end] = ["sphere(radius = 1)", "[1, 0, 0]"];
    expect_rods(&body(ball, "[1, 0, 0], rpy(0, 0, 1)"), &comma);
    expect_rods(&body("sphere(radius = 1) turned rpy(0, 0, 1) at [1, 0, 0]", end), &first);
    expect_rods(&body("sphere(radius = 1) at [1, 0, 0] turned rpy(0, 0, 1)", end), &[]);
}

#[test]
fn a_later_route_is_more_than_its_beginning() {
    let no_body = [("ground", "the route has no body: …")];
    expect_rods("ground -> pin j -> Rod rod; ground;", &no_body);
    expect_rods("ground -> pin j -> Rod rod; ground at [1, 2, 3] m;", &no_body);
}

#[test]
fn fields_are_in_blocks() {
    let message =
        "a field is in the block of its element: for a hinge write `hinge j { start = …; }`";
    expect_rods("ground -> pin j -> Rod rod; j.start = 1;", &[("j.start", message)]);
}

#[test]
fn constants_are_parameters_or_of_rust() {
    let message = "write a value with a name as `param name = …;`, which can be set at run time, or as a `const` of Rust \
                   before the macro, with a name in capital letters";
    for word in ["const", "let"] {
        let text = format!("{word} Length = 1 m; ground -> pin j -> Rod rod;");
        expect_rods(&text, &[(word, message)]);
    }
}
