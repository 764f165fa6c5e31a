//! Errors in bodies and in the properties of hinges.

use super::{each_error_once, expect};

#[test]
fn fields_that_are_missing_are_listed_together() {
    expect(
        "mass = 2 kg;\n            com = [0.5, 0, 0] m;",
        "",
        &[("Rod", "body `Rod` needs `mass` and `com`")],
    );
    expect("output = [1, 0, 0] m;", "", &[("Cube", "body `Cube` needs `output`")]);
    expect(
        "mass = 2 kg",
        "colour = 2 m/s",
        &[("Rod", "body `Rod` needs `mass`"), ("colour", "… no field `colour`; it has …")],
    );
    // What could be the mass is not missed beside.
    for field in ["colour = 2", "colour = 2 kg"] {
        let message = "… no field `colour`; it has …";
        expect("mass = 2 kg", field, &[("colour", message)]);
    }
    // One that could not be read is not missing.
    expect("mass = 2 kg", "mass = ?", &[("?", "expected a number, found `?`")]);
    expect("mass = 2 kg", "mass 2 kg", &[("2", "expected `=`, found `2`")]);
}

#[test]
fn a_missing_semicolon_costs_no_field() {
    expect("mass = 2 kg;", "mass = 2 kg", &[("kg", "expected `;` after this")]);
    expect("mass = 2 kg;", "mass = 2", &[("2", "expected `;` after this")]);
    let floats = "gravity = [0, 0, 0] m/s^2 Rod first -> pin j -> Rod last;";
    each_error_once::expect_rods(floats, &[("2", "expected `;` after this")]);
    expect("0.1, 0] rad/s;", "0.1, 0] rad/s", &[("s", "expected `;` after this")]);
}

#[test]
fn vectors_have_three_components() {
    let point = "expected a vector …, found `rod.tip`";
    expect("output = [1, 0, 0] m", "output = rod.tip", &[("rod.tip", point)]);
    let point = "expected a vector …, found a point of `rod`";
    expect("output = [1, 0, 0] m", "output = rod at tip", &[("rod at tip", point)]);
    expect(
        "output = [1, 0, 0] m",
        "output = 1 m",
        &[("1 m", "expected a vector …, found a number")],
    );
    expect(
        "[0, 0.1, 0] rad/s",
        "[0, 0.1, 0] rad/s turned rpy(0, 0, 1)",
        &[("rpy(0, 0, 1)", "a vector has no orientation: write only `[x, y, z]`")],
    );
}

#[test]
fn orientations_are_well_formed() {
    let output = "output = [1, 0, 0] m";
    let turned = |how: &str| format!("{output} turned {how}");
    let ways = "expected `rpy(roll, pitch, yaw)` or `quaternion(w, x, y, z)`";
    expect(
        output,
        &turned("rpz(0, 0, 1)"),
        &[("rpz", &format!("{ways}, found `rpz`; did you mean `rpy`?"))],
    );
    expect(
        output,
        &turned("rpy(0, 1)"),
        &[("(0, 1)", "expected `rpy(roll, pitch, yaw)`, found 2 numbers")],
    );
    expect(
        output,
        &turned("rpy(0, 0, 1) about com"),
        &[("com", "only an inertia has a reference point: remove `about …`")],
    );
    let unit = "the components of a quaternion have no unit; for angles write `rpy(…)`";
    expect(output, &turned("quaternion(1, 0, 0, 0) deg"), &[("deg", unit)]);
    expect(output, &turned("quaternion(1 rad, 0, 0, 1)"), &[("rad", unit)]);
    expect(output, &turned("quaternion((1 m)/(2 m), 0, 0, 1)"), &[]);
    let found = "expected `rpy(roll, pitch, yaw)` or `quaternion(w, x, y, z)`, found `[`";
    expect(output, &turned("[0, 0, 90] deg"), &[("[", found)]);
    let unknown = format!("{ways}, found `axis_angle`");
    expect(output, &turned("axis_angle([0, 0, 1], 90 deg)"), &[("axis_angle", &unknown)]);
    expect(output, &turned("90 deg"), &[("90 deg", &format!("{ways}, found a number"))]);
    expect(
        "start_rate = [0, 0.1, 0] rad/s",
        "start = 90 deg",
        &[("90 deg", &format!("{ways}, found a number"))],
    );
}

#[test]
fn masses_are_positive() {
    expect("mass = 2 kg", "mass = 0", &[("0", "a mass must be positive")]);
}

#[test]
fn inertias_are_well_formed() {
    let original = "diag(0, 1/6, 1/6) kg*m^2 about com";
    expect(
        original,
        "diag(0, 1/6, 1/6) kg*m^2 about con",
        &[("con", "expected `input` or `com`, found `con`; did you mean `com`?")],
    );
    let ways = "expected `diag(xx, yy, zz)`, `tensor(xx, yy, zz, xy, xz, yz)` or `matrix(…)`";
    expect(
        original,
        "tenser(1, 1, 1, 0, 0, 0) about com",
        &[("tenser", &format!("{ways}, found `tenser`; did you mean `tensor`?"))],
    );
    expect(original, "1 kg*m^2", &[("1 kg*m^2", &format!("{ways}, found a number"))]);
}

