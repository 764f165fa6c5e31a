//! Laws of mechanics that the answers obey: homogeneity in the rates, reversal of time, power, and changes of the frame
//! of reference.

use crate::common::given::Given;
use crate::differences::{Asked, Direction};
use crate::products::push;
use crate::samples::{Kind, Sample, dot, largest, samples};
use mstmm_codegen::compile::outputs;
use mstmm_codegen::ids::InputId;
use mstmm_codegen::model::{Answer, InputKind, Layout};
use mstmm_codegen::program::{Argument, Given as Vector};
use mstmm_reference::{Dimension, Gravity};

/// The tolerance relative to the scale that a test states. Solutions lose as many digits as the condition number of
/// the mass matrix has, at most four here.
const TOLERANCE: f64 = 1e-11;

const ANSWERS: &str = "[inverse_dynamics, mass_matrix, push]";

/// Returns the arguments with other rates.
fn at_rates<'a>(sample: &'a Sample, rates: &[f64]) -> Given<'a, f64> {
    let mut given = sample.given::<f64>();
    given.arrays.arguments.insert(Argument::Rates, rates.to_vec());
    given
}

fn negative(values: &[f64]) -> Vec<f64> {
    values.iter().map(|value| -value).collect()
}

/// The velocity terms are quadratic in the rates, so their derivative along the rates is twice themselves [Euler].
#[test]
fn velocity_terms_are_quadratic() {
    for sample in samples(Kind::Bare, 0..40, ANSWERS) {
        let (given, v) = (sample.given::<f64>(), &sample.state.v);
        let direction = Direction { rates: v.clone(), ..sample.no_direction() };
        let [accelerations, change] = push(&sample, &given, &direction);
        let mass = (Answer::MassMatrixTimes, outputs::PRODUCT);
        let found = sample.ask(&given, mass, &[(Vector::Vector, &change)]);
        let bias = sample.ask(&given, (Answer::BiasEfforts, outputs::BIAS_EFFORTS), &[]);
        let gravity = sample.ask(&given, (Answer::GravityEfforts, outputs::EFFORTS), &[]);
        let twice: Vec<f64> = bias.iter().zip(&gravity).map(|(b, g)| -2.0 * (b - g)).collect();
        let scale = largest(&found).max(largest(&bias)).max(largest(&accelerations));
        sample.check("M ∂v̇/∂v v", (&found, &twice), scale, TOLERANCE);
    }
}

/// Backwards in time the accelerations are the same, so their derivatives along the coordinates are even in the
/// rates, and those along the rates are odd.
#[test]
fn derivatives_are_even_or_odd_in_the_rates() {
    for sample in samples(Kind::Bare, 100..140, ANSWERS) {
        let [here, back] = [sample.state.v.clone(), negative(&sample.state.v)]
            .map(|rates| at_rates(&sample, &rates));
        let along = sample.random_rates(3);
        for (what, sign) in [("coordinates", 1.0), ("rates", -1.0)] {
            let mut direction = sample.no_direction();
            let own = if sign > 0.0 { &mut direction.coordinates } else { &mut direction.rates };
            *own = along.clone();
            let [[one, forth], [two, change]] =
                [&here, &back].map(|it| push(&sample, it, &direction));
            let scale = largest(&forth).max(largest(&one));
            sample.check("accelerations", (&two, &one), scale, TOLERANCE);
            let expected: Vec<f64> = forth.iter().map(|entry| sign * entry).collect();
            sample.check(what, (&change, &expected), scale, TOLERANCE);
        }
    }
}

/// The power of the drives at any accelerations is the derivative of the energy.
#[test]
fn power_changes_the_energy() {
    for sample in samples(Kind::Bare, 200..240, ANSWERS) {
        let (given, v) = (sample.given::<f64>(), &sample.state.v);
        let a = sample.random_rates(4);
        let inverse = (Answer::InverseDynamics, outputs::EFFORTS);
        let efforts = sample.ask(&given, inverse, &[(Vector::Accelerations, &a)]);
        let asked = Asked { answer: Answer::Energy, id: outputs::ENERGIES, accelerations: None };
        let along = Direction { coordinates: v.clone(), rates: a, ..sample.no_direction() };
        let change = sample.difference(&asked, &along);
        let power = dot(v, &efforts);
        let scale = largest(&efforts).max(largest(&change));
        sample.check("power", (&[power], &[change[0] + change[1]]), scale, TOLERANCE);
    }
}

