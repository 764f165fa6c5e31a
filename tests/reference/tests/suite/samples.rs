//! Chains the tests share, and what they compute with.

use mstmm_reference::{
    About, Body, Chain, Element, End, Ends, Frame, Hinge, HingeKind, Joining, Random, State,
    random_chain, random_efforts, random_state,
};
use nalgebra::{Matrix3, Vector3};

pub(crate) const ALL_ENDS: [Ends; 3] = [Ends::HeldFree, Ends::FreeFree, Ends::FreeHeld];

/// A chain with something to compute about it.
pub(crate) struct Case {
    pub(crate) chain: Chain,
    pub(crate) state: State,
    pub(crate) efforts: Vec<f64>,
}

/// Returns random chains with every combination of ends and of kinds of hinges.
pub(crate) fn random_cases() -> Vec<Case> {
    use Joining::{Ball, Pin, Weld};
    let kinds: [&[Joining]; 4] = [&[Pin], &[Ball], &[Weld, Pin], &[Weld, Pin, Ball]];
    let mut cases = Vec::new();
    for seed in 0..40 {
        let mut random = Random::new(seed);
        for ends in ALL_ENDS {
            let bodies = 1 + random.below(6);
            let name = format!("Seed{seed}{ends:?}");
            let chain = random_chain(&mut random, &name, bodies, ends, kinds[seed as usize % 4]);
            let state = random_state(&mut random, &chain);
            let efforts = random_efforts(&mut random, &chain);
            cases.push(Case { chain, state, efforts });
        }
    }
    cases
}

/// Returns a unit cube of 1 kg, entered and left in the middles of two opposite faces.
pub(crate) fn cube(name: &str) -> Element {
    Element::Body(Body {
        name: name.to_owned(),
        mass: 1.0,
        com: [0.5, 0.0, 0.0],
        output: Frame::at([1.0, 0.0, 0.0]),
        inertia: [1.0 / 6.0, 5.0 / 12.0, 5.0 / 12.0, 0.0, 0.0, 0.0],
        about: About::Input,
    })
}

pub(crate) fn hinge(name: &str, kind: HingeKind) -> Element {
    Element::Hinge(Hinge { name: name.to_owned(), kind, motor: false })
}

/// Returns three unit cubes hanging from the origin by hinges of one kind, along x at first.
pub(crate) fn three_cubes(kind: &HingeKind) -> Chain {
    let link = |k: usize| [hinge(&format!("j{k}"), kind.clone()), cube(&format!("b{k}"))];
    Chain {
        name: "ThreeCubes".to_owned(),
        gravity: [0.0, -9.8, 0.0],
        start: End::Held(Frame::IDENTITY),
        finish: End::Free,
        elements: (1..=3).flat_map(link).collect(),
    }
}

/// Returns the matrix with the given rows.
pub(crate) fn matrix(rows: &[[f64; 3]; 3]) -> Matrix3<f64> {
    Matrix3::from_fn(|row, column| rows[row][column])
}

/// Returns the inertia of a body about its centre of mass, in body axes.
pub(crate) fn central_inertia(body: &Body) -> Matrix3<f64> {
    let [xx, yy, zz, xy, xz, yz] = body.inertia;
    let given = Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
    let com = Vector3::from(body.com);
    let steiner = Matrix3::identity() * com.norm_squared() - com * com.transpose();
    match body.about {
        About::Com => given,
        About::Input => given - steiner * body.mass,
    }
}

/// Checks that two numbers agree to `tolerance`, relative where they are greater than one.
#[track_caller]
pub(crate) fn assert_close(found: f64, expected: f64, tolerance: f64, what: &str) {
    let error = (found - expected).abs() / expected.abs().max(1.0);
    assert!(error <= tolerance, "{what}: {found} is not {expected}, error {error:.2e}");
}
