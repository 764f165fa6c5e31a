//! Compares the paper's elastic hinge, with springs and dampers as loads on the bodies at both sides of an acceleration
//! hinge, with the compiler's.

mod common;

use common::paper::{Case, Hinges, declared, list, matrix, plain, reported};
use common::{Point, compute, read};
use mstmm_codegen::equations::Axes;
use mstmm_codegen::math::Structured;
use mstmm_codegen::model::SolutionMethod;
use mstmm_reference::Random;
use mstmm_runtime::nalgebra::{Matrix3, Vector3};
use mstmm_runtime::paper::body::{Body, Load, Motion};
use mstmm_runtime::paper::elastic::{self, Springs};
use mstmm_runtime::paper::{acceleration_hinge, rotation, state};

const CASES: u64 = 25;

type Plain = Structured<f64>;

const ROUND: Springs<f64> = Springs {
    stiffness: Vector3::new(30.0, 30.0, 50.0),
    damping: Vector3::new(0.0, 0.0, 2.0),
    turning_stiffness: Vector3::new(5.0, 7.0, 9.0),
    turning_damping: Vector3::new(0.3, 0.4, 0.5),
};

/// (53), (54) and (66): torque, force and accelerations of an elastic hinge, if θ_x and θ_y vanish and the springs across ζ
/// are equal.
#[test]
fn elastic_hinges() {
    for seed in 0..CASES {
        let apart = elastic_chain(seed, &ROUND, 0.0, |springs| springs.torque);
        assert!(apart.amax() < 1e-12, "seed {seed}: {apart:?}");
    }
}

/// The terms that the torque of (54) omits: the axis of θ̇_x is rotated by θ_y, and different springs across ζ exert a torque
/// towards the softest direction.
#[test]
fn elastic_hinges_with_any_turns() {
    let any = Springs {
        stiffness: Vector3::new(30.0, 80.0, 50.0),
        damping: Vector3::new(1.0, 3.0, 2.0),
        ..ROUND
    };
    for seed in 0..CASES {
        let apart = elastic_chain(seed, &any, 1.0, |springs| springs.complete);
        assert!(apart.amax() < 1e-12, "seed {seed}: {apart:?}");
        let printed = elastic_chain(seed, &any, 1.0, |springs| springs.torque);
        assert!(printed.x < 1e-12 && printed.y > 1e-3, "seed {seed}: {printed:?}");
    }
}

