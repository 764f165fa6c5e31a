//! Chains as URDF files: the round trip gives the same text, and what URDF cannot have is refused by name.

use cargo_mstmm::export::select;
use cargo_mstmm::import::{Options, import};
use cargo_mstmm::source::Source;
use mstmm_codegen::model::{Chain, Geometry};
use std::path::Path;

/// Exports a chain of a text.
fn export(text: &str, name: Option<&str>) -> Result<String, Vec<String>> {
    let (checked, messages) = Source::new("text", text).check();
    if !messages.is_empty() {
        return Err(messages.iter().map(|message| message.message.clone()).collect());
    }
    let chains: Vec<&Chain> = checked.iter().map(|checked| &checked.chain).collect();
    cargo_mstmm::export::export(select(&chains, name).map_err(|reason| vec![reason])?)
}

/// Returns the tokens of a text, without its comments.
fn tokens(text: &str) -> String {
    text.parse::<proc_macro2::TokenStream>().expect("tokens").to_string()
}

#[test]
fn the_round_trip_gives_the_same_text() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/urdf");
    let mut count = 0;
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        // Those files that become a chain.
        if path.extension().is_none_or(|extension| extension != "chain") {
            continue;
        }
        let text = std::fs::read_to_string(&path).unwrap();
        let urdf =
            export(&text, None).unwrap_or_else(|reasons| panic!("{}: {reasons:?}", path.display()));
        let options =
            Options { floating: !urdf.contains("\"ground\""), strict: true, ..Options::default() };
        let again = import(&urdf, &options)
            .unwrap_or_else(|error| panic!("{}: {error}\n{urdf}", path.display()));
        assert_eq!(
            tokens(&text),
            tokens(&again.text),
            "{}\n{urdf}\n{}",
            path.display(),
            again.text
        );
        count += 1;
    }
    assert!(count > 6, "{count}");
}

const BODY: &str = "body Rod { mass = 2 kg; com = [0.5, 0, 0] m; output = [1, 0, 0] m; \
                    inertia = diag(0.1, 0.8, 0.8) kg*m^2 about input; }";

/// A chain of rods with a part and a repetition, an inertia about the input and a parameter.
#[test]
fn what_urdf_has_is_written_out() {
    let text = format!(
        "chain Rods {{ param reach = 0.25 m; {BODY}
         body Tip {{ mass = 1 kg; com = [reach, 0, 0]; inertia = diag(1, 1, 1) kg*m^2 about com; }}
         ground at [0, 0, 1] m -> pin(y) a -> Rod first -> repeat 2 {{ weld w -> Rod rod }} -> slider b -> Tip tip;
         hinge a {{ limits = [-90, 90] deg; limit_stiffness = 20 N*m/deg; friction = 0.1 N*m; friction_speed = 1 rpm; }} }}"
    );
    let urdf = export(&text, None).expect("a file");
    // About the centre of mass 0.8 − 2 · 0.5² = 0.3 remains.
    let parts = [
        "<robot name=\"Rods\">",
        "<inertia ixx=\"0.1\" ixy=\"0\" ixz=\"0\" iyy=\"0.30000000000000004\" iyz=\"0\" izz=\"0.30000000000000004\"/>",
        "<limit lower=\"-1.5707963267948966\" upper=\"1.5707963267948966\" effort=\"20\" velocity=\"1e9\"/>",
        "<limit lower=\"-1e9\" upper=\"1e9\" effort=\"1e9\" velocity=\"1e9\"/>",
        "<!-- URDF requires effort and velocity of a limit, which a chain does not have: 1e9 is no limit,",
        "<dynamics damping=\"0\" friction=\"0.1\"/>",
        "<origin xyz=\"0.25 0 0\"/>",
        "<link name=\"rod2\">",
    ];
    for part in parts {
        assert!(urdf.contains(part), "{part} is not in\n{urdf}");
    }
    let imported = import(&urdf, &Options::default()).expect("a chain");
    assert!(imported.text.contains("mass = 6 kg;"), "{}", imported.text);
}

