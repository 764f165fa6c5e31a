//! Descriptions: random ones, and their text.

use crate::samples::{
    PLAIN_ENDS, central_inertia, cube, hinge, pin_about_z, plain_cases, rich_cases,
};
use mstmm_reference::{
    About, Axes, Axis, Body, BodyPoint, Chain, Dimension, Drives, Element, End, Frame, Gravity,
    Group, Hinge, HingeChoice, HingeKind, Limits, Load, Random, Recipe, Source, Spring, SpringEnd,
    State, random_chain, random_mechanism, random_motion, random_state,
};

#[test]
fn text_of_a_held_chain() {
    let body = |name: &str, rpy_degrees: [f64; 3], inertia: [f64; 6], about: About| Body {
        name: name.to_owned(),
        mass: 1.5,
        com: [0.5, 0.0, -0.25],
        output: Frame { position: [1.0, 0.0, 0.0], rpy_degrees },
        inertia,
        about,
        points: Vec::new(),
    };
    let upper = body("upper_arm", [0.0, 0.0, 90.0], [0.1, 0.2, 0.25, 0.0, 0.0, 0.0], About::Com);
    let lower = body("b2", [0.0; 3], [0.5, 0.6, 0.7, 0.01, -0.02, 1e-7], About::Input);
    let pin = HingeKind::Pin { axis: [0.0, -1.0, 0.5] };
    let mut driven = Hinge::new("j1", pin);
    driven.turning.motor = Source::Input;
    let elements = vec![
        Element::Hinge(driven),
        Element::Body(upper),
        Element::Hinge(Hinge::new("j2", HingeKind::Ball)),
        Element::Body(lower),
    ];
    let ground = Frame { position: [0.0, 1.0, 0.0], rpy_degrees: [10.0, 0.0, 0.0] };
    let chain = Chain { start: End::Held(ground), ..Chain::new("Arm", [0.0, -9.8, 0.0], elements) };
    let expected = "\
pub chain Arm {
    method = riccati;
    gravity = [0.0, -9.8, 0.0] m/s^2;
    body UpperArm {
        mass = 1.5 kg;
        com = [0.5, 0.0, -0.25] m;
        output = [1.0, 0.0, 0.0] m turned rpy(0.0, 0.0, 90.0) deg;
        inertia = diag(0.1, 0.2, 0.25) kg*m^2 about com;
    }
    body B2 {
        mass = 1.5 kg;
        com = [0.5, 0.0, -0.25] m;
        output = [1.0, 0.0, 0.0] m;
        inertia = tensor(0.5, 0.6, 0.7, 0.01, -0.02, 1e-7) kg*m^2 about input;
    }
    ground at [0.0, 1.0, 0.0] m turned rpy(10.0, 0.0, 0.0) deg -> pin([0.0, -1.0, 0.5]) j1 \
-> UpperArm upper_arm -> ball j2 -> B2 b2;
    hinge j1 { torque = input; }
}
";
    assert_eq!(chain.to_macro_text(Some("riccati")), expected);
}

#[test]
fn text_of_a_chain_held_at_its_finish() {
    let body = cube("b1");
    let weld = hinge("w1", HingeKind::Weld);
    let chain = Chain {
        start: End::Free,
        finish: End::Held(Frame::IDENTITY),
        ..Chain::new("Post", [0.0; 3], vec![body, weld])
    };
    let text = chain.to_macro_text(None);
    assert!(!text.contains("method"), "{text}");
    assert!(text.ends_with("    B1 b1 -> weld w1 -> ground;\n}\n"), "{text}");
}

/// Returns the text of one hinge's block.
fn section(hinge: Hinge) -> String {
    let name = hinge.name.clone();
    let chain = Chain::new("One", [0.0; 3], vec![Element::Hinge(hinge), cube("b1")]);
    let text = chain.to_macro_text(None);
    let found = text.lines().find(|line| line.starts_with(&format!("    hinge {name}")));
    found.unwrap_or_else(|| panic!("{text}")).trim().to_owned()
}

