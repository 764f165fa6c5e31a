//! Simulated motions: conserved quantities, and consistency with the equations of motion.

use crate::samples::{
    Case, assert_close, central_inertia, cube, flat_case, hinge, matrix, plain_cases,
};
use mstmm_reference::{
    Chain, Dimension, Drives, Element, Ends, Gravity, Hinge, HingeChoice, HingeKind, Random,
    Recipe, Sample, Source, State, random_mechanism, random_motion, simulate,
};
use nalgebra::Vector3;

const TIMES: [f64; 3] = [0.0, 0.3, 0.7];

/// Returns random chains short enough to be simulated quickly without optimisation: plain chains,
/// and open and closed chains with hinges of all kinds, springs and rotors, but without dissipation.
fn short_cases() -> Vec<Case> {
    let plain = plain_cases().into_iter().filter(|case| case.chain.bodies().count() <= 3);
    let mut cases: Vec<Case> = plain.take(24).collect();
    for dimension in [Dimension::Space, Dimension::Plane, Dimension::Line] {
        for ends in [Ends::HeldFree, Ends::FreeFree, Ends::FreeHeld, Ends::HeldHeld] {
            for seed in 0..3 {
                cases.push(conservative_case(seed, dimension, ends, &HingeChoice::ALL));
            }
        }
    }
    let elastic = [HingeChoice::Elastic];
    let pair = |seed| conservative_case(seed, Dimension::Space, Ends::FreeFree, &elastic);
    cases.extend((1..4).map(pair));
    cases.extend((0..3).map(|seed| {
        let mut case = flat_case(seed);
        conserve(&mut case.chain);
        case.drives = Drives::none(&case.chain);
        case
    }));
    cases
}

fn conservative_case(seed: u64, dimension: Dimension, ends: Ends, kinds: &[HingeChoice]) -> Case {
    let mut random = Random::new(seed);
    let recipe =
        Recipe { prescribed: 0.0, ..Recipe::rich(dimension, 1 + seed as usize, ends, kinds) };
    let name = format!("Short{dimension:?}{ends:?}{seed}");
    let mut chain = random_mechanism(&mut random, &name, &recipe);
    conserve(&mut chain);
    let (state, drives) = random_motion(&mut random, &chain);
    hold_gimbals(&mut chain, &state);
    Case { chain, state, drives }
}

/// Holds gimbals by springs where they start: their axes must not come near one plane.
fn hold_gimbals(chain: &mut Chain, state: &State) {
    let mut first = state.q.len() - chain.hinges().map(Hinge::coordinates).sum::<usize>();
    for element in &mut chain.elements {
        let Element::Hinge(hinge) = element else { continue };
        let count = hinge.coordinates();
        if let HingeKind::Gimbal { .. } = hinge.kind {
            hinge.turning.stiffness = vec![600.0, 800.0, 700.0];
            hinge.rest = state.q[first..first + count].to_vec();
        }
        first += count;
    }
}

/// Removes everything that changes the energy of a chain except input motors.
fn conserve(chain: &mut Chain) {
    if chain.gravity == Gravity::Input {
        chain.gravity = [0.0; 3].into();
    }
    chain.loads.clear();
    for spring in &mut chain.springs {
        spring.damping = 0.0;
        spring.force = Source::None;
        // A motion along a line can pass through the point on the ground, where the force would jump.
        spring.length = 0.0;
    }
    for element in &mut chain.elements {
        let Element::Hinge(hinge) = element else { continue };
        for group in [&mut hinge.linear, &mut hinge.turning] {
            group.damping.clear();
            group.friction.clear();
            group.limits = None;
            if let Source::Constant(_) = group.motor {
                group.motor = Source::None;
            }
        }
        if hinge.kind == HingeKind::Elastic {
            // The second angle must not come near a right angle.
            hinge.turning.stiffness = vec![60.0, 80.0, 70.0];
            hinge.rest = Vec::new();
        }
    }
}

/// Returns the tolerance of a motion: larger for fast motions.
fn slack(chain: &Chain, state: &State) -> f64 {
    let solution = chain.solve(state, &vec![0.0; chain.dof_count()]);
    1e-10 * (1.0 + solution.kinetic_energy + solution.potential_energy.abs())
}

fn without_motors(case: &Case) -> Vec<f64> {
    vec![0.0; case.drives.efforts.len()]
}

