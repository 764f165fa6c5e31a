//! Errors in names, settings and items.

use super::each_error_once::expect_rods;
use super::{PENDULUM, edited, expect, expect_all};
use crate::model::{ANSWER_WORDS, Foreign, OTHER_ANSWERS};

#[test]
fn names_are_used_once() {
    expect("param ratio", "param rod", &[("rod", "the name `rod` is used twice")]);
    expect("ball wrist", "ball upper", &[("upper", "the name `upper` is used twice")]);
    expect(
        "Rod rod",
        "Rod -> pin j -> Rod",
        &[
            ("Rod", "body `Rod` needs `output`"),
            ("Rod", "the name `rod` is used twice; write a name after the type"),
        ],
    );
    expect(
        "Rod rod",
        "Rod upper_mut",
        &[("upper_mut", "`upper_mut` and `upper` both make the method `upper_mut`: rename one")],
    );
    expect("body Rod {", "body Cube {", &[("Cube", "body type `Cube` is described twice")]);
}

#[test]
fn setters_are_no_jacobians() {
    let source = |parameter: &str, body: &str, answers: &str| {
        format!(
            "line chain A {{
                answers = {answers};
                param {parameter} = 1 kg;
                body Car {{ mass = {parameter}; }}
                ground -> slider joint -> Car {body};
            }}"
        )
    };
    for (parameter, body, method) in [
        ("jacobian", "set", "set_jacobian"),
        ("load_jacobian", "set_load", "set_load_jacobian"),
        ("jacobian_into", "set", "set_jacobian_into"),
    ] {
        let message =
            format!("`{body}` and `{parameter}` both make the method `{method}`: rename one");
        expect_all(&source(parameter, body, "jacobian"), &[(body, &message)]);
        expect_all(&source(parameter, body, "momentum"), &[]);
    }
}

#[test]
fn names_are_free() {
    // What the generated types keep for themselves.
    for (body, name) in [("Rod point_", "point_"), ("Rod PLACES_", "PLACES_")] {
        let message = format!("`{name}` is reserved for the generated types and cannot be a name");
        expect("Rod rod", body, &[(name, &message)]);
    }
    expect("Rod rod", "Rod r#fn", &[("r#fn", "`r#fn` is a keyword …")]);
    expect("body Rod {", "body pin {", &[("pin", "`pin` is a keyword …")]);
}

#[test]
fn items_are_known() {
    // The parameter is known all the same.
    let source = edited(&[("param payload", "parm payload"), ("mass = 2 kg", "mass = payload")]);
    expect_all(&source, &[("parm", "unknown item `parm`; did you mean `param`?")]);
    expect(
        "param ratio",
        "#[cfg(a)] param ratio",
        &[("#[cfg(a)]", "only doc comments are allowed here")],
    );
    expect("body Rod {", "body {", &[("{", "expected a name, found `{`")]);
    let source = format!("{PENDULUM} nonsense");
    expect_all(&source, &[("nonsense", "expected `chain`, found `nonsense`")]);
}

#[test]
fn dimensions_are_known() {
    let message = "expected `space`, `plane`, `line` or nothing before `chain`";
    let hint = format!("{message}; did you mean `plane`?");
    let empty = "chain `A` has no route: write one, as in `ground -> slider joint -> Car car;`";
    expect_all("planar chain A { }", &[("planar", &hint), ("A", empty)]);
    // Nothing can be judged in an unknown number of directions.
    expect_all("two chain A { }", &[("two", message)]);
}

#[test]
fn all_errors_of_all_phases_are_reported() {
    let source = "chain A {
        gravity = [0, 1, 0] kg;
        body B { mass = -1 kg; com = [0 0, 0] m; inertia = diag(1, 1, 3) about com; }
        ground -> pin j -> B -> pin k -> B b;
        hinge j { start = 3 m; }
        hinge l { start = 3 rad; }
    }";
    expect_all(
        source,
        &[
            ("kg", "expected an acceleration, found a mass"),
            ("B", "body `B` needs `output`"),
            ("-1 kg", "a mass must be positive"),
            ("0", "expected `,`, found `0`"),
            ("diag(1, 1, 3)", "no real body has this inertia: …"),
            ("b", "the name `b` is used twice"),
            ("m", "expected an angle, found a length"),
            ("l", "no hinge `l` on a route"),
        ],
    );
}

#[test]
fn words_that_items_begin_with_are_no_names() {
    for word in ["hinge", "body", "param", "ground"] {
        let message = format!("`{word}` is a keyword of this language and cannot be a name");
        let errors = &[(word, message.as_str())];
        expect_rods(&format!("ground -> pin {word} -> Rod rod;"), errors);
        expect_rods(&format!("ground -> pin j -> Rod {word}; hinge j {{ start = 1; }}"), errors);
        expect_rods(&format!("param {word} = 1; ground -> pin j -> Rod rod;"), errors);
    }
}