#[test]
fn text_of_hinges() {
    let group = |stiffness: Vec<f64>, limits: Option<[f64; 2]>, motor: Source<Vec<f64>>| Group {
        stiffness,
        limits: limits.map(|range| Limits { range, stiffness: 9.0, damping: 0.0 }),
        motor,
        ..Group::default()
    };
    let planar = Hinge {
        rest: vec![0.1, 0.2, 0.3],
        linear: group(vec![1.0, 2.0], Some([-1.0, 1.5]), Source::Input),
        turning: Group {
            friction: vec![0.5],
            friction_speed: 0.1,
            ..group(vec![3.0], None, Source::Constant(vec![4.0]))
        },
        ..Hinge::new("p", HingeKind::Planar { normal: Axis::X })
    };
    assert_eq!(
        section(planar),
        "hinge p { rest = [0.1, 0.2] m turned 0.3 rad; stiffness = [1.0, 2.0] N/m; \
         limits = [-1.0, 1.5] m; limit_stiffness = 9.0 N/m; force = input; \
         turning_stiffness = 3.0 N*m/rad; turning_friction = 0.5 N*m; \
         turning_friction_speed = 0.1 rad/s; torque = 4.0 N*m; }"
    );
    let ball = Hinge {
        rest: vec![1.0, 0.0, -0.5, 0.25],
        turning: group(vec![7.0], Some([0.0, 0.8]), Source::Constant(vec![1.0, 2.0, 3.0])),
        ..Hinge::new("b", HingeKind::Ball)
    };
    assert_eq!(
        section(ball),
        "hinge b { rest = quaternion(1.0, 0.0, -0.5, 0.25); stiffness = 7.0 N*m/rad; \
         limits = 0.8 rad; limit_stiffness = 9.0 N*m/rad; torque = [1.0, 2.0, 3.0] N*m; }"
    );
    let elastic = Hinge {
        rest: vec![0.0, 0.1, 0.0, 0.01, 0.02, 3.5],
        linear: Group { damping: vec![2.0], ..Group::default() },
        turning: Group { armature: vec![0.1, 0.2, 0.3], ..Group::default() },
        prescribed: true,
        ..Hinge::new("e", HingeKind::Elastic)
    };
    assert_eq!(
        section(elastic),
        "hinge e { rest = [0.0, 0.1, 0.0] m turned rpy(0.01, 0.02, 3.5) rad; \
         damping = 2.0 N*s/m; turning_armature = [0.1, 0.2, 0.3] kg*m^2; motion = input; }"
    );
}

#[test]
fn text_of_the_words_for_hinges() {
    let axis = [0.0, 0.0, 1.0];
    let askew = [0.5, 0.0, -1.0];
    let words = [
        (HingeKind::Slider { axis }, "slider(z)"),
        (HingeKind::Screw { axis: askew, pitch: -0.01 }, "screw([0.5, 0.0, -1.0], -0.01 m/rad)"),
        (HingeKind::Cylindrical { axis }, "cylindrical(z)"),
        (HingeKind::Universal { first: axis, second: askew }, "universal(z, [0.5, 0.0, -1.0])"),
        (HingeKind::Gimbal { axes: [axis, axis, askew] }, "gimbal(z, z, [0.5, 0.0, -1.0])"),
        (HingeKind::Planar { normal: Axis::Y }, "planar(y)"),
        (HingeKind::Floating, "floating"),
        (HingeKind::Elastic, "elastic"),
    ];
    for (kind, word) in words {
        let elements = vec![hinge("j1", kind), cube("b1")];
        let chain = Chain::new("Word", [0.0; 3], elements);
        let text = chain.to_macro_text(None);
        assert!(text.contains(&format!("    ground -> {word} j1 -> B1 b1;\n")), "{text}");
    }
}