/// Returns the largest difference of force, torque and accelerations of two bodies on elastic hinges from the reported ones,
/// with angles θ_x, θ_y of the given size.
fn elastic_chain(
    seed: u64,
    springs: &Springs<f64>,
    turns: f64,
    torque: fn(&Exerted) -> Vector3<f64>,
) -> Vector3<f64> {
    let mut random = Random::new(seed);
    let case = Case::random(&mut random, Hinges::Floating, 2);
    let types: String = (0..2).map(|k| declared(k, &case.bodies[k])).collect();
    let text = format!(
        "chain Soft {{ {types} ground -> elastic j0 -> B0 b0 -> elastic j1 -> B1 b1;
        hinge j0, j1 {{ stiffness = {} N/m; damping = {} N*s/m; turning_stiffness = {} N*m/rad;
        turning_damping = {} N*m*s/rad; }} }}",
        list(&springs.stiffness),
        list(&springs.damping),
        list(&springs.turning_stiffness),
        list(&springs.turning_damping)
    );
    let mut q: Vec<f64> = (0..12).map(|_| random.between(-1.0, 1.0)).collect();
    for small in [3, 4, 9, 10] {
        q[small] *= turns;
    }
    let v: Vec<f64> = (0..12).map(|_| random.between(-1.0, 1.0)).collect();
    let way = (SolutionMethod::Riccati, Axes::Body);
    let computed = compute::<f64>(&read(&text), way, &q, &v, &[0.0; 12]);
    let points = &computed.report.points;

    let mut apart = Vector3::<f64>::zeros();
    let mut loads = [Load { force: Vector3::zeros(), moment: Vector3::zeros() }; 2];
    for k in 0..2 {
        let (input, output) = (&points[2 * k], &points[2 * k + 1]);
        let spring = Exerted::of(springs, input, output);
        let torque = torque(&spring);
        let z = state::blocks(&reported(output));
        apart.x = apart.x.max((spring.force - z.force()).norm() / z.force().norm());
        apart.y = apart.y.max((torque - z.moment()).norm() / z.moment().norm());
        let at = plain(output.position);
        act(&mut loads[k], &case.bodies[k], output, at, (spring.force, -torque));
        if k == 1 {
            act(&mut loads[0], &case.bodies[0], &points[1], at, (-spring.force, torque));
        }
    }
    for k in 0..2 {
        let point = &points[2 * k + 1];
        let motion =
            Motion { orientation: matrix(point.rotation), angular_velocity: plain(point.omega) };
        let body = case.bodies[k].blocks(&motion, &loads[k]).transfer_matrix();
        let hinge = acceleration_hinge::Blocks::of(&body).transfer_matrix();
        // Inboard of the hinge there is neither force nor moment, since both are loads.
        let mut z = reported(&points[2 * k]);
        z.fixed_rows_mut::<6>(6).fill(0.0);
        let (found, expected) = (hinge * z, reported(point));
        let distance = (found.fixed_rows::<6>(0) - expected.fixed_rows::<6>(0)).norm();
        apart.z = apart.z.max(distance / expected.fixed_rows::<6>(0).norm());
        assert!((body * found).fixed_rows::<6>(6).norm() < 1e-10);
    }
    apart
}

/// Returns what springs between two points exert, in the inertial frame: the force on the outboard body at its input, and the
/// torque on the inboard body, as in (54) and with the terms that (54) omits.
struct Exerted {
    force: Vector3<f64>,
    torque: Vector3<f64>,
    complete: Vector3<f64>,
}

impl Exerted {
    fn of(springs: &Springs<f64>, inboard: &Point<Plain>, outboard: &Point<Plain>) -> Self {
        let [first, second] = [inboard, outboard].map(|point| matrix(point.rotation));
        let relative = elastic::relative(&first, &second);
        let turns = elastic::turns(&relative);
        let omega = plain(outboard.omega) - plain(inboard.omega);
        let rate_matrix = rotation::rate_matrix(&turns);
        let rates =
            rate_matrix.lu().solve(&(second.transpose() * omega)).expect("a regular matrix");
        let third = first * rotation::rotation_matrix(&Vector3::new(0.0, 0.0, turns.z));
        // From O to I, in rotating axes.
        let shift = third.transpose() * (plain(inboard.position) - plain(outboard.position));
        let turning = third.transpose() * plain(inboard.omega) + Vector3::z() * rates.z;
        let speed = third.transpose() * (plain(inboard.velocity) - plain(outboard.velocity));
        let rate = speed - turning.cross(&shift);
        let (force, torque) = (springs.force(&shift, &rate), springs.torque(&turns, &rates));
        // From the power: m_z rotates the displacement, and m_x acts about the axis [cos θ_y, 0, −sin θ_y].
        let about = torque.z - Vector3::z().cross(&shift).dot(&force);
        let complete =
            Vector3::new((torque.x + turns.y.sin() * about) / turns.y.cos(), torque.y, about);
        Exerted { force: third * force, torque: third * torque, complete: third * complete }
    }
}

/// Adds a force at a point and a torque to the load at the centre of mass of a body whose input is `point`.
fn act(
    load: &mut Load<f64>,
    body: &Body<f64>,
    point: &Point<Plain>,
    at: Vector3<f64>,
    (force, torque): (Vector3<f64>, Vector3<f64>),
) {
    let turned: Matrix3<f64> = matrix(point.rotation);
    let arm = at - (plain(point.position) + turned * body.com);
    load.force += force;
    load.moment += torque + arm.cross(&force);
}
