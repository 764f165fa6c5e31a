//! Errors in `shape`.

use super::{expect, expect_all};

/// Expects errors in the shape of a body.
#[track_caller]
fn expect_shape(shape: &str, errors: &[(&str, &str)]) {
    expect("mass = 2 kg;", &format!("mass = 2 kg; shape = {shape};"), errors);
}

#[test]
fn kinds_are_known() {
    let unknown = |word: &str, near: &str| {
        let message = format!("unknown shape `{word}`; did you mean `{near}`?");
        expect_shape(&format!("{word}(radius = 1)"), &[(word, &message)]);
    };
    for (word, near) in [
        ("spere", "sphere"),
        ("cilinder", "cylinder"),
        ("capsul", "capsule"),
        ("cube", "box"),
        ("ball", "sphere"),
        ("stl", "mesh"),
    ] {
        unknown(word, near);
    }
    let message = "unknown shape `torus`; there are `box`, `cylinder`, `capsule`, `sphere` and \
                   `mesh`";
    expect_shape("[box([1, 1, 1] m), torus(1)]", &[("torus", message)]);
    let expected = "expected a shape, such as `sphere(radius = 5 cm)`, found";
    expect_shape("5 m", &[("5", &format!("{expected} `5`"))]);
    expect_shape("\"tool.stl\"", &[("\"tool.stl\"", &format!("{expected} `\"tool.stl\"`"))]);
    expect_shape("sphere", &[(";", "expected `(`, found `;`")]);
}

#[test]
fn arguments_have_their_form() {
    let of_box = "write a box as `box([x, y, z] m)`";
    for arguments in ["(1 m, 2 m, 3 m)", "()", "(size = [1, 2, 3] m)", "([1, 2, 3], [1, 2, 3])"] {
        expect_shape(&format!("box{arguments}"), &[(arguments, of_box)]);
    }
    let components = "expected 3 components …, found 2; …";
    expect_shape("box([1, 2] m)", &[("[1, 2]", components)]);
    let of_sphere = "write a sphere as `sphere(radius = …)`";
    expect_shape("sphere(5 cm)", &[("(5 cm)", of_sphere)]);
    expect_shape("sphere(radius = \"5\")", &[("(radius = \"5\")", of_sphere)]);
    let of_cylinder = "write a cylinder as `cylinder(radius = …, length = …)`";
    expect_shape("cylinder(1, 2)", &[("(1, 2)", of_cylinder)]);
    for arguments in ["(tool)", "(\"\")", "(file = \"a\")", "(\"a\", \"b\")", "()"] {
        let of_mesh = "write a mesh as `mesh(\"file.stl\")`";
        expect_shape(&format!("mesh{arguments}"), &[(arguments, of_mesh)]);
    }
    expect_shape("mesh(wheel.stl)", &[("wheel", "write the name of a file in quotes")]);
}

#[test]
fn lengths_are_named_once() {
    let near = "a cylinder has no `lenght`; did you mean `length`?";
    expect_shape("cylinder(radius = 1, lenght = 2)", &[("lenght", near)]);
    expect_shape("sphere(length = 1)", &[("length", "a sphere has no `length`")]);
    let twice = "`radius` of the sphere is given twice";
    expect_shape(
        "sphere(radius = 1, r#radius = 2)",
        &[("r#radius", "a sphere has no `r#radius`…")],
    );
    expect_shape("sphere(radius = 1, radius = 2)", &[("radius", twice)]);
    expect_shape("capsule()", &[("capsule", "a capsule needs `radius` and `length`")]);
    expect_shape("capsule(length = 1)", &[("capsule", "a capsule needs `radius`")]);
}

#[test]
fn values_are_positive_lengths() {
    let mass = "expected a length, found a mass";
    expect_shape("sphere(radius = 1 kg)", &[("kg", mass)]);
    expect_shape("box([1, 1, 1] kg)", &[("kg", mass)]);
    expect_shape("box([1, 1, 1] m) at [1, 0, 0] kg", &[("kg", mass)]);
    let positive = "a length of a shape must be positive";
    expect_shape("box([1, -2, 3] m)", &[("-2", positive)]);
    expect_shape("capsule(radius = 1, length = 0)", &[("0", positive)]);
    expect_shape("sphere(radius = [1, 2])", &[("[1, 2]", "expected a length as a single …")]);
    expect_shape("sphere(radius = heft)", &[("heft", "unknown name `heft`; for a parameter …")]);
    // All shapes of a list are read.
    let list = "[sphere(radius = -1), sphere(radius = -2)]";
    expect_shape(list, &[("-1", positive), ("-2", positive)]);
}