#[test]
fn text_of_a_chain_in_the_plane() {
    let body = Body {
        name: "bar".to_owned(),
        mass: 2.0,
        com: [0.5, 0.25, 0.0],
        output: Frame { position: [1.0, 0.0, 0.0], rpy_degrees: [0.0, 0.0, 30.0] },
        inertia: [0.0, 0.0, 0.125, 0.0, 0.0, 0.0],
        about: About::Com,
        points: Vec::new(),
    };
    let mut chain = Chain {
        dimension: Dimension::Plane,
        gravity: Gravity::Input,
        start: End::Moving { name: "cart".to_owned() },
        finish: End::Held(Frame { position: [1.0, 2.0, 0.0], rpy_degrees: [0.0, 0.0, -45.0] }),
        ..Chain::new(
            "Flat",
            [0.0; 3],
            vec![
                pin_about_z("j1"),
                Element::Body(body),
                hinge("j2", HingeKind::Slider { axis: [0.5, -1.0, 0.0] }),
            ],
        )
    };
    chain.loads.push(Load {
        name: "push".to_owned(),
        body: "bar".to_owned(),
        at: BodyPoint::Named { name: "tip".to_owned(), position: [0.75, 0.0, 0.0] },
        force: Source::Constant([1.0, -2.0, 0.0]),
        torque: Source::Input,
        axes: Axes::Body,
    });
    chain.springs.push(Spring {
        name: "s1".to_owned(),
        body: "bar".to_owned(),
        at: BodyPoint::Output,
        to: SpringEnd::Ground([0.0, 3.0, 0.0]),
        stiffness: 10.0,
        damping: 0.0,
        length: 0.5,
        force: Source::Input,
    });
    let expected = "\
pub plane chain Flat {
    gravity = input;
    body Bar {
        mass = 2.0 kg;
        com = [0.5, 0.25] m;
        output = [1.0, 0.0] m turned 30.0 deg;
        inertia = 0.125 kg*m^2 about com;
        point tip = [0.75, 0.0] m;
    }
    moving cart -> pin j1 -> Bar bar -> slider([0.5, -1.0]) j2 -> ground at [1.0, 2.0] m turned \
-45.0 deg;
    load push { on = bar; at = tip; force = [1.0, -2.0] N; torque = input; axes = body; }
    spring s1 { on = bar; at = output; to = [0.0, 3.0] m; stiffness = 10.0 N/m; length = 0.5 m; force = input; }
}
";
    assert_eq!(chain.to_macro_text(None), expected);
}

#[test]
fn text_of_a_chain_along_a_line() {
    let body = Body {
        name: "car".to_owned(),
        mass: 2.0,
        com: [0.5, 0.0, 0.0],
        output: Frame::at([1.0, 0.0, 0.0]),
        inertia: [0.0; 6],
        about: About::Com,
        points: Vec::new(),
    };
    let mut coupling = Hinge::new("j1", HingeKind::LineElastic);
    coupling.rest = vec![0.25];
    coupling.linear.stiffness = vec![100.0];
    let chain = Chain {
        dimension: Dimension::Line,
        start: End::Held(Frame::at([0.5, 0.0, 0.0])),
        ..Chain::new("Track", [-9.5, 0.0, 0.0], vec![Element::Hinge(coupling), Element::Body(body)])
    };
    let expected = "\
pub line chain Track {
    gravity = -9.5 m/s^2;
    body Car {
        mass = 2.0 kg;
        com = 0.5 m;
        output = 1.0 m;
    }
    ground at 0.5 m -> elastic j1 -> Car car;
    hinge j1 { rest = 0.25 m; stiffness = 100.0 N/m; }
}
";
    assert_eq!(chain.to_macro_text(None), expected);
}

#[test]
fn seeds_repeat() {
    let make = || {
        let mut random = Random::new(7);
        let kinds = [HingeChoice::Weld, HingeChoice::Pin, HingeChoice::Ball];
        let chains = PLAIN_ENDS.map(|ends| random_chain(&mut random, "Again", 4, ends, &kinds));
        let states: Vec<State> = chains.iter().map(|c| random_state(&mut random, c)).collect();
        let rich: Vec<(Chain, State, Drives)> = (0..5)
            .map(|number| {
                let recipe = Recipe::any(&mut random, 3);
                let chain = random_mechanism(&mut random, &format!("Rich{number}"), &recipe);
                let (state, drives) = random_motion(&mut random, &chain);
                (chain, state, drives)
            })
            .collect();
        (chains, states, rich)
    };
    assert_eq!(make(), make());
}

