//! Warnings: right chains that are perhaps not what was meant.

use quote::quote;

use super::text;
use crate::diag::Warning;

/// All warnings of a right chain: the text that each is on, and the message.
fn warnings_in(source: &str) -> Vec<(String, String)> {
    let expansion = crate::expand(source.parse().expect("tokens"), &quote!(::mstmm));
    assert!(expansion.errors.is_none(), "{:?}, in {source}", expansion.errors);
    let items = expansion.items.to_string();
    assert_eq!(items.matches("deprecated").count(), expansion.warnings.len(), "in {source}");
    let shown = |Warning { at, message, .. }: Warning| (text(source, at), message);
    expansion.warnings.into_iter().map(shown).collect()
}

/// Expects warnings on exactly these tokens of a chain.
#[track_caller]
fn expect_chain(source: &str, expected: &[&str]) {
    let warnings = warnings_in(source);
    let tokens: Vec<&str> = warnings.iter().map(|(token, _)| token.as_str()).collect();
    assert_eq!(tokens, expected, "in {source}");
}

const ROD: &str = "body Rod { mass = 1; com = [0.5, 0, 0]; output = [1, 0, 0]; \
                   inertia = diag(1, 1, 1) about com; }";

/// Expects warnings on exactly these tokens of a chain with two hinges of this kind, of which this
/// is written.
#[track_caller]
fn expect_hinge(kind: &str, fields: &str, expected: &[&str]) {
    let parameters = [("tilt", "40"), ("full", "4*PI"), ("fine", "40 deg"), ("small", "2")];
    let used = parameters.iter().filter(|(name, _)| fields.contains(name));
    let parameters: String =
        used.map(|(name, default)| format!("param {name} = {default}; ")).collect();
    let route = format!("ground -> {kind} a -> Rod one -> {kind} b -> Rod two;");
    let hinges = format!("hinge a, b {{ {fields} }}");
    expect_chain(&format!("chain A {{ {parameters} {ROD} {route} {hinges} }}"), expected);
}

/// Three bars of one metre close a gap of two metres, but none of four metres, unless its position is known at run time
/// only.
#[test]
fn a_closed_chain_can_be_closed_near_its_start() {
    let loops = |end: &str| {
        let parameter = if end.contains("far") { "param far = 4 m;" } else { "" };
        format!(
            "chain A {{ {parameter} {ROD} ground -> pin(z) a -> Rod one -> pin(z) b -> Rod two \
             -> pin(z) c -> Rod three -> pin(z) d -> {end}; hinge a {{ start = 0.3; }} hinge b {{ start = -1.5; }} }}"
        )
    };
    expect_chain(&loops("ground at [2, 0, 0]"), &[]);
    expect_chain(&loops("ground at [4, 0, 0]"), &["d"]);
    expect_chain(&loops("ground at [far, 0 m, 0 m]"), &["d"]);
    expect_chain(&loops("moving cart"), &[]);
    let message = "no pose near the start closes this chain, so `assemble` fails: …";
    let warnings = warnings_in(&loops("ground at [4, 0, 0]"));
    assert!(super::says(&warnings[0].1, message), "{warnings:?}");
}

/// With all bars in line, the linearised constraints hold for no rotation that closes the gap. Next to that pose they do.
#[test]
fn a_closed_chain_is_closed_from_its_start_itself() {
    let loops = |starts: &str| {
        format!(
            "chain A {{ {ROD} ground -> pin(z) a -> Rod one -> pin(z) b -> Rod two -> pin(z) c -> Rod three \
             -> pin(z) d -> ground at [2, 0, 0]; {starts} }}"
        )
    };
    expect_chain(&loops("hinge b { start = 0.1; }"), &[]);
    let warnings = warnings_in(&loops(""));
    let message = "`assemble` cannot close this chain from its start, but from poses next to it: write a `start` of the \
                   hinges with the links bent, closer to a closed pose";
    assert!(warnings.len() == 1 && super::says(&warnings[0].1, message), "{warnings:?}");
}

