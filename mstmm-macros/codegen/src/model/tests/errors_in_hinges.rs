//! Errors in kinds and properties of hinges.

use super::{expect, expect_all};

/// Another kind of hinge with other properties in the place of the example's ball.
#[track_caller]
fn expect_hinge(kind: &str, properties: &str, errors: &[(&str, &str)]) {
    let source = super::edited(&[
        ("ball wrist", &format!("{kind} wrist")),
        ("start_rate = [0, 0.1, 0] rad/s;", properties),
    ]);
    expect_all(&source, errors);
}

#[test]
fn parentheses_contain_what_a_kind_needs() {
    expect_hinge("slider(x, y)", "", &[("(x, y)", "a slider has one axis, such as `slider(x)`")]);
    expect_hinge(
        "pin(0, 1, 0)",
        "",
        &[("(0, 1, 0)", "write an axis in brackets: `pin([0, 1, 0])`")],
    );
    expect_hinge("slider(0.6, 0, -0.8)", "", &[("(0.6, 0, -0.8)", "… `slider([0.6, 0, -0.8])`")]);
    expect_hinge("cylindrical(0, 1, 1)", "", &[("(0, 1, 1)", "… `cylindrical([0, 1, 1])`")]);
    expect_hinge(
        "screw(x, y, z)",
        "",
        &[("(x, y, z)", "a screw has an axis and a pitch, such as `screw(z, 5 mm/rev)`")],
    );
    expect_hinge(
        "screw(w, 5 s)",
        "",
        &[("w", "expected an axis: … or `[a, b, c]`"), ("s", "expected a pitch, found a time")],
    );
    expect_hinge(
        "screw(x)",
        "",
        &[(
            "x",
            "`screw` needs a pitch as well: write `screw(z, 5 \
                                          mm/rev)`",
        )],
    );
    expect_hinge("screw(5 mm/rev, x)", "", &[("x", "the axis comes first: `screw(z, 5 mm/rev)`")]);
    expect_hinge(
        "cylindrical()",
        "",
        &[("()", "a cylindrical hinge has one axis, such as `cylindrical(z)`")],
    );
    expect_hinge(
        "planar(x, y)",
        "",
        &[("(x, y)", "a planar hinge has one normal, such as `planar(z)`")],
    );
    expect_hinge(
        "floating(x)",
        "",
        &[(
            "(x)",
            "`floating` has no arguments: remove the \
                                               parentheses",
        )],
    );
    expect_hinge(
        "elastic(x)",
        "",
        &[("(x)", "`elastic` has no arguments: remove the parentheses")],
    );
}

#[test]
fn axes_have_directions_of_their_own() {
    expect_hinge("screw([0, 0, 0], 1)", "", &[("[0, 0, 0]", "an axis of zeros has no direction")]);
    expect_hinge(
        "universal(x, [0, 0, 0])",
        "",
        &[("[0, 0, 0]", "an axis of zeros has no direction")],
    );
    let message = "… must not be parallel";
    expect_hinge("universal(x, -x)", "", &[("-x", message)]);
    let by_default = format!("{message}, with its parameters' defaults");
    expect_hinge("universal(x, [ratio, 0, 0])", "", &[("[ratio, 0, 0]", &by_default)]);
    expect_hinge("universal(x, [1e-200, 1e-200, 0])", "", &[]);
    expect_hinge("gimbal(x, -x, z)", "", &[("-x", message)]);
    expect_hinge("gimbal(x, z, [0, 0, 2])", "", &[("[0, 0, 2]", message)]);
    expect_hinge("gimbal(x, z, x)", "", &[]);
    let three = "a gimbal has three axes, …";
    expect_hinge("gimbal(x, y)", "", &[("(x, y)", three)]);
    let bounds =
        "the length of an axis must be between 1e-15 and 1e15, with its parameters' defaults";
    for axis in ["[ratio * 1e200, 0, 0]", "[ratio * 1e20, 1, 0]", "[ratio * 1e-16, 0, 0]"] {
        expect_hinge(&format!("pin({axis})"), "", &[(axis, bounds)]);
    }
    let infinite = "… with its parameters' defaults it is inf";
    expect_hinge("screw(z, 1 / (ratio - 2))", "", &[("1 / (ratio - 2)", infinite)]);
}