#[test]
fn names_made_from_types_are_no_keywords() {
    for (of_type, name) in [("Ground", "ground"), ("Body", "body"), ("Param", "param")] {
        let chain = |named: &str| {
            format!(
                "plane chain A {{
                    body {of_type} {{ mass = 1 kg; com = [0, 0] m; inertia = 1 kg*m^2 about com; }}
                    ground -> pin j -> {of_type}{named};
                }}"
            )
        };
        let message = format!(
            "this body has the name `{name}`, which is a keyword: write a name after the type"
        );
        expect_all(&chain(""), &[(of_type, message.as_str())]);
        assert!(super::read(chain(" b").parse().expect("tokens")).is_ok());
    }
}

#[test]
fn items_of_other_programs_are_known() {
    let expect_item = |from: &str, to: &str, word: &str, meant: &str| {
        let message = format!("unknown item `{word}`; did you mean `{meant}`?");
        expect(from, to, &[(word, &message)]);
    };
    expect_item("body Rod {", "link Rod {", "link", "body");
    expect_item("hinge wrist {", "joint wrist {", "joint", "hinge");
    expect_item("param ratio", "parameter ratio", "parameter", "param");
    let motor = "write a motor as the field `torque` or `force` of its hinge; an actuator between \
                 two points is a `spring` with `force = input`";
    let damper = "write a damper as the field `damping` of a hinge, or as a `spring` with \
                  `damping` and `stiffness = 0`";
    let sensor = "a chain has no sensors: the results have the positions, velocities and forces \
                  at all points";
    let contact = "a chain has no contacts: compute the force at each step, and apply it by a \
                   `load` with `force = input`";
    for (word, message) in
        [("motor", motor), ("damper", damper), ("sensor", sensor), ("contact", contact)]
    {
        let item = format!("{word} x {{ on = rod; gain = 1; }} hinge wrist {{");
        expect("hinge wrist {", &item, &[(word, message)]);
    }
}

#[test]
fn fields_of_other_programs_are_known() {
    let expect_field = |from: &str, to: &str, owner: &str, field: &str, meant: &str| {
        let message = format!("{owner} has no field `{field}`; did you mean `{meant}`?");
        expect(from, to, &[(field, &message)]);
    };
    let start = "start = 30 deg;";
    for field in ["range", "lower", "upper"] {
        expect_field(start, &format!("{field} = 1 rad;"), "a pin", field, "limits");
    }
    expect_field(start, "inertia = 1 kg*m^2;", "a pin", "inertia", "armature");
    let spring = "spring s { on = rod; to = [0, 0, 0]; stiffness = 1; rest = 1 m; } hinge wrist {";
    expect_field("hinge wrist {", spring, "spring `s`", "rest", "length");
    for word in ["site", "frame"] {
        let output = "output = [1, 0, 0] m;";
        let point = format!("{output} {word} tip = [2, 0, 0] m;");
        let message = format!("unknown word `{word}`; did you mean `point`?");
        expect(output, &point, &[(word, &message)]);
    }
}

#[test]
fn orientations_begin_with_turned() {
    let route = "ground -> pin(z) shoulder";
    let rotated = "unknown word `rotated`; did you mean `turned`?";
    let missing = "write `turned` before an orientation: `turned rpy(…)`";
    for position in ["at [0, 0, 1] m", ""] {
        for (word, at, message) in [("rotated ", "rotated", rotated), ("", "rpy", missing)] {
            let ground = format!("ground {position} {word}rpy(0, 0, 90) deg -> pin(z) shoulder");
            expect(route, &ground, &[(at, message)]);
        }
    }
    let output = "output = [1, 0, 0] m;";
    expect(output, "output = [1, 0, 0] m rpy(0, 0, 90) deg;", &[("rpy", missing)]);
    expect(output, "output = [1, 0, 0] m rotated rpy(0, 0, 90) deg;", &[("rotated", rotated)]);
}