/// Returns a file with a link that moves by a joint with limits.
fn limited(name: &str, kind: &str, effort: &str) -> String {
    format!(
        "<robot name=\"{name}\"><link name=\"base\"/><link name=\"rod\"><inertial><mass value=\"1\"/>
         <inertia ixx=\"1\" ixy=\"0\" ixz=\"0\" iyy=\"1\" iyz=\"0\" izz=\"1\"/></inertial></link>
         <joint name=\"turn\" type=\"{kind}\"><parent link=\"base\"/><child link=\"rod\"/><axis xyz=\"0 0 1\"/>
         <limit lower=\"-1\" upper=\"1\" effort=\"{effort}\" velocity=\"1\"/></joint></robot>"
    )
}

#[test]
fn names_and_efforts_survive_a_round_trip() {
    let mut files = Vec::new();
    for name in ["t", "T", "State", "self", "a_b_c", "t_2", "Trobot", "TRobot", "", "7up"] {
        files.push(limited(name, "revolute", "2"));
    }
    for effort in ["5.689773361501515", "9.930923443847735", "0.1", "3.0000000000000004"] {
        files.push(limited("r", "revolute", effort));
        files.push(limited("r", "prismatic", effort));
    }
    for file in files {
        let first = import(&file, &Options::default()).expect("a chain").text;
        let urdf = export(&first, None).expect("a file");
        let second = import(&urdf, &Options::default()).expect("a chain").text;
        assert_eq!(tokens(&first), tokens(&second), "{file}\n{urdf}");
    }
}

/// Each repetition has a number in its names. A search from 2 for each took 76 s for half as many.
#[test]
fn long_repetitions_are_written_out_quickly() {
    let text = format!("chain Rods {{ {BODY} ground -> repeat 2000 {{ pin a -> Rod rod }}; }}");
    let urdf = export(&text, None).expect("a file");
    for name in ["rod", "rod2", "rod2000", "a2000"] {
        assert!(urdf.contains(&format!(" name=\"{name}\"")), "{name}");
    }
}

/// URDF requires unit vectors; digits of axes that are rounded stay.
#[test]
fn axes_have_unit_length() {
    for (axis, expected) in [
        ("[0, 7, 0]", "0 1 0"),
        ("[-3, 0, 4]", "-0.6 0 0.8"),
        ("[3e200, 4e200, 0]", "0.6 0.8 0"),
        ("[0.7071068, 0, 0.7071068]", "0.7071068 0 0.7071068"),
        ("-z", "0 0 -1"),
    ] {
        for kind in ["pin", "slider"] {
            let text = format!("chain Rods {{ {BODY} ground -> {kind}({axis}) a -> Rod rod; }}");
            let urdf = export(&text, None).expect("a file");
            assert!(urdf.contains(&format!("<axis xyz=\"{expected}\"/>")), "{axis}: {urdf}");
        }
    }
}

/// A capsule is the union of a cylinder and two spheres at its ends.
#[test]
fn shapes_are_visuals() {
    let shapes = "[capsule(radius = 5 cm, length = 1 m) at [0, 0, 2] m turned quaternion(1, 0, 1, 0), \
                  mesh(\"info/<\\\"b\\\">.stl\"), sphere(radius = 0.1 m) at [0, 1, 0] m]";
    let text = format!(
        "chain Rods {{ {} ground -> pin(y) a -> Rod rod; }}",
        BODY.replace("mass", &format!("shape = {shapes}; mass"))
    );
    let urdf = export(&text, None).expect("a file");
    let again = import(&urdf, &Options::default()).expect("a chain").text;
    // The axis of the capsule is x: z is rotated by a right angle about y.
    let parts = [
        "cylinder(radius = 0.05 m, length = 1 m) at [0, 0, 2] m turned rpy(0, 90, 0) deg,",
        "mesh(\"info/<\\\"b\\\">.stl\"),",
        "sphere(radius = 0.1 m) at [0, 1, 0] m,",
    ];
    for part in parts {
        assert!(again.contains(part), "{part} is not in\n{urdf}\n{again}");
    }
    let (checked, _) = Source::new("text", &again).check();
    let rod = checked[0].chain.bodies.iter().find(|body| body.path == "rod").expect("the rod");
    for (side, shape) in [-0.5, 0.5].iter().zip(&rod.shapes[1..3]) {
        assert_eq!(shape.geometry, Geometry::Sphere(0.05));
        let difference = shape.position.iter().zip([*side, 0.0, 2.0]).map(|(a, b)| (a - b).abs());
        // A product with a rounded rotation.
        assert!(difference.fold(0.0, f64::max) < 4.0 * f64::EPSILON, "{:?}", shape.position);
    }
}