#[test]
fn fields_fit_their_group() {
    expect_hinge(
        "pin",
        "turning_damping = 1;",
        &[("turning_damping", "a pin has no field `turning_damping`; did you mean `damping`?")],
    );
    expect_hinge(
        "slider",
        "damping = 1 N*m*s/rad;",
        &[("N*m*s/rad", "expected a damping, `N*s/m`, found a rotational damping")],
    );
    expect_hinge(
        "pin",
        "stiffness = 1 N/m;",
        &[("N/m", "expected a rotational stiffness, `N*m/rad`, found a stiffness")],
    );
    expect_hinge(
        "ball",
        "stiffness = [1, 2, 3];",
        &[("[1, 2, 3]", "expected a rotational stiffness as a single number, found a vector")],
    );
    expect_hinge("universal", "start = 3;", &[("3", "expected a vector …, found a number")]);
    expect_hinge(
        "universal",
        "start = [1, 2, 3];",
        &[("[1, 2, 3]", "expected 2 numbers `[a, b]`, found 3")],
    );
    expect_hinge(
        "planar",
        "stiffness = [1, 2, 3];",
        &[("[1, 2, 3]", "expected 2 numbers `[a, b]`, found 3")],
    );
    expect_hinge(
        "pin",
        "start = 1 turned 2;",
        &[("1 turned 2", "expected an angle, found a rotated frame")],
    );
    expect_hinge(
        "elastic",
        "start = [0, 0, 0] m turned quaternion(1, 0, 0, 0);",
        &[(
            "quaternion(1, 0, 0, 0)",
            "the rotation of an elastic hinge is given by angles: write `rpy(roll, pitch, yaw)`",
        )],
    );
}

#[test]
fn limits_fit_their_group() {
    expect_hinge(
        "pin",
        "limits = 3; limit_stiffness = 1;",
        &[("3", "expected two limits `[lowest, highest]`, found a number")],
    );
    expect_hinge(
        "planar",
        "limits = [[0, 1], [1, 2]]; limit_stiffness = 1;",
        &[("[", "expected numbers in these brackets, found a list")],
    );
    expect_hinge(
        "ball",
        "limits = [1, 2]; limit_stiffness = 1;",
        &[("[1, 2]", "expected an angle as a single number, found a vector")],
    );
}

#[test]
fn friction_and_limits_are_complete() {
    expect_hinge(
        "pin",
        "friction_speed = 1;",
        &[("friction_speed", "`friction_speed` needs `friction` as well")],
    );
    expect_hinge(
        "floating",
        "turning_limits = 1;",
        &[(
            "turning_limits",
            "`turning_limits` needs `turning_limit_stiffness` as well, such as `turning_limit_stiffness = 100 N*m/deg`",
        )],
    );
    expect_hinge(
        "ball",
        "limit_damping = 1;",
        &[("limit_damping", "`limit_damping` needs `limits` as well")],
    );
    expect_hinge(
        "slider",
        "friction = 1; limits = [0, 1];",
        &[
            ("friction", "`friction` needs `friction_speed` as well, … = 1 mm/s`"),
            ("limits", "`limits` needs `limit_stiffness` as well, … = 100 N/mm`"),
        ],
    );
    // A misspelt one is not missed.
    expect_hinge(
        "pin",
        "friction = 1; friction_sped = 1;",
        &[("friction_sped", "a pin has no field `friction_sped`; did you mean `friction_speed`?")],
    );
}