#[test]
fn inertias_are_physical() {
    let original = "diag(0, 1/6, 1/6) kg*m^2 about com";
    expect(
        original,
        "diag(1, -1, 1) kg*m^2 about com",
        &[("-1", "a moment of inertia cannot be negative")],
    );
    let message = "no real body has this inertia: …";
    expect(original, "diag(0, 1/6, 1/5) about com", &[("diag(0, 1/6, 1/5)", message)]);
    expect(
        original,
        "tensor(1, 1, 1, 0.6, 0, 0) about com",
        &[("tensor(1, 1, 1, 0.6, 0, 0)", message)],
    );
    let order = "`tensor` has the order xx, yy, zz, xy, xz, yz";
    let moments = "the principal moments are -0.348, 0.0681 and 0.38 kg*m^2";
    let unordered = "tensor(0.1, 0, 0, 0.2, 0, 0.3)";
    let message = format!("no real body … other two; {order}; in this order {moments}");
    expect(original, &format!("{unordered} about com"), &[(unordered, &message)]);
    let negative = format!("a moment of inertia cannot be negative; {order}");
    expect(original, "tensor(1, -1, 1, 0, 0, 0) about com", &[("-1", &negative)]);
    // A rod of 2 kg and 1 m has 2/3 kg m² about its end.
    expect(original, "diag(0, 2/3, 2/3) about input", &[]);
}

const PITCH: &str = "a pin has no field `pitch`; it has `start`, `start_rate`, `stiffness`, `damping`, `armature`, `friction`, `friction_speed`, `limits`, `limit_stiffness`, `limit_damping`, `torque`, `rest` and `motion`";

#[test]
fn properties_fit_their_owner() {
    expect(
        "start = 30 deg;",
        "start_velocity = [0, 0, 0];",
        &[("start_velocity", "a pin has no field `start_velocity`; did you mean `start_rate`?")],
    );
    expect(
        "hinge wrist {",
        "hinge wrst {",
        &[("wrst", "no hinge `wrst` on a route; did you mean `wrist`?")],
    );
    expect(
        "hinge wrist {",
        "body wrist {",
        &[("wrist", "`wrist` is a hinge: write `hinge wrist { … }`")],
    );
    // Shared by two hinges, reported once.
    expect(
        "hinge wrist {",
        "hinge shoulder, wrist { pitch = 1; torque = x; }\n hinge wrist {",
        &[
            ("pitch", PITCH),
            ("x", "unknown name `x`; …"),
            ("torque", "`torque` of a pin is given twice"),
        ],
    );
    expect("ball wrist", "weld wrist", &[("start_rate", "a weld has no field `start_rate`")]);
}

#[test]
fn parts_are_in_their_places() {
    expect(
        "hinge wrist {",
        "body Foo { mass = 1 kg; com = [0, 0, 0]; } hinge wrist {",
        &[("Foo", "write the block of a body type …")],
    );
    expect(
        "body Rod {",
        "body Rod, Stick {",
        &[(
            "Stick",
            "a block describes one body type: \
        write a block for each",
        )],
    );
}

#[test]
fn fields_end_with_semicolons() {
    let fields = "mass = 2 kg;
            com = [0.5, 0, 0] m;
            inertia = diag(0, 1/6, 1/6) kg*m^2 about com;";
    let message = "fields end with `;`";
    expect(fields, &fields.replace(';', ","), &[(",", message)]);
    expect(fields, fields.replace(';', ",").trim_end_matches(','), &[(",", message)]);
    expect(
        fields,
        &fields.replacen(';', ",", 1).replace("2 kg", "2 m"),
        &[("m", "expected a mass, found a length"), (",", message)],
    );
    // What is skipped may hold the fields that lack.
    expect(
        fields,
        "mass = 2 kg, com: [0.5, 0, 0] m, inertia: diag(0, 1/6, 1/6) kg*m^2 about com",
        &[(",", "expected `;`, found `,`")],
    );
}

#[test]
fn words_have_no_quotes() {
    let load = |load: &str| format!("load push {{ {load} }} hinge wrist {{");
    let quotes = "write it without quotes";
    let on = "on = \"rod\"; force = input;";
    expect("hinge wrist {", &load(on), &[("\"rod\"", quotes)]);
    expect("param ratio", "method = \"riccati\"; param ratio", &[("\"riccati\"", quotes)]);
    expect("pin(z)", "pin(\"z\")", &[("\"z\"", quotes)]);
    let nothing = "expected a value, found `;`";
    expect("hinge wrist {", &load("on = ; force = input;"), &[(";", nothing)]);
}