/// Returns the direction along entries of the motion of the frame that carries the chain, and of gravity.
fn of_frame(sample: &Sample, motion: &[f64], gravity: &[f64]) -> Direction {
    let layout = Layout::of(&sample.chain);
    let inputs = sample.joined_inputs(|id: InputId| match layout.inputs[id].what {
        InputKind::Motion(_) => motion.to_vec(),
        InputKind::Gravity => gravity.to_vec(),
        _ => vec![0.0; layout.inputs[id].range.len()],
    });
    Direction { inputs, ..sample.no_direction() }
}

/// Accelerations are blind to the position of the frame and to its velocity [Galilei]. An acceleration of the
/// frame acts like gravity in the other direction.
#[test]
fn frames_in_uniform_motion_are_equivalent() {
    for sample in samples(Kind::Carried, 300..340, ANSWERS) {
        let given = sample.given::<f64>();
        let (count, coordinates, rates) = match sample.truth.dimension {
            Dimension::Space => (3, 7, 6),
            Dimension::Plane => (2, 3, 3),
            Dimension::Line => (1, 1, 1),
        };
        let vector: Vec<f64> = [0.7, -0.4, 0.9][..count].to_vec();
        let at = |first: usize| {
            let mut motion = vec![0.0; coordinates + 2 * rates];
            motion[first..first + count].copy_from_slice(&vector);
            motion
        };
        let none = vec![0.0; count];
        for (what, direction) in [
            ("position", of_frame(&sample, &at(0), &none)),
            ("velocity", of_frame(&sample, &at(coordinates), &none)),
            ("acceleration", of_frame(&sample, &at(coordinates + rates), &vector)),
        ] {
            let [accelerations, change] = push(&sample, &given, &direction);
            let none = vec![0.0; change.len()];
            sample.check(what, (&change, &none), largest(&accelerations), TOLERANCE);
        }
        let [_, change] =
            push(&sample, &given, &of_frame(&sample, &vec![0.0; coordinates + 2 * rates], &vector));
        assert!(change.iter().any(|entry| entry.abs() > 1e-3), "{}", sample.named("gravity"));
    }
}

/// A rotation of a floating tree about the direction of gravity turns the acceleration of its base and changes no
/// other acceleration.
#[test]
fn directions_across_gravity_are_equivalent() {
    let mut tried = 0;
    for sample in samples(Kind::Bare, 400..520, ANSWERS) {
        if !sample.truth.floats() || sample.truth.dimension != Dimension::Space {
            continue;
        }
        let Gravity::Constant(gravity) = sample.truth.gravity else {
            panic!("{}", sample.named("gravity is an input"))
        };
        tried += 1;
        let (given, q, v) = (sample.given::<f64>(), &sample.state.q, &sample.state.v);
        let turned = |b: &[f64]| {
            let a = gravity;
            [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
        };
        let mut direction = sample.no_direction();
        direction.coordinates[..3].copy_from_slice(&turned(q));
        direction.rates[..3].copy_from_slice(&turned(v));
        // The angular displacement has body axes.
        let rotation = rows(&q[3..7]);
        let own = |k: usize| -> f64 { (0..3).map(|row| rotation[row][k] * gravity[row]).sum() };
        direction.coordinates[3..6].copy_from_slice(&[0, 1, 2].map(own));
        let [accelerations, change] = push(&sample, &given, &direction);
        let mut expected = vec![0.0; change.len()];
        expected[..3].copy_from_slice(&turned(&accelerations));
        let scale = largest(&accelerations) * largest(&gravity);
        sample.check("turned", (&change, &expected), scale, TOLERANCE);
    }
    assert!(tried > 15, "{tried} trees");
}

/// Returns the rotation matrix of a unit quaternion (w, x, y, z).
fn rows(q: &[f64]) -> [[f64; 3]; 3] {
    let [w, x, y, z] = [q[0], q[1], q[2], q[3]];
    [
        [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
        [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
        [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)],
    ]
}