/// Some effort depends on the position at rest: a spring, or the limits of a quaternion.
#[test]
fn rest_positions_have_springs() {
    let expect_rest = |kind: &str, rest: &str, more: &str, needed: Option<&str>| {
        let of_wrist = |needed| format!("`rest` of hinge `wrist` needs {needed} as well; …");
        let message = needed.map(of_wrist);
        let errors: Vec<_> = message.iter().map(|message| ("rest", message.as_str())).collect();
        expect_hinge(kind, &format!("rest = {rest}; {more}"), &errors);
    };
    let limits = "limits = [-1, 1]; limit_stiffness = 1; damping = 1;";
    for kind in ["pin", "slider", "screw(z, 5 mm/rev)"] {
        expect_rest(kind, "0", "start = 1;", Some("`stiffness`"));
        expect_rest(kind, "1", limits, Some("`stiffness`"));
        expect_rest(kind, "1", "stiffness = 0;", None);
        expect_rest(kind, "ratio", "stiffness = ratio;", None);
    }
    expect_rest("universal", "[1, 2]", "motion = input;", Some("`stiffness`"));
    expect_rest("universal", "[1, 2]", "motion = input; stiffness = [0, 1];", None);
    let both = Some("one of `stiffness` and `turning_stiffness`");
    let forms = [
        ("cylindrical", "1 m turned 30 deg"),
        ("planar", "[1, 2] m turned 30 deg"),
        ("elastic", "[1, 2, 3] m turned rpy(1, 1, 1)"),
    ];
    for (kind, rest) in forms {
        expect_rest(kind, rest, limits, both);
        expect_rest(kind, rest, "turning_limits = [-1, 1]; turning_limit_stiffness = 1;", both);
        expect_rest(kind, rest, "stiffness = 1;", None);
        expect_rest(kind, rest, "turning_stiffness = 1;", None);
    }
    // The limits of a quaternion are an angle from rest.
    let limits = "limits = 1; limit_stiffness = 1;";
    expect_rest("ball", "rpy(1, 0, 0)", "", Some("one of `stiffness` and `limits`"));
    expect_rest("ball", "rpy(1, 0, 0)", limits, None);
    expect_rest("ball", "rpy(1, 0, 0)", "stiffness = 1;", None);
    let floating = Some("one of `stiffness`, `turning_stiffness` and `turning_limits`");
    let rest = "[1, 2, 3] m turned rpy(1, 0, 0)";
    expect_rest("floating", rest, "limits = [-1, 1]; limit_stiffness = 1;", floating);
    expect_rest("floating", rest, "turning_limits = 1; turning_limit_stiffness = 1;", None);
    // A misspelt stiffness is not missed.
    expect_hinge(
        "pin",
        "rest = 1; stifness = 1;",
        &[("stifness", "a pin has no field `stifness`; did you mean `stiffness`?")],
    );
}

/// A block for several hinges is complete if each of them is.
#[test]
fn rest_positions_of_several_hinges_have_springs() {
    let blocks = |blocks: &str| format!("{blocks} hinge wrist {{");
    let message = |hinge| format!("`rest` of hinge `{hinge}` needs …");
    let expect_blocks = |text: &str, errors: &[(&str, &str)]| {
        expect("hinge wrist {", &blocks(text), errors);
    };
    let wrist = "hinge wrist { rest = rpy(1, 0, 0); }";
    expect_blocks(&format!("{wrist} hinge wrist, shoulder {{ stiffness = 1; }}"), &[]);
    expect_blocks(
        &format!("{wrist} hinge shoulder {{ stiffness = 1; rest = 1; }}"),
        &[("rest", &message("wrist"))],
    );
    let pins = |blocks: &str| {
        format!(
            "chain A {{ body Rod {{ mass = 1; com = [1, 0, 0]; output = [1, 0, 0]; \
             inertia = diag(1, 1, 1) about com; }} ground -> pin a -> Rod one -> repeat 2 {{ \
             pin b -> Rod two; }}; {blocks} }}"
        )
    };
    let both = "hinge a, b { rest = 1; }";
    expect_all(&pins(&format!("{both} hinge a, b {{ stiffness = 1; }}")), &[]);
    expect_all(
        &pins(&format!("{both} hinge a {{ stiffness = 1; }} hinge b {{ stiffness = 2; }}")),
        &[],
    );
    // The first hinge without a spring is named; there is one error on the token.
    expect_all(&pins(both), &[("rest", &message("a"))]);
    expect_all(&pins(&format!("{both} hinge a {{ stiffness = 1; }}")), &[("rest", &message("b"))]);
    // A block outside of a part completes one inside, of each instance.
    let legs = |of_knee: &str, blocks: &str| {
        format!(
            "chain A {{ body Rod {{ mass = 1; com = [1, 0, 0]; output = [1, 0, 0]; \
             inertia = diag(1, 1, 1) about com; }} part Leg {{ pin knee -> Rod shank; \
             hinge knee {{ {of_knee} }} }} ground -> Leg r -> Leg l; {blocks} }}"
        )
    };
    expect_all(&legs("rest = 1; stiffness = 1;", ""), &[]);
    expect_all(&legs("rest = 1;", "hinge r.knee, l.knee { stiffness = 1; }"), &[]);
    expect_all(&legs("stiffness = 1;", "hinge r.knee { rest = 1; }"), &[]);
    expect_all(
        &legs("rest = 1;", "hinge r.knee { stiffness = 1; }"),
        &[("rest", &message("l.knee"))],
    );
    expect_all(
        &legs("damping = 1;", "hinge l.knee { rest = 1; }"),
        &[("rest", &message("l.knee"))],
    );
}