#[test]
fn fields_are_known_by_other_names() {
    let hint =
        |name: &str, meant: &str| format!("a pin has no field `{name}`; did you mean `{meant}`?");
    for (name, meant) in [
        ("start_velocity", "start_rate"),
        ("turning_stiffness", "stiffness"),
        ("angle", "start"),
        ("initial", "start"),
    ] {
        let field = format!("{name} = 30 deg;");
        expect("start = 30 deg;", &field, &[(name, &hint(name, meant))]);
    }
    expect("torque = input", "force = input", &[("force", &hint("force", "torque"))]);
    let given = "a pin has no field `force`; `torque` is given already";
    expect("start = 30 deg;", "force = 1;", &[("force", given)]);
    let gears = "a chain has no gears and mimic joints between two hinges: give both motors whose efforts hold the \
                 ratio; the rotor of a motor behind a gear is the `armature` of its hinge";
    for name in ["mimic", "gear_ratio"] {
        expect("start = 30 deg;", &format!("{name} = 2;"), &[(name, gears)]);
    }
    expect(
        "com = [0.5, 0, 0] m;\n            inertia",
        "centre = [0.5, 0, 0] m; inertia",
        &[("centre", "body `Rod` has no field `centre`; did you mean `com`?")],
    );
}

#[test]
fn inertias_in_rotated_axes_are_well_formed() {
    let original = "diag(0, 1/6, 1/6) kg*m^2 about com";
    let turned = |rest: &str| format!("diag(0, 1/6, 1/6) kg*m^2 {rest}");
    expect(original, &turned("about com turned rpy(0.1, 0, 0)"), &[]);
    expect(original, &turned("about com turned quaternion(1, ratio, 0, 0)"), &[]);
    let before = "write `about com` before `turned`";
    expect(original, &turned("turned rpy(0.1, 0, 0) about com"), &[("com", before)]);
    let point = "an inertia needs a reference point: …";
    expect(original, &turned("turned rpy(0.1, 0, 0)"), &[("diag", point)]);
    let missing = "write `turned` before an orientation: `turned rpy(…)`";
    expect(original, &turned("about com rpy(0.1, 0, 0)"), &[("rpy", missing)]);
    let unreal = "no real body has this inertia: …";
    let long = "diag(1, 1, 3) kg*m^2 about com turned rpy(0.3, 0.4, 0.5)";
    expect(original, long, &[(long, unreal)]);
}

#[test]
fn matrices_of_inertia_are_symmetric() {
    let original = "diag(0, 1/6, 1/6) kg*m^2 about com";
    let matrix = |rows: &str| format!("matrix({rows}) kg*m^2 about com");
    let good = "[1, 0.1, 0.2], [0.1, 1, 0.3], [0.2, 0.3, 1]";
    expect(original, &matrix(good), &[]);
    expect(original, &matrix(&good.replace("[0.1", "[0.10000000001")), &[]);
    expect(
        original,
        &matrix(&good.replace("[0.1", "[0.100001").replace("0.3, 1]", "0.4, 1]")),
        &[
            ("0.100001", "an inertia is symmetric: `yx` must equal `xy`"),
            ("0.4", "an inertia is symmetric: `zy` must equal `yz`"),
        ],
    );
    // Formulas are compared as they are.
    let ratio = |other: &str| matrix(&format!("[1, ratio/9, 0], [{other}, 1, 0], [0, 0, 1]"));
    expect(original, &ratio("ratio/9"), &[]);
    expect(original, &ratio("0.2"), &[("0.2", "an inertia is symmetric: `yx` must equal `xy`")]);
    let shape = "write a matrix as `matrix([xx, xy, xz], [yx, yy, yz], [zx, zy, zz])`";
    expect(original, &matrix("[1, 0, 0], [0, 1]"), &[("[0, 1]", shape)]);
    expect(original, &matrix("[1, 0, 0], [0, 1, 0]"), &[("([1, 0, 0], [0, 1, 0])", shape)]);
    expect(original, "[[1, 0, 0], [0, 1, 0], [0, 0, 1]] about com", &[("[", shape)]);
    let nested = "[[1, 0, 0], [0, 1, 0], [0, 0, 1]]";
    expect(original, &matrix(nested), &[(nested, shape)]);
    let list = "write all numbers in one list, without brackets inside it";
    expect(original, "diag([1, 1, 1]) about com", &[("[1, 1, 1]", list)]);
    expect(
        original,
        &matrix("[1, 0, 0], [0, -1, 0], [0, 0, 1]"),
        &[("-1", "a moment of inertia cannot be negative")],
    );
    let round = "write an inertia as `diag(xx, yy, zz)`, with round parentheses";
    expect(original, "[0, 1, 1] kg*m^2 about com", &[("[", round)]);
    expect(
        original,
        "tensor[1, 1, 1, 0, 0, 0] about com",
        &[("[1, 1, 1, 0, 0, 0]", "write `tensor(…)`, with round parentheses")],
    );
}