#[test]
fn a_closed_chain_has_regular_constraints_at_its_start() {
    let bar = |length: f64, starts: &str| {
        format!(
            "chain A {{ {ROD} ground -> pin(z) a -> Rod one -> pin(z) b -> Rod two -> pin(z) c -> Rod three \
             -> pin(z) d -> ground at [{length}, 0, 0]; {starts} }}"
        )
    };
    let message_of = |text: &str| match &warnings_in(text)[..] {
        [(_, message)] => message.clone(),
        others => panic!("{others:?}"),
    };
    let taut = "this closed chain has no other closed pose near its start, and accelerations fail or have no meaning there: \
                its links are in line and cannot move; check the lengths of the bodies and the positions of the ends";
    assert_eq!(message_of(&bar(3.0, "")), taut);
    // Folded flat, the links of a parallelogram are in line and can leave the line.
    let folded = "the loop constraints of this chain are singular at its start, and accelerations fail or have no meaning \
                  there: write a `start` of the hinges with the links bent";
    let flat = "hinge b { start = 180 deg; } hinge c { start = -180 deg; }";
    assert_eq!(message_of(&bar(1.0, flat)), folded);
    for unit in ["um", "m", "Mm"] {
        expect_chain(
            &format!(
                "plane chain A {{ body Block {{ mass = 1; com = [0, 0]; inertia = 1 kg*{unit}^2 about com; output = [1, 0] {unit}; }} \
                 ground -> slider(x) a -> Block one -> slider([1, 1]) b -> Block two -> slider(y) c -> ground at [2, 0] {unit}; }}"
            ),
            &[],
        );
    }
    expect_chain(
        &bar(
            1.0,
            "hinge a { start = 10 deg; } hinge b { start = 170 deg; } hinge c { start = -170 deg; }",
        ),
        &[],
    );
    let long = format!(
        "chain A {{ {ROD} ground -> repeat 5 {{ pin(z) a -> Rod r }} -> pin(z) b -> ground at [5, 0, 0]; }}"
    );
    assert_eq!(message_of(&long), taut);
}

/// At a right angle of the middle axis the axes of a gimbal are in one plane. A rod without inertia about its axis turns about
/// it only where it hangs down.
#[test]
fn an_open_chain_has_accelerations_at_its_start() {
    let gimbal = |start: &str, end: &str| {
        format!(
            "chain A {{ {ROD} ground -> gimbal a -> Rod one{end}; hinge a {{ start = [10, {start}, 30] deg; }} }}"
        )
    };
    expect_chain(&gimbal("89", ""), &[]);
    expect_chain(&gimbal("-90", ""), &["start"]);
    // The moving end is a prescribed motion without a start.
    expect_chain(&gimbal("90", " -> ball b -> moving hand"), &[]);
    let hanging = |start: &str| {
        format!(
            "chain A {{ body Thin {{ mass = 1; com = [0, 0, -0.5]; inertia = diag(1, 1, 0) about com; }} \
             body Joint {{ mass = 1; com = [0, 0, 0]; output = [0, 0, 0]; inertia = diag(1, 1, 0) about com; }} \
             ground -> pin(z) a -> Joint one -> pin(x) b -> Thin two; hinge b {{ start = {start}; }} }}"
        )
    };
    expect_chain(&hanging("0.1"), &[]);
    let warnings = warnings_in(&hanging("0"));
    let message = "accelerations are `Singular` at the start: there hinge `a` is free in a direction in which the bodies that \
                   it moves have no inertia, or its axes are in one plane; write another `start`";
    assert_eq!(warnings, [("a".to_owned(), message.to_owned())]);
}

