//! Descriptions: random ones, and their text.

use crate::samples::{ALL_ENDS, central_inertia, random_cases};
use mstmm_reference::{
    About, Body, Chain, Element, End, Frame, Hinge, HingeKind, Joining, Random, State,
    random_chain, random_state,
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
    };
    let upper = body("upper_arm", [0.0, 0.0, 90.0], [0.1, 0.2, 0.25, 0.0, 0.0, 0.0], About::Com);
    let lower = body("b2", [0.0; 3], [0.5, 0.6, 0.7, 0.01, -0.02, 1e-7], About::Input);
    let pin = HingeKind::Pin { axis: [0.0, -1.0, 0.5] };
    let chain = Chain {
        name: "Arm".to_owned(),
        gravity: [0.0, -9.8, 0.0],
        start: End::Held(Frame { position: [0.0, 1.0, 0.0], rpy_degrees: [10.0, 0.0, 0.0] }),
        finish: End::Free,
        elements: vec![
            Element::Hinge(Hinge { name: "j1".to_owned(), kind: pin, motor: true }),
            Element::Body(upper),
            Element::Hinge(Hinge { name: "j2".to_owned(), kind: HingeKind::Ball, motor: false }),
            Element::Body(lower),
        ],
    };
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
    let body = crate::samples::cube("b1");
    let weld = crate::samples::hinge("w1", HingeKind::Weld);
    let chain = Chain {
        name: "Post".to_owned(),
        gravity: [0.0; 3],
        start: End::Free,
        finish: End::Held(Frame::IDENTITY),
        elements: vec![body, weld],
    };
    let text = chain.to_macro_text(None);
    assert!(!text.contains("method"), "{text}");
    assert!(text.ends_with("    B1 b1 -> weld w1 -> ground;\n}\n"), "{text}");
}

#[test]
fn seeds_repeat() {
    let make = || {
        let mut random = Random::new(7);
        let kinds = [Joining::Weld, Joining::Pin, Joining::Ball];
        let chains = ALL_ENDS.map(|ends| random_chain(&mut random, "Again", 4, ends, &kinds));
        let states: Vec<State> = chains.iter().map(|c| random_state(&mut random, c)).collect();
        (chains, states)
    };
    assert_eq!(make(), make());
}

/// Moments of inertia are positive, and none is greater than the other two together.
#[test]
fn random_bodies_are_possible() {
    for case in random_cases() {
        for body in case.chain.bodies() {
            let moments = central_inertia(body).symmetric_eigenvalues();
            assert!(body.mass > 0.0 && moments.min() > 0.0, "{body:?}");
            assert!(2.0 * moments.max() < moments.sum(), "{body:?}");
        }
    }
}

/// The special cases that random chains are meant to have do occur.
#[test]
fn random_chains_have_special_data() {
    let cases = random_cases();
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
    assert!(hinges.iter().any(|hinge| hinge.motor));
    let offset_ground =
        |chain: &Chain| matches!(&chain.start, End::Held(f) if *f != Frame::IDENTITY);
    assert!(cases.iter().any(|case| offset_ground(&case.chain)));
}