#[test]
fn energy_is_kept() {
    for case in &short_cases() {
        let efforts = without_motors(case);
        let start = case.chain.solve(&case.state, &efforts);
        let expected = start.kinetic_energy + start.potential_energy;
        simulate(&case.chain, &case.state, &efforts, &TIMES, |sample| {
            let energy = sample.kinetic_energy + sample.potential_energy;
            let tolerance = slack(&case.chain, &case.state);
            assert_close(energy, expected, tolerance, &case.chain.name);
        });
    }
}

/// The state computed from the bodies gives their poses again, so the hinge constraints are fulfilled.
#[test]
fn measured_states_describe_the_bodies() {
    for case in &short_cases() {
        simulate(&case.chain, &case.state, &case.drives.efforts, &TIMES, |sample| {
            let placed = case.chain.solve(&sample.state, &case.drives.efforts);
            let is_body = |k: &usize| matches!(case.chain.elements[*k], Element::Body(_));
            let inputs = (0..case.chain.elements.len()).filter(is_body);
            for (k, moved) in inputs.zip(&sample.bodies) {
                let point = &placed.points[k];
                let turn = matrix(&point.rotation) - matrix(&moved.rotation);
                let spin =
                    Vector3::from(point.angular_velocity) - Vector3::from(moved.angular_velocity);
                assert!(turn.amax() < 1e-10, "{}: {turn}", case.chain.name);
                assert!(spin.amax() < 1e-9, "{}: {spin}", case.chain.name);
            }
            assert_close(placed.kinetic_energy, sample.kinetic_energy, 1e-10, &case.chain.name);
        });
    }
}

/// The derivatives of the rates are the accelerations of `solve`.
#[test]
fn rates_change_as_solved() {
    let step = 1e-4;
    for case in &short_cases() {
        let start = case.chain.solve(&case.state, &case.drives.efforts);
        let mut states: Vec<State> = Vec::new();
        let times = [0.0, step, 2.0 * step];
        simulate(&case.chain, &case.state, &case.drives.efforts, &times, |s| {
            states.push(s.state.clone())
        });
        let size: f64 = start.accelerations.iter().map(|a| a.abs()).sum();
        for (k, expected) in start.accelerations.iter().enumerate() {
            let [v0, v1, v2] = [0, 1, 2].map(|time| states[time].v[k]);
            let slope = (4.0 * v1 - v2 - 3.0 * v0) / (2.0 * step);
            assert_close(slope, *expected, 1e-6 * (1.0 + size * size), &case.chain.name);
        }
    }
}

/// Without gravity a floating chain keeps its momentum and its angular momentum.
#[test]
fn momenta_are_kept() {
    let floats = |case: &&Case| case.chain.floats() && case.chain.dimension == Dimension::Space;
    for case in short_cases().iter().filter(floats) {
        let springs = Vec::new();
        let chain = Chain { gravity: [0.0; 3].into(), springs, ..case.chain.clone() };
        let mut start: Option<[Vector3<f64>; 2]> = None;
        simulate(&chain, &case.state, &case.drives.efforts, &TIMES, |sample| {
            let found = momenta(&chain, sample);
            let expected = start.get_or_insert(found);
            for k in 0..3 {
                assert_close(found[0][k], expected[0][k], 1e-10, &chain.name);
                assert_close(found[1][k], expected[1][k], 1e-10, &chain.name);
            }
        });
    }
}

fn momenta(chain: &Chain, sample: &Sample) -> [Vector3<f64>; 2] {
    let mut total = [Vector3::zeros(); 2];
    for (body, moved) in chain.bodies().zip(&sample.bodies) {
        let rotation = matrix(&moved.rotation);
        let momentum = Vector3::from(moved.velocity) * body.mass;
        let spin = rotation.transpose() * Vector3::from(moved.angular_velocity);
        total[0] += momentum;
        total[1] += Vector3::from(moved.position).cross(&momentum)
            + rotation * (central_inertia(body) * spin);
    }
    total
}

/// The angle of a pin counts all its turns.
#[test]
fn pins_count_their_turns() {
    let pin = hinge("j1", HingeKind::Pin { axis: [-1.0, 0.0, 0.0] });
    let elements = vec![hinge("w1", HingeKind::Weld), cube("b1"), pin, cube("b2")];
    let chain = Chain::new("Wheel", [0.0; 3], elements);
    for rate in [20.0, -90.0] {
        let start = State { q: vec![0.5], v: vec![rate] };
        simulate(&chain, &start, &[0.0], &[2.0, 5.0], |sample| {
            let angle = 0.5 + rate * sample.time;
            assert_eq!(sample.pin_angles[0], None);
            assert_close(sample.pin_angles[1].unwrap(), angle, 1e-11, "angle");
            assert_close(sample.state.q[0], angle, 1e-11, "coordinate");
        });
    }
}