/// A hinge without a `start` starts at zero. The start of a motion is given at run time.
#[test]
fn a_hinge_starts_within_its_limits() {
    let limited = |fields: &str| format!("{fields} limit_stiffness = 1;");
    let within = |kind: &str, fields: &str| expect_hinge(kind, &limited(fields), &[]);
    // Two hinges share the field.
    let beyond = |kind: &str, fields: &str| expect_hinge(kind, &limited(fields), &["start"]);
    within("pin", "start = -40 deg; limits = [-40, 100] deg;");
    beyond("pin", "start = -41 deg; limits = [-40, 100] deg;");
    expect_hinge("slider", &limited("limits = [1, 2];"), &["a", "b"]);
    beyond("slider", "start = 0.2 nm; limits = [-0.1, 0.1] nm;");
    within("slider", "start = 0.1 nm; limits = [-0.1, 0.1] nm;");
    beyond("slider", "start = -1 mm; limits = [0, 1e10] m;");
    within("universal", "start = [0.3, -0.3]; limits = [-0.3, 0.3];");
    beyond("universal", "start = [0.3, -0.4]; limits = [-0.3, 0.3];");
    within("ball", "start = rpy(0, 50, 0) deg; limits = 50 deg;");
    beyond("ball", "start = rpy(0, 50, 0) deg; limits = 49 deg;");
    within(
        "ball",
        "start = rpy(0, 50, 0) deg; rest = rpy(0, 20, 0) deg; stiffness = 1; limits = 30 deg;",
    );
    let turning = "turning_limits = [-1, 1]; turning_limit_stiffness = 1;";
    expect_hinge("cylindrical", &format!("start = 3 m turned 0.9; {turning}"), &[]);
    expect_hinge("cylindrical", &format!("start = 3 m turned 1.1; {turning}"), &["start"]);
    beyond("pin", "start = small; limits = [0, 1];");
    within("pin", "motion = input; limits = [1, 2];");
    let rope = "chain A { ROD ground -> repeat 3 { pin(z) a -> Rod one }; \
                hinge a { start = 0.2; limits = [0, 0.1]; limit_stiffness = 1; } }";
    let warnings = warnings_in(&rope.replace("ROD", ROD));
    let message = "hinge `a` starts beyond its limits, whose springs push it back: write a `start` within them";
    assert_eq!(warnings, [("start".to_owned(), message.to_owned())]);
}

#[test]
fn an_angle_of_more_than_a_revolution_has_a_unit() {
    // Two hinges share the field: there is one warning.
    expect_hinge("pin", "start = 30;", &["30"]);
    expect_hinge("pin", "start = -30.5;", &["30.5"]);
    expect_hinge("pin", "start = (30);", &["(30)"]);
    expect_hinge("pin", "start = 6.29; rest = -7; stiffness = 1;", &["6.29", "7"]);
    expect_hinge("pin", "limits = [-90, 100]; limit_stiffness = 1;", &["90", "100"]);
    expect_hinge(
        "ball",
        "start = rpy(1, 20, 30); rest = rpy(1, 2, 45); stiffness = 1;",
        &["20", "30", "45"],
    );
    expect_hinge("universal", "start = [10, 1];", &["10"]);
    expect_hinge("gimbal", "start = [1, 10, 2];", &["10"]);
    expect_hinge("screw(z, 5 mm/rev)", "start = 100;", &["100"]);
    expect_hinge(
        "cylindrical",
        "start = 1 m turned 30; turning_limits = [-9, 31]; turning_limit_stiffness = 1;",
        &["30", "9", "31"],
    );
    expect_hinge(
        "planar",
        "start = [10, 20] turned 30; rest = [10, 20] turned -30; stiffness = 1;",
        &["30", "30"],
    );
    expect_hinge("floating", "start = [9, 9, 9] m turned rpy(0, 0, 90);", &["90"]);
    expect_hinge("elastic", "start = [9, 9, 9] m turned rpy(90, 0, 0);", &["90"]);
}