#[test]
fn rotations_of_a_hinge_with_translations_have_other_fields() {
    for (field, value, at, message) in [
        ("damping", "1 N*m*s/rad", "N*m*s/rad", "a damping, `N*s/m`, found a rotational damping"),
        ("armature", "1 kg*m^2", "kg*m^2", "a mass, found a moment of inertia"),
    ] {
        let message = format!("expected {message}; for the rotation write `turning_{field}`");
        expect_hinge("cylindrical", &format!("{field} = {value};"), &[(at, &message)]);
    }
    let limits = "limits = [-1, 1] rad; limit_stiffness = 1 N*m/rad;";
    let message = "expected …; for the rotation write `turning_limits`";
    let stiffness = "expected …; for the rotation write `turning_limit_stiffness`";
    expect_hinge("cylindrical", limits, &[("rad", message), ("N*m/rad", stiffness)]);
    expect_hinge("slider", "damping = 1 N*m*s/rad;", &[("N*m*s/rad", "… a rotational damping")]);
}

#[test]
fn passive_numbers_give_no_energy() {
    expect_hinge(
        "elastic",
        "damping = [1, -2, 3]; turning_damping = -1;",
        &[("-2", "a damping cannot be negative"), ("-1", "a damping cannot be negative")],
    );
    expect_hinge("ball", "armature = -1;", &[("-1", "an armature cannot be negative")]);
    expect_hinge(
        "pin",
        "friction = -1; friction_speed = 0;",
        &[("-1", "friction cannot be negative"), ("0", "the friction speed must be positive")],
    );
    expect_hinge(
        "pin",
        "limits = [2, 1]; limit_stiffness = 0; limit_damping = -1;",
        &[
            ("[2, 1]", "… must be less than the second"),
            ("0", "the limit stiffness must be positive"),
            ("-1", "a damping cannot be negative"),
        ],
    );
    expect_hinge(
        "ball",
        "limits = -1; limit_stiffness = 1;",
        &[("-1", "the largest angle must be positive")],
    );
    let never = "this angle is never larger than 180 deg: a larger limit has no effect; a number without a unit is in rad";
    for (kind, field) in [("ball", "limits"), ("floating", "turning_limits")] {
        let limits = |angle: &str| {
            let stiffness = field.replace("limits", "limit_stiffness");
            format!("{field} = {angle}; {stiffness} = 1;")
        };
        expect_hinge(kind, &limits("180 deg"), &[]);
        expect_hinge(kind, &limits("181 deg"), &[("181 deg", never)]);
        expect_hinge(kind, &limits("1 rev"), &[("1 rev", never)]);
    }
    expect_hinge(
        "pin",
        "damping = 1 - ratio;",
        &[("1 - ratio", "a damping cannot be negative; …")],
    );
    // Shared by two hinges, reported once.
    expect(
        "hinge wrist {",
        "hinge shoulder, wrist { damping = -1; friction = 2; } hinge wrist {",
        &[
            ("-1", "a damping cannot be negative"),
            ("friction", "`friction` needs `friction_speed` as well, … = 0.01 rad/s`"),
        ],
    );
}

#[test]
fn a_prescribed_motion_excludes_other_drives() {
    let message = |name: &str| {
        format!(
            "`{name}` has no effect: `motion = input` prescribes the motion of \
                              this hinge"
        )
    };
    expect_hinge(
        "ball",
        "motion = input; torque = [1, 0, 0]; start_rate = [1, 0, 0];",
        &[("torque", &message("torque")), ("start_rate", &message("start_rate"))],
    );
    expect_hinge("slider", "motion = input; start = 1;", &[("start", &message("start"))]);
    expect_hinge("slider", "motion = 3;", &[("3", "expected `motion = input`, …")]);
    expect_hinge("weld", "motion = input;", &[("motion", "a weld has no field `motion`")]);
}

#[test]
fn elastic_hinges_have_no_right_angle() {
    let message = "the pitch angle of an elastic hinge …";
    expect_hinge("elastic", "start = [0, 0, 0] m turned rpy(0, 90, 0) deg;", &[("90", message)]);
    expect_hinge(
        "elastic",
        "rest = [0, 0, 0] m turned rpy(0, -ratio, 500); turning_stiffness = 1;",
        &[("-ratio", &format!("{message}, with its parameters' defaults"))],
    );
    expect_hinge("elastic", "start = [0, 0, 0] m turned rpy(200, 80, 500) deg;", &[]);
}