/// Moments of inertia are positive, and none is larger than the sum of the other two.
#[test]
fn random_bodies_are_possible() {
    for case in plain_cases() {
        for body in case.chain.bodies() {
            let moments = central_inertia(body).symmetric_eigenvalues();
            assert!(body.mass > 0.0 && moments.min() > 0.0, "{body:?}");
            assert!(2.0 * moments.max() < moments.sum(), "{body:?}");
        }
    }
}

/// Random chains have the special cases that they are meant to have.
#[test]
fn random_chains_have_special_data() {
    let cases = plain_cases();
    let bodies: Vec<&Body> = cases.iter().flat_map(|case| case.chain.bodies()).collect();
    let hinges: Vec<&Hinge> = cases.iter().flat_map(|case| case.chain.hinges()).collect();
    let pin = |wanted: [f64; 3]| {
        hinges.iter().any(|h| matches!(h.kind, HingeKind::Pin { axis } if axis == wanted))
    };
    assert!(bodies.iter().any(|body| body.com == [0.0; 3]));
    assert!(bodies.iter().any(|body| body.output == Frame::IDENTITY));
    assert!(bodies.iter().any(|body| body.output.rpy_degrees.contains(&90.0)));
    assert!(bodies.iter().any(|body| body.inertia[3..] == [0.0; 3]));
    assert!(bodies.iter().any(|body| body.inertia[3] != 0.0 && body.about == About::Com));
    assert!(pin([1.0, 0.0, 0.0]) && pin([0.0, -1.0, 0.0]) && pin([0.0, 0.0, 1.0]));
    assert!(hinges.iter().any(|hinge| hinge.turning.motor == Source::Input));
    let offset_ground =
        |chain: &Chain| matches!(&chain.start, End::Held(f) if *f != Frame::IDENTITY);
    assert!(cases.iter().any(|case| offset_ground(&case.chain)));
}

/// Random chains in which everything may occur do have everything.
#[test]
fn rich_chains_are_rich() {
    let cases = rich_cases();
    let hinges: Vec<&Hinge> = cases.iter().flat_map(|case| case.chain.hinges()).collect();
    let groups: Vec<&Group> =
        hinges.iter().flat_map(|hinge| [&hinge.linear, &hinge.turning]).collect();
    let some_hinge = |wanted: &dyn Fn(&Hinge) -> bool| hinges.iter().any(|hinge| wanted(hinge));
    let some_group = |wanted: &dyn Fn(&Group) -> bool| groups.iter().any(|group| wanted(group));
    assert!(some_hinge(&|hinge| hinge.prescribed));
    for kind in [HingeKind::Ball, HingeKind::Floating, HingeKind::Elastic, HingeKind::PlaneElastic]
    {
        let wanted = |hinge: &Hinge| hinge.kind == kind;
        assert!(some_hinge(&|hinge| wanted(hinge) && !hinge.turning.stiffness.is_empty()));
        assert!(some_hinge(&|hinge| wanted(hinge) && !hinge.turning.armature.is_empty()));
        assert!(some_hinge(&|hinge| wanted(hinge) && hinge.turning.limits.is_some()));
        assert!(some_hinge(&|hinge| wanted(hinge) && !hinge.rest.is_empty()), "{kind:?}");
    }
    assert!(some_group(&|group| group.damping.len() == 3 && group.friction.len() == 1));
    assert!(some_group(&|group| matches!(group.motor, Source::Constant(_))));
    let loads = || cases.iter().flat_map(|case| &case.chain.loads);
    assert!(loads().any(|load| load.axes == Axes::Body && load.force == Source::Input));
    assert!(loads().any(|load| matches!(load.at, BodyPoint::Named { .. })));
    let springs = || cases.iter().flat_map(|case| &case.chain.springs);
    assert!(springs().any(|spring| spring.length == 0.0));
    assert!(springs().any(|spring| spring.length > 0.0 && spring.damping > 0.0));
    assert!(cases.iter().any(|case| case.chain.gravity == Gravity::Input));
    assert!(cases.iter().any(|case| !case.solve().reactions_unique));
}