#[test]
fn frames_and_functions_take_angles() {
    let chain = |ground: &str, output: &str, start: &str| {
        format!(
            "chain A {{ body Rod {{ mass = 1; com = [9, cos(60), 0]; output = {output}; \
             inertia = diag(1, 1, 1) about com; }} {ground} Rod one -> pin j -> Rod two; {start} }}"
        )
    };
    expect_chain(
        &chain("ground turned rpy(30, 0, 0) -> weld a ->", "[9, 9, 9] turned rpy(0, 45, 0)", ""),
        &["60", "45", "30"],
    );
    expect_chain(
        &chain("", "[sqrt(30), 0, 0]", "body one { start = [9, 9, 9] turned rpy(0, 0, 7); }"),
        &["60", "7"],
    );
    let plane = "plane chain A { body Rod { mass = 1; com = [9, 9]; inertia = 90 about com; \
                 output = [9, 9] turned 30; } ground at [9, 9] turned -45 -> pin a -> Rod one \
                 -> planar b -> Rod two; hinge b { start = [9, 9] turned 20; } }";
    expect_chain(plane, &["30", "45", "20"]);
}

#[test]
fn an_expression_is_judged_by_its_value() {
    expect_hinge("pin", "start = 10*3;", &["10"]);
    expect_hinge("pin", "start = 20 + 10;", &["20"]);
    expect_hinge("pin", "start = 30/10;", &[]);
    expect_hinge("pin", "start = -2^2; rest = 3^2; stiffness = 1;", &["3"]);
    // A multiple of π is meant in radians.
    expect_hinge("pin", "start = 10*PI; rest = -2*(1 + PI); stiffness = 1;", &[]);
}

#[test]
fn the_default_of_a_parameter_is_judged_where_it_is_an_angle() {
    expect_hinge("pin", "start = tilt; rest = -tilt; stiffness = 1;", &["40"]);
    expect_hinge("pin", "start = tilt/100;", &[]);
    expect_hinge("pin", "start = 5*small;", &["5"]);
    expect_hinge("pin", "start = full; rest = 2*full; stiffness = 1;", &[]);
    expect_hinge("pin", "start = fine; rest = 20*fine; stiffness = 1;", &[]);
    expect_hinge("pin", "start_rate = tilt; damping = tilt;", &[]);
}

#[test]
fn angles_with_units_and_other_values_are_accepted() {
    expect_hinge("pin", "start = 30 deg; rest = 30 rad; stiffness = 1;", &[]);
    expect_hinge(
        "pin",
        "start = 6.28; rest = -6.28; stiffness = 1; start_rate = 100; torque = 90;",
        &[],
    );
    expect_hinge("pin", "limits = [-90, 100] deg; limit_stiffness = 100;", &[]);
    expect_hinge("pin", "start = ANGLE; rest = 10*consts::ANGLE; stiffness = 1;", &[]);
    expect_hinge("slider", "start = 30; rest = -30; stiffness = 1;", &[]);
    expect_hinge("ball", "start = quaternion(90, 0, 0, 90); start_rate = [90, 90, 90];", &[]);
    expect_hinge("ball", "start = rpy(90 deg, 0, 400 rad);", &[]);
    expect_hinge("elastic", "start = [30, 40, 50]; stiffness = 100;", &[]);
}

#[test]
fn the_message_says_what_to_write() {
    let message = |start: &str| {
        let hinge = format!("hinge a {{ start = {start}; }}");
        let source = format!("chain A {{ {ROD} ground -> pin a -> Rod one; {hinge} }}");
        let [(_, message)] = &warnings_in(&source)[..] else { panic!("one warning in {source}") };
        message.clone()
    };
    assert_eq!(
        message("30"),
        "`30` is an angle of 30 rad, more than 4 turns: \
         write `30 deg` for degrees, or `30 rad` if radians are meant"
    );
    assert_eq!(
        message("-6.5"),
        "`6.5` is an angle of 6.5 rad, more than one turn: \
         write `6.5 deg` for degrees, or `6.5 rad` if radians are meant"
    );
    assert_eq!(
        message("10*3.33"),
        "this angle without a unit is 33.3 rad, more than 5 turns: \
         write `(…) deg` for degrees, or `(…) rad` if radians are meant"
    );
}

