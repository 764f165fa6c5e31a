//! A error is reported once, and hides no other one.

use super::{errors_in, expect_all};

const ROD: &str = "body Rod { mass = 1 kg; com = [0.5, 0, 0] m; output = [1, 0, 0] m; \
                   inertia = diag(0, 1/6, 1/6) kg*m^2 about com; } ";

/// What is said where an item is unknown.
pub(super) const ITEMS: &str = "; the items are `gravity`, `method`, `results`, `answers`, \
                                `param`, `body`, `part`, the routes, `hinge`, `load` and `spring`";

/// A chain of rods with this written behind their description.
#[track_caller]
pub(super) fn expect_rods(items: &str, errors: &[(&str, &str)]) {
    expect_all(&format!("chain A {{ {ROD} {items} }}"), errors);
}

/// Reads a rod on a hinge of this kind with these properties.
#[track_caller]
pub(super) fn expect_hinge(kind: &str, fields: &str, errors: &[(&str, &str)]) {
    expect_rods(&format!("ground -> {kind} j -> Rod rod; hinge j {{ {fields} }}"), errors);
}

/// The parameter `p` as the mass of a body.
#[track_caller]
fn expect_parameter(rest: &str, errors: &[(&str, &str)]) {
    let body = "body Bar { mass = p; com = [0, 0, 0]; inertia = diag(1, 1, 1) about com; }";
    expect_all(&format!("chain A {{ param p{rest}; {body} ground -> pin j -> Bar; }}"), errors);
}

#[test]
fn every_field_of_a_hinge_is_judged_on_its_own() {
    let negative = ("-1", "a stiffness cannot be negative");
    let found = "expected an angle, found a mass";
    expect_hinge("pin", "start = 1 kg; stiffness = -1;", &[("kg", found), negative]);
    expect_hinge("pin", "rest = 1 kg; stiffness = -1;", &[("kg", found), negative]);
    expect_hinge(
        "cylindrical",
        "stiffness = 1 kg; damping = -2; turning_stiffness = -1;",
        &[
            ("kg", "expected a stiffness, `N/m`, found a mass"),
            ("-2", "a damping cannot be negative"),
            negative,
        ],
    );
    expect_hinge(
        "pin",
        "torque = 1 kg; motion = 3; limits = 1; limit_stiffness = 0; limit_damping = -1;",
        &[
            ("kg", "expected a torque, found a mass"),
            ("3", "expected `motion = input`, …"),
            ("1", "expected two limits `[lowest, highest]`, found a number"),
            ("0", "the limit stiffness must be positive"),
            ("-1", "a damping cannot be negative"),
        ],
    );
}

#[test]
fn a_missing_field_hides_no_wrong_one() {
    expect_hinge(
        "pin",
        "limits = [3, 1]; friction = -1;",
        &[
            ("limits", "`limits` needs `limit_stiffness` as well, …"),
            ("[3, 1]", "… must be less than the second"),
            ("friction", "`friction` needs `friction_speed` as well, …"),
            ("-1", "friction cannot be negative"),
        ],
    );
    expect_hinge(
        "pin",
        "limit_stiffness = -2; friction_speed = -1;",
        &[
            ("limit_stiffness", "`limit_stiffness` needs `limits` as well"),
            ("-2", "the limit stiffness must be positive"),
            ("friction_speed", "`friction_speed` needs `friction` as well"),
            ("-1", "the friction speed must be positive"),
        ],
    );
}

#[test]
fn a_parameter_without_a_default_is_not_judged() {
    expect_parameter(" = 1 furlong", &[("furlong", "unknown unit `furlong`")]);
    expect_parameter(" = 1e999", &[("1e999", "this is not a finite number")]);
    expect_parameter(" 1", &[("1", "expected `=`, found `1`")]);
    let default = "a parameter needs a default with its unit: `param p = 1 kg;`";
    expect_parameter("", &[("p", default)]);
    expect_parameter(
        " = 0",
        &[("p", "a mass must be positive; with its parameters' defaults it is 0 kg")],
    );
}

#[test]
fn a_route_without_a_body_is_one_error() {
    let message = "the route has no body: …";
    expect_rods("ground;", &[("ground", message)]);
    expect_rods("ground -> pin(z) j;", &[("ground", message)]);
    expect_rods("ground -> pin a -> pin b -> ground;", &[("ground", message)]);
    expect_rods("repeat 10 { pin j };", &[("j", message)]);
    let nested = "`repeat` blocks cannot be nested";
    expect_rods("ground -> repeat 2 { repeat 2 { pin j -> Rod rod } };", &[("repeat", nested)]);
}

#[test]
fn chains_have_types_of_their_own() {
    let chain = |name: &str| format!("chain {name} {{ {ROD} ground -> pin j -> Rod rod; }} ");
    let expect = |first: &str, second: &str, message: &str| {
        expect_all(&[chain(first), chain(second)].concat(), &[(second, message)]);
    };
    expect("A", "A", "two chains have the name `A`");
    expect("AState", "A", "chains `AState` and `A` both have a type `AState`");
    expect("A", "AWorkspace", "chains `A` and `AWorkspace` both have a type `AWorkspace`");
    // Types that only answers add.
    let asking = chain("A").replace("{ body", "{ answers = basic; body");
    let message = "chains `A` and `AKinematics` both have a type `AKinematics`";
    expect_all(&[asking, chain("AKinematics")].concat(), &[("AKinematics", message)]);
    let asking = chain("A").replace("{ body", "{ answers = [mass_matrix, push]; body");
    let message = "chains `A` and `AVariation` both have a type `AVariation`";
    expect_all(&[&asking, &*chain("AVariation")].concat(), &[("AVariation", message)]);
    expect_all(&[&asking, &*chain("AKinematics"), &chain("ALinearization")].concat(), &[]);
    expect_all(&[chain("A"), chain("AKinematics")].concat(), &[]);
    expect_all(&[chain("A"), chain("B")].concat(), &[]);
}

#[test]
fn methods_have_names_of_their_own() {
    let both = "`set_each_j` and `j` both make the method `set_each_j`: rename one";
    expect_rods(
        "ground -> repeat 3 { pin j -> Rod rod } -> pin set_each_j -> Rod b;",
        &[("set_each_j", both)],
    );
    let both = "`j` and `set_each_j` both make the method `set_each_j`: rename one";
    expect_rods(
        "ground -> pin set_each_j -> Rod b -> repeat 3 { pin j -> Rod rod };",
        &[("j", both)],
    );
    expect_rods("ground -> pin set_each_j -> Rod rod -> pin j -> Rod b;", &[]);
}

#[test]
fn many_errors_are_counted() {
    let bodies: String = (0..1000).map(|k| format!(" -> pin h{k} -> Rod r{k}")).collect();
    let blocks: String = (0..1000).map(|k| format!(" hinge k{k} {{ start = 1; }}")).collect();
    let found = errors_in(&format!("chain A {{ {ROD} ground {bodies}; {blocks} }}"));
    assert_eq!(found.len(), 101);
    assert_eq!(found[99].1, "no hinge `k99` on a route; did you mean `h99`?");
    assert_eq!(found[100].1, "… and 900 more errors");
}
