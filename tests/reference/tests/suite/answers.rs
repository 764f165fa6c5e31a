//! Answers by definition, compared with the solver in maximal coordinates and with each other.

use crate::samples::{Case, assert_close, plain_cases, rich_cases};
use crate::trees::trees;
use mstmm_reference::{Answers, Change, Element, End, Hinge, LoadInput, Random};

/// The tolerance relative to the largest expected value: the rounding error of the solver in maximal
/// coordinates, which has up to 66 unknowns, and of closed states.
const TOLERANCE: f64 = 1e-11;

fn cases() -> impl Iterator<Item = Case> {
    plain_cases().into_iter().chain(rich_cases()).chain(trees())
}

#[track_caller]
fn assert_all_close(found: &[f64], expected: &[f64], tolerance: f64, what: &str) {
    assert_eq!(found.len(), expected.len(), "{what}");
    let scale = expected.iter().fold(1.0_f64, |most, x| most.max(x.abs()));
    for (found, expected) in found.iter().zip(expected) {
        assert_close(*found / scale, *expected / scale, tolerance, what);
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn times(matrix: &[Vec<f64>], vector: &[f64]) -> Vec<f64> {
    matrix.iter().map(|row| dot(row, vector)).collect()
}

fn random_list(random: &mut Random, count: usize) -> Vec<f64> {
    (0..count).map(|_| random.between(-1.0, 1.0)).collect()
}

fn answers(case: &Case) -> Answers<'_> {
    case.chain.answers(&case.state, &case.drives)
}

#[test]
fn efforts_and_mass_matrices_are_those_in_maximal_coordinates() {
    for case in cases() {
        let Case { chain, state, drives } = &case;
        let (answers, mut random) = (answers(&case), Random::new(3));
        let accelerations = random_list(&mut random, state.v.len());
        let expected = chain.inverse_dynamics(state, drives, &accelerations);
        let found = answers.inverse_dynamics(&accelerations);
        assert_all_close(&found, &expected, TOLERANCE, &chain.name);
        let expected = chain.mass_matrix(state, drives).concat();
        assert_all_close(&answers.mass_matrix().concat(), &expected, TOLERANCE, &chain.name);
    }
}

#[test]
fn accelerations_and_motions_are_those_in_maximal_coordinates() {
    for case in cases().filter(|case| !case.chain.closed()) {
        let (answers, solution, name) = (answers(&case), case.solve(), &case.chain.name);
        let accelerations = answers.accelerations();
        assert_all_close(&accelerations, &solution.accelerations, TOLERANCE, name);
        let elements = case.chain.all_elements().zip(&solution.elements);
        let bodies = elements.filter(|(element, _)| matches!(element, Element::Body(_)));
        for (body, (element, points)) in bodies.enumerate() {
            let Element::Body(description) = element else { continue };
            let places = [[0.0; 3], description.output.position];
            for (at, number) in places.into_iter().zip([points.input, points.output]) {
                let point = &solution.points[number];
                let velocity = [point.velocity, point.angular_velocity].concat();
                assert_all_close(&answers.velocity(body, at), &velocity, TOLERANCE, name);
                let found = answers.acceleration(body, at, &accelerations);
                let expected = [point.acceleration, point.angular_acceleration].concat();
                assert_all_close(&found, &expected, TOLERANCE, name);
                // The Jacobian gives the change of the acceleration with the given accelerations.
                let still = answers.acceleration(body, at, &vec![0.0; accelerations.len()]);
                let by_rates = times(&answers.jacobian(body, at), &accelerations);
                let sum: Vec<f64> = by_rates.iter().zip(&still).map(|(a, b)| a + b).collect();
                assert_all_close(&sum, &found, 1e-13, name);
            }
        }
    }
}

/// Removes the rotors of all hinges.
fn without_rotors(case: &mut Case) {
    for element in case.chain.all_elements_mut() {
        if let Element::Hinge(Hinge { linear, turning, .. }) = element {
            linear.armature.clear();
            turning.armature.clear();
        }
    }
}

/// The parts of inverse dynamics: inertial parameters times regressor, springs and so on, and loads.
/// The entries have rounding errors of single operations.
#[test]
fn parts_add_up() {
    for mut case in cases() {
        without_rotors(&mut case);
        let (answers, mut random) = (answers(&case), Random::new(5));
        let accelerations = random_list(&mut random, case.state.v.len());
        let mut sum: Vec<f64> = answers.passive_efforts().iter().map(|effort| -effort).collect();
        let mut add = |by: f64, efforts: &[f64]| {
            sum.iter_mut().zip(efforts).for_each(|(sum, effort)| *sum += by * effort);
        };
        add(-1.0, &answers.load_efforts());
        let parameters = answers.inertial_parameters();
        for (columns, parameters) in answers.body_regressor(&accelerations).iter().zip(parameters) {
            columns.iter().zip(parameters).for_each(|(column, parameter)| add(parameter, column));
        }
        let expected = answers.inverse_dynamics(&accelerations);
        assert_all_close(&sum, &expected, 1e-12, &case.chain.name);
    }
}

/// Whether the motion of a hinge or of an end of the chain is prescribed.
fn is_prescribed(case: &Case) -> bool {
    let moving = |end: &End| matches!(end, End::Moving { .. });
    let starts = case.chain.later_routes.iter().map(|route| &route.start);
    starts.chain([&case.chain.start, &case.chain.finish]).any(moving)
        || case.chain.hinges().any(|hinge| hinge.prescribed)
}

#[test]
fn momenta_are_linear_in_the_rates() {
    for mut case in cases().filter(|case| !is_prescribed(case)) {
        without_rotors(&mut case);
        let (answers, v) = (answers(&case), &case.state.v);
        let momentum = answers.momentum();
        let found = times(&answers.momentum_matrix(), v);
        let expected = [momentum.linear, momentum.angular].concat();
        assert_all_close(&found, &expected, 1e-13, &case.chain.name);
        let energy = 0.5 * dot(v, &times(&answers.mass_matrix(), v));
        assert_close(energy, case.solve().kinetic_energy, TOLERANCE, &case.chain.name);
    }
}

/// The implicit function theorem: with the accelerations held, the efforts change by the change of the
/// motors' efforts if the accelerations change by `M⁻¹` times the difference.
#[test]
fn derivatives_of_accelerations_follow_from_those_of_efforts() {
    let mut tried = 0;
    for (number, case) in cases().filter(|case| !case.chain.closed()).enumerate() {
        let (answers, mut random) = (answers(&case), Random::new(number as u64));
        let count = case.state.v.len();
        let mut change = Change {
            coordinates: random_list(&mut random, count),
            rates: random_list(&mut random, count),
            gravity: [0.0; 3].map(|_: f64| random.between(-1.0, 1.0)),
            ..answers.no_change()
        };
        for load in &mut change.loads {
            let mut vector = || [0.0; 3].map(|_: f64| random.between(-1.0, 1.0));
            *load = LoadInput { force: vector(), torque: vector() };
        }
        change.actuators.iter_mut().for_each(|force| *force = random.between(-1.0, 1.0));
        let accelerations = answers.accelerations();
        let along = answers.accelerations_along(&change);
        let held = answers.inverse_dynamics_along(&accelerations, &change);
        let moved = times(&answers.mass_matrix(), &along);
        let sum: Vec<f64> = held.iter().zip(&moved).map(|(a, b)| a + b).collect();
        let scale = held.iter().fold(1.0_f64, |most, x| most.max(x.abs()));
        sum.iter().for_each(|sum| assert_close(sum / scale, 0.0, 1e-12, &case.chain.name));
        // Efforts of inverse dynamics are linear in the accelerations.
        let change = Change { accelerations: along.clone(), ..answers.no_change() };
        let found = answers.inverse_dynamics_along(&accelerations, &change);
        assert_all_close(&found, &moved, 1e-13, &case.chain.name);
        tried += 1;
    }
    assert!(tried > 150, "{tried} chains");
}
