//! Chains and helpers that the tests share.

use mstmm_reference::{
    About, Body, Chain, Dimension, Drives, Element, Ends, Frame, Gravity, Hinge, HingeChoice,
    HingeKind, Random, Recipe, Solution, State, random_chain, random_efforts, random_mechanism,
    random_motion, random_state,
};
use nalgebra::{Matrix3, Vector3};

/// The ends of chains that are not closed and have no prescribed motions.
pub(crate) const PLAIN_ENDS: [Ends; 3] = [Ends::HeldFree, Ends::FreeFree, Ends::FreeHeld];

/// A chain with a state and inputs.
pub(crate) struct Case {
    pub(crate) chain: Chain,
    pub(crate) state: State,
    pub(crate) drives: Drives,
}

impl Case {
    pub(crate) fn solve(&self) -> Solution {
        self.chain.solve_driven(&self.state, &self.drives)
    }
}

/// Returns random chains of pins, balls and welds with nothing but motors.
pub(crate) fn plain_cases() -> Vec<Case> {
    use HingeChoice::{Ball, Pin, Weld};
    let kinds: [&[HingeChoice]; 4] = [&[Pin], &[Ball], &[Weld, Pin], &[Weld, Pin, Ball]];
    let mut cases = Vec::new();
    for seed in 0..40 {
        let mut random = Random::new(seed);
        for ends in PLAIN_ENDS {
            let bodies = 1 + random.below(6);
            let name = format!("Seed{seed}{ends:?}");
            let chain = random_chain(&mut random, &name, bodies, ends, kinds[seed as usize % 4]);
            let state = random_state(&mut random, &chain);
            let efforts = random_efforts(&mut random, &chain);
            let drives = Drives { efforts, ..Drives::none(&chain) };
            cases.push(Case { chain, state, drives });
        }
    }
    cases
}

/// Returns random chains with all hinges, ends, dimensions, efforts and loads.
pub(crate) fn rich_cases() -> Vec<Case> {
    let mut cases = Vec::new();
    for dimension in [Dimension::Space, Dimension::Plane, Dimension::Line] {
        for ends in Ends::ALL {
            for seed in 0..if dimension == Dimension::Space { 12 } else { 5 } {
                let mut random = Random::new(seed);
                let bodies = 1 + random.below(5);
                let recipe = Recipe::rich(dimension, bodies, ends, &HingeChoice::ALL);
                cases.push(case(&mut random, &format!("{dimension:?}{ends:?}{seed}"), &recipe));
            }
        }
    }
    cases.extend((0..8).map(flat_case));
    cases
}

/// Returns a loop in space whose pins are all parallel, so its hinges are redundant.
pub(crate) fn flat_case(seed: u64) -> Case {
    let mut random = Random::new(seed);
    let kinds = [HingeChoice::Pin, HingeChoice::Pin, HingeChoice::Slider];
    let recipe = Recipe::rich(Dimension::Space, 3, Ends::HeldHeld, &kinds);
    let recipe = Recipe { flat: true, prescribed: 0.0, ..recipe };
    case(&mut random, &format!("Flat{seed}"), &recipe)
}

/// Returns a random chain by a recipe in a random state.
pub(crate) fn case(random: &mut Random, name: &str, recipe: &Recipe) -> Case {
    let chain = random_mechanism(random, name, recipe);
    let (state, drives) = random_motion(random, &chain);
    Case { chain, state, drives }
}

/// Returns the acceleration of free fall.
pub(crate) fn gravity(case: &Case) -> Vector3<f64> {
    match case.chain.gravity {
        Gravity::Constant(gravity) => Vector3::from(gravity),
        Gravity::Input => Vector3::from(case.drives.gravity),
    }
}

/// Returns a unit cube of 1 kg, with input and output in the middles of two opposite faces.
pub(crate) fn cube(name: &str) -> Element {
    Element::Body(Body {
        name: name.to_owned(),
        mass: 1.0,
        com: [0.5, 0.0, 0.0],
        output: Frame::at([1.0, 0.0, 0.0]),
        inertia: [1.0 / 6.0, 5.0 / 12.0, 5.0 / 12.0, 0.0, 0.0, 0.0],
        about: About::Input,
        points: Vec::new(),
    })
}

pub(crate) fn hinge(name: &str, kind: HingeKind) -> Element {
    Element::Hinge(Hinge::new(name, kind))
}

/// Returns a pin about the z axis.
pub(crate) fn pin_about_z(name: &str) -> Element {
    hinge(name, HingeKind::Pin { axis: [0.0, 0.0, 1.0] })
}

/// Returns a body about its input, with a moment of inertia about z.
pub(crate) fn disc(name: &str, mass: f64, inertia: f64) -> Element {
    Element::Body(Body {
        name: name.to_owned(),
        mass,
        com: [0.0; 3],
        output: Frame::IDENTITY,
        inertia: [0.6 * inertia, 0.7 * inertia, inertia, 0.0, 0.0, 0.0],
        about: About::Com,
        points: Vec::new(),
    })
}

/// Returns three unit cubes hanging from the origin by hinges of one kind, along x at first.
pub(crate) fn three_cubes(kind: &HingeKind) -> Chain {
    let link = |k: usize| [hinge(&format!("j{k}"), kind.clone()), cube(&format!("b{k}"))];
    Chain::new("ThreeCubes", [0.0, -9.8, 0.0], (1..=3).flat_map(link).collect())
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

/// Checks that two numbers agree to `tolerance`, relative if they are larger than 1.
#[track_caller]
pub(crate) fn assert_close(found: f64, expected: f64, tolerance: f64, what: &str) {
    let error = (found - expected).abs() / expected.abs().max(1.0);
    assert!(error <= tolerance, "{what}: {found} is not {expected}, error {error:.2e}");
}

/// Returns the moment of inertia of a body about its centre of mass and the z axis.
pub(crate) fn central_inertia_of(case: &Case, name: &str) -> f64 {
    let body = case.chain.bodies().find(|body| body.name == name);
    central_inertia(body.expect("a body of this name"))[(2, 2)]
}