#[test]
fn warnings_are_in_the_order_of_the_text() {
    let source = "chain A { body Rod { mass = 1; com = [1, 0, 0]; inertia = diag(1, 1, 1) about com; }
        ground turned rpy(0, 0, 10) -> pin a -> Rod one; hinge a { rest = 20; stiffness = 1; start = 30; } }
        chain B { param tilt = 40; body Rod { mass = 1; com = [1, 0, 0]; inertia = diag(1, 1, 1) about com; }
        ground turned rpy(0, 0, 50) -> pin a -> Rod one; hinge a { rest = 60; stiffness = 1; start = tilt; } }";
    expect_chain(source, &["10", "20", "30", "40", "50", "60"]);
}

#[test]
fn the_first_value_of_a_repeat_is_used() {
    let repeat = |branch: &str| {
        format!(
            "chain A {{ {ROD} ground -> weld w -> Rod beam -> repeat 3 from link.output = beam.output {{ \
             ball knot -> Rod link; {branch} }}; }}"
        )
    };
    expect_chain(&repeat("last.link.output -> pin a -> Rod x"), &[]);
    let warnings = warnings_in(&repeat("link.output -> pin a -> Rod x"));
    let message =
        "`link.output` is not used: no route and no spring of this `repeat` has `last.link.output`";
    assert_eq!(warnings, [("link".to_owned(), message.to_owned())]);
}

/// A chain with a parameter `k`, with these items before its route, this beginning of its route, and these blocks.
fn with_parameter(items: &str, route: &str, blocks: &str) -> String {
    format!(
        "chain A {{ param k = 1; {items} {ROD} {route} pin(x) a -> Rod one -> ball b -> Rod two; \
         {blocks} }}"
    )
}

#[test]
fn the_parameters_of_a_chain_are_used() {
    let warnings = warnings_in(&with_parameter("", "ground ->", "hinge a { damping = 1; }"));
    let [(token, message)] = &warnings[..] else { panic!("{warnings:?}") };
    assert_eq!(token, "k");
    assert!(super::says(message, "no value depends on … `k`: … write `_k`"), "{message}");
    let unused = |items: &str| with_parameter(items, "ground ->", "");
    expect_chain(&unused("param _j = 1; param i[3] = 2 kg;"), &["k", "i"]);
    // A word for an axis is no use.
    expect_chain(&unused("param x = 1;"), &["k", "x"]);
    // Each chain of a call has its own parameters.
    let two = format!("{} {}", unused(""), unused("").replace("chain A", "chain B"));
    expect_chain(&two, &["k", "k"]);
    // The part does not use its argument, so no value depends on the parameter.
    let part = "part Leg(_d) { pin knee -> Rod shank; }";
    expect_chain(&with_parameter(part, "ground -> Leg(k) leg ->", ""), &["k"]);
    let repeat = |fields: &str| {
        format!(
            "chain A {{ param k[3] = 1; {ROD} ground -> weld w -> Rod beam -> repeat 3 {{ \
             pin knot -> Rod link; }}; hinge knot {{ {fields} }} }}"
        )
    };
    expect_chain(&repeat("stiffness = k;"), &[]);
    expect_chain(&repeat("stiffness = 1;"), &["k"]);
}