#[test]
fn keywords_after_values_may_be_misspelt() {
    let meant =
        |word: &str, keyword: &str| format!("unknown word `{word}`; did you mean `{keyword}`?");
    for (vector, angle) in [("[1, 0, 0]", "30 deg"), ("[1, 0, 0] m", "rpy(0, 0, 90) deg")] {
        for word in ["turnd", "turend", "Turned"] {
            let output = format!("output = {vector} {word} {angle};");
            expect("output = [1, 0, 0] m;", &output, &[(word, &meant(word, "turned"))]);
        }
    }
    for inertia in ["diag(1, 1, 1) kg*m^2", "diag(1, 1, 1)", "3 kg*m^2", "3"] {
        for word in ["abuot", "abot"] {
            let inertia = format!("{inertia} {word} com");
            let message = meant(word, "about");
            expect("diag(0, 1/6, 1/6) kg*m^2 about com", &inertia, &[(word, &message)]);
        }
    }
    let route = "ground -> pin(z) shoulder";
    let ground = "ground turnd rpy(0, 0, 90) deg -> pin(z) shoulder";
    expect(route, ground, &[("turnd", &meant("turnd", "turned"))]);
}

#[test]
fn an_orientation_follows_a_position() {
    let message = "write a position before `turned`: zeros if the frame is only rotated";
    for turned in ["turned", "rotated", "turnd"] {
        for angle in ["30 deg", "-30 deg", "rpy(0, 0, 90) deg"] {
            let output = format!("output = {turned} {angle};");
            expect("output = [1, 0, 0] m;", &output, &[(turned, message)]);
        }
    }
    expect(
        "ground -> pin(z) shoulder",
        "ground at turned rpy(0, 0, 90) deg -> pin(z) shoulder",
        &[("turned", message)],
    );
}

#[test]
fn positions_of_the_ground_begin_with_at() {
    let message = "write `at` before the position: `ground at …`";
    for turned in ["", "turned rpy(0, 0, 90) deg"] {
        let ground = format!("ground [0, 0, 1] m {turned} -> pin(z) shoulder");
        expect("ground -> pin(z) shoulder", &ground, &[("[0, 0, 1]", message)]);
    }
}

#[test]
fn answers_of_other_programs_are_known() {
    let expect = |answers: &str, at: &str, message: &str| {
        expect_rods(&format!("answers = {answers}; ground -> pin j -> Rod rod;"), &[(at, message)]);
    };
    for (word, meant) in [
        ("rnea", "inverse_dynamics"),
        ("crba", "mass_matrix"),
        ("nonLinearEffects", "bias_efforts"),
        ("computeABADerivatives", "linearize"),
        ("centroidal_momentum", "momentum"),
        ("mass_matrix_times", "mass_matrix"),
    ] {
        expect(word, word, &format!("expected …, found `{word}`; did you mean `{meant}`?"));
    }
    expect("aba", "aba", "every chain has `accelerations`: remove `aba`");
    expect("[basic, energy]", "energy", "every chain has `energy`: remove `energy`");
    expect("[push pull]", "pull", "write `,` before `pull`");
    expect("push, pull", ",", "write several words in brackets: `[…, …]`");
    expect("[push m]", "m", "a keyword has no unit: …");
    expect("push m", "m", "a keyword has no unit: …");
}

#[test]
fn keywords_have_no_parentheses() {
    let of_answers = "a keyword has no parentheses: remove them";
    for answers in ["(basic)", "((basic))", "[(basic), push]"] {
        let at = answers.trim_start_matches('[').trim_end_matches(", push]");
        let chain = format!("answers = {answers}; ground -> pin j -> Rod rod;");
        expect_rods(&chain, &[(at, of_answers)]);
    }
    let several = "write several values in square brackets: `[…, …]`";
    expect_rods("answers = (basic, push); ground -> pin j -> Rod rod;", &[("(", several)]);
    expect_rods(
        "answers = {basic, push}; ground -> pin j -> Rod rod;",
        &[("{basic, push}", several)],
    );
    expect_rods("results = (z); ground -> pin j -> Rod rod;", &[("(z)", of_answers)]);
    let method = "expected `riccati` or `transfer`, found `(riccati)`";
    expect_rods("method = (riccati); ground -> pin j -> Rod rod;", &[("(riccati)", method)]);
    let input = "`input` cannot be part of a formula: write it as the whole value of a field";
    expect("torque = input", "torque = (input)", &[("input", input)]);
    // A number may have them.
    expect("mass = 2 kg", "mass = (ratio) kg", &[]);
    expect("mass = 2 kg", "mass = (payload)", &[]);
    expect("mass = 2 kg", "mass = -((payload)) + 2 kg", &[]);
}

/// All words that are known from elsewhere lead to words of the language.
#[test]
fn answers_that_are_meant_exist() {
    for (word, meant) in OTHER_ANSWERS {
        assert!(ANSWER_WORDS.iter().all(|(answer, _)| answer != word), "{word}");
        if let Foreign::Keyword(meant) = meant {
            assert!(ANSWER_WORDS.iter().any(|(answer, _)| answer == meant), "{word}");
        }
    }
}