#[test]
fn values_are_fixed() {
    let fixed = "a shape has fixed values: write numbers, not parameters or Rust constants";
    expect_shape("sphere(radius = ratio)", &[("ratio", fixed)]);
    expect_shape("sphere(radius = data::RADIUS)", &[("data::RADIUS", fixed)]);
    expect_shape("box([1, RADIUS, 1]) at [0, 0, 1]", &[("[1, RADIUS, 1]", fixed)]);
    expect_shape("sphere(radius = 1) at [0, 2*ratio, 0]", &[("[0, 2*ratio, 0]", fixed)]);
    let turned = "sphere(radius = 1) turned rpy(0, ratio, 0)";
    expect_shape(turned, &[("rpy(0, ratio, 0)", fixed)]);
    let part = |argument: &str| {
        format!(
            "chain A {{ param size = 1 m; {ROD} part Leg(length) {{ body Shank {{ mass = 1; com = \
             [1, 0, 0]; inertia = diag(1, 1, 1) about com; shape = capsule(radius = 1, length = \
             length); }} pin(x) a -> Shank shank; }} ground -> pin(x) b -> Rod rod -> Leg({argument}) \
             leg; }}"
        )
    };
    const ROD: &str = "body Rod { mass = 1; com = [1, 0, 0]; output = [1, 0, 0]; inertia = \
                       diag(1, 1, 1) about com; }";
    expect_all(&part("2 m"), &[]);
    expect_all(&part("size"), &[("length", &format!("{fixed}, in `Leg(size) leg`"))]);
    expect_all(&part("-2 m"), &[("length", "a length of a shape …, in `Leg(-2 m) leg`")]);
}

#[test]
fn places_are_in_the_dimension_or_in_space() {
    expect_shape(
        "sphere(radius = 1) turned 30 deg",
        &[("30 deg", "expected `rpy(…)` …, found a number")],
    );
    expect_shape(
        "sphere(radius = 1) rotated rpy(0, 0, 1)",
        &[("rotated", "unknown word `rotated`; did you mean `turned`?")],
    );
    let plane = |shape: &str| {
        format!(
            "plane chain A {{ body Rod {{ mass = 1; com = [1, 0]; inertia = 1 about com; shape = \
             {shape}; }} ground -> pin a -> Rod rod; }}"
        )
    };
    for place in ["at [1, 2]", "at [1, 2, 3]", "turned 1", "at [1, 2] turned rpy(0, 90, 0) deg"] {
        expect_all(&plane(&format!("sphere(radius = 1) {place}")), &[]);
    }
    expect_all(
        &plane("sphere(radius = 1) at [1]"),
        &[("[1]", "expected 2 components of a vector of a plane chain, found 1")],
    );
}

#[test]
fn several_shapes_are_in_brackets() {
    let several = "write several shapes in brackets: `[box(…), sphere(…)]`";
    let list = "box([1, 1, 1] m), sphere(radius = 1)";
    expect_shape(list, &[(",", several)]);
    expect_shape(&format!("[{list},]"), &[]);
    expect_shape("[]", &[("[", "expected a shape, … after this")]);
    let rest = "expected `,`, found `sphere`";
    expect_shape("[sphere(radius = 1) sphere(radius = 1)]", &[("sphere", rest)]);
}

#[test]
fn shapes_are_fields_of_body_types() {
    expect(
        "start = 30 deg;",
        "shape = sphere(radius = 1);",
        &[("shape", "a pin has no field `shape`; …")],
    );
    expect(
        "mass = 2 kg;",
        "mass = sphere(radius = 1);",
        &[("sphere(radius = 1)", "expected a mass, found a shape")],
    );
    let twice = "shape = sphere(radius = 1); shape = sphere(radius = 1);";
    expect(
        "mass = 2 kg;",
        &format!("mass = 2 kg; {twice}"),
        &[("shape", "`shape` of body `Rod` is given twice")],
    );
    expect(
        "mass = 2 kg;",
        "mass = 2 kg; visual = sphere(radius = 1);",
        &[("visual", "body `Rod` has no field `visual`; did you mean `shape`?")],
    );
    expect(
        "mass = 2 kg;",
        "mass = 2 kg; shapes = box([1, 1, 1] m);",
        &[("shapes", "body `Rod` has no field `shapes`; did you mean `shape`?")],
    );
    let after = "hinge wrist { start_rate = [0, 0.1, 0] rad/s; }";
    let block = format!("{after} body Rod {{ shape = sphere(radius = 1); }}");
    expect(after, &block, &[("Rod", "write the block of a body type …")]);
}