/// A parameter is used by any value that depends on it, also through the arguments of parts.
#[test]
fn any_value_uses_a_parameter() {
    let expect_used = |items: &str, route: &str, blocks: &str| {
        expect_chain(&with_parameter(items, route, blocks), &[]);
    };
    expect_used("gravity = [0, -k, 0];", "ground ->", "");
    for fields in [
        "mass = k; com = [1, 0, 0]; output = [1, 0, 0]; inertia = diag(1, 1, 1) about com;",
        "mass = 1; com = [k, 0, 0]; output = [1, 0, 0]; inertia = diag(1, 1, 1) about com;",
        "mass = 1; com = [1, 0, 0]; output = [0, k, 0]; inertia = diag(1, 1, 1) about com;",
        "mass = 1; com = [1, 0, 0]; output = [1, 0, 0]; inertia = diag(k, 1, 1) about com;",
        "mass = 1; com = [1, 0, 0]; output = [1, 0, 0]; inertia = diag(1, 1, 1) about com; \
         point tip = [1, k, 0] turned rpy(0, 0, 1);",
    ] {
        expect_used(&format!("body B {{ {fields} }}"), "ground -> weld w -> B base ->", "");
    }
    for route in [
        "ground at [k, 0, 0] ->",
        "ground turned rpy(0, k, 0) ->",
        "ground -> pin([1, k, 0]) c -> Rod three ->",
        "ground -> screw(z, k) c -> Rod three ->",
    ] {
        expect_used("", route, "");
    }
    for block in [
        "hinge a { start = k; }",
        "hinge a { start_rate = -k; }",
        "hinge b { rest = rpy(k, 0, 0); stiffness = 1; }",
        "hinge a { stiffness = 2*k^2; }",
        "hinge b { armature = sqrt(k); }",
        "hinge a { friction = k; friction_speed = 1; }",
        "hinge a { friction = 1; friction_speed = k; }",
        "hinge a { limits = [0, k]; limit_stiffness = 1; }",
        "hinge a { limits = [0, 1]; limit_stiffness = k; }",
        "hinge b { torque = [0, 0, k]; }",
        "load l { on = two.com; force = [0, k, 0]; }",
        "load l { on = two; at = [k, 0, 0]; force = input; }",
        "spring s { on = two.com; to = [k, 0, 0]; stiffness = 1; }",
        "spring s { on = two.com; to = one.com; stiffness = 1; length = k; }",
    ] {
        expect_used("", "ground ->", block);
    }
    expect_used("", "Rod base ->", "body base { start = [k, 0, 0]; }");
    let knee =
        |damping: &str| format!("pin knee -> Rod shank; hinge knee {{ damping = {damping}; }}");
    let leg = |parameters: &str, content: &str| format!("part Leg{parameters} {{ {content} }}");
    expect_used(&leg("", &knee("k")), "ground -> Leg leg ->", "");
    expect_used(&leg("(d)", &knee("d")), "ground -> Leg(2*k) leg ->", "");
    let outer = format!("{} part Side(e) {{ Leg(e) leg; }}", leg("(d)", &knee("d")));
    expect_used(&outer, "ground -> Side(k) side ->", "");
}

#[test]
fn the_parameters_of_a_part_are_used() {
    let part = |parameters: &str, content: &str| {
        format!(
            "chain A {{ {ROD} part Leg({parameters}) {{ {content} }} ground -> pin root -> Rod base \
             -> Leg(1, 2) leg; }}"
        )
    };
    let leg = "pin knee -> Rod shank;";
    let with = |block: &str| format!("{leg} {block}");
    expect_chain(&part("side, k", &with("hinge knee { start = side; damping = 2*k; }")), &[]);
    expect_chain(&part("side, _k", &with("hinge knee { start = side; }")), &[]);
    expect_chain(&part("x, y", "pin([x, 1, y]) knee -> Rod shank;"), &[]);
    expect_chain(
        &part("x, y", &with("spring s { on = shank.com; to = [x, y, 0]; stiffness = 1; }")),
        &[],
    );
    let inner = "body B { mass = m; com = [1, 0, 0]; inertia = diag(1, 1, n) about com; } \
                 pin knee -> B shank;";
    expect_chain(&part("m, n", inner), &[]);
    let passed = "part Foot(a) { pin ankle -> Rod foot; hinge ankle { damping = a; } } \
                  part Leg(a, b) { pin knee -> Rod shank -> Foot(a) foot; }";
    let source = format!("chain A {{ {ROD} {passed} ground -> Leg(1, 2) leg; }}");
    expect_chain(&source, &["b"]);
    let warnings = warnings_in(&part("side, k", &with("hinge knee { damping = k; }")));
    let message = "part `Leg` does not use its parameter `side`: remove it, or write `_side`";
    assert_eq!(warnings, [("side".to_owned(), message.to_owned())]);
}