/// Returns the reasons for a chain of two rods with this hinge and these items after the route.
fn reasons(route: &str, items: &str) -> Vec<String> {
    let text = format!("chain Rods {{ {BODY} {route}; {items} }}");
    export(&text, None).expect_err(&text)
}

#[test]
fn what_urdf_does_not_have_is_refused_by_name() {
    let route = "ground -> pin(y) a -> Rod first -> pin(y) b -> Rod second";
    let cases = [
        ("ground -> ball a -> Rod rod", "", "hinge `a`: URDF has no ball joints"),
        ("ground -> universal a -> Rod rod", "", "hinge `a`: URDF has no universal joints"),
        ("ground -> gimbal a -> Rod rod", "", "hinge `a`: URDF has no gimbals"),
        ("ground -> cylindrical a -> Rod rod", "", "hinge `a`: URDF has no cylindrical joints"),
        ("ground -> screw(y, 1 mm/rev) a -> Rod rod", "", "hinge `a`: URDF has no screw joints"),
        ("ground -> elastic a -> Rod rod", "", "hinge `a`: URDF has no elastic joints"),
        (
            "moving end -> pin(y) a -> Rod rod",
            "",
            "moving end `end`: URDF has no prescribed motions",
        ),
        (
            "ground -> pin(y) a -> Rod u -> pin(y) b -> Rod p -> pin(y) c -> Rod w -> pin(y) d -> ground at [1, 0, 0] m",
            "hinge a { start = -90 deg; } hinge b, c { start = 90 deg; }",
            "hinge `d`: it closes a loop, and URDF has only trees",
        ),
        (route, "hinge a { stiffness = 1 N*m/rad; }", "hinge `a`: URDF has no stiffness"),
        (route, "hinge b { armature = 1 kg*m^2; }", "hinge `b`: URDF has no armature"),
        (route, "hinge b { torque = 1 N*m; }", "hinge `b`: URDF has no constant efforts"),
        (route, "hinge b { motion = input; }", "hinge `b`: URDF has no prescribed motions"),
        (route, "load push { on = first; force = input; }", "load `push`: URDF has no loads"),
        (
            route,
            "spring cord { on = first.output; to = second.output; stiffness = 1 N/m; }",
            "spring `cord`: URDF has no springs",
        ),
        (route, "gravity = input;", "`gravity = input`: URDF has no gravity"),
    ];
    for (route, items, expected) in cases {
        let found = reasons(route, items);
        assert!(found.iter().any(|reason| reason == expected), "{route} {items}: {found:?}");
    }
    let end = "moving end `end`: URDF has no prescribed motions";
    assert_eq!(reasons("moving end -> pin(y) a -> Rod rod", ""), [end]);
    let part = format!(
        "chain Parts {{ {BODY} part Leg {{
            pin(y) hip -> Rod rod;
            load push {{ on = rod; force = input; }}
            spring cord {{ on = rod.output; to = [0, 0, 1] m; stiffness = 1 N/m; }}
         }} Rod base; base.output -> Leg left; }}"
    );
    let names = ["load `left.push`: URDF has no loads", "spring `left.cord`: URDF has no springs"];
    assert_eq!(export(&part, None).unwrap_err(), names);
    let plane = "plane chain P { body R { mass = 1 kg; com = [1, 0] m; inertia = 1 kg*m^2 about com; } ground -> pin a -> R r; }";
    assert_eq!(export(plane, None).unwrap_err(), ["chain `P` is not in space: URDF files are"]);
    let constant = "chain C { body R { mass = MASS; com = [1, 0, 0] m; inertia = diag(1, 1, 1) kg*m^2 about com; } ground -> pin a -> R r; }";
    let found = export(constant, None).unwrap_err();
    assert_eq!(found.len(), 1, "{found:?}");
}

#[test]
fn one_of_several_chains_is_selected() {
    let text = format!("chain A {{ {BODY} Rod a; }} chain B {{ {BODY} Rod b; }}");
    assert_eq!(export(&text, None).unwrap_err(), ["select one of the chains `A`, `B` by `--name`"]);
    assert!(export(&text, Some("B")).unwrap().contains("<link name=\"b\">"));
    assert!(export(&text, Some("C")).is_err());
}
