//! Loads and springs on a body, implemented a second time for the tests.

use crate::samples::{Case, matrix};
use mstmm_reference::{Axes, Body, Point, Source, SpringEnd};
use nalgebra::Vector3;

/// Returns the force of all loads and springs on a body and their moment about the inertial origin,
/// given the motion of its input.
pub(crate) fn wrench_on(case: &Case, body: &Body, input: &Point) -> [Vector3<f64>; 2] {
    let mut total = [Vector3::zeros(); 2];
    for acting in acting_on(case, body, input) {
        total[0] += acting.force;
        total[1] += acting.couple + acting.position.cross(&acting.force);
    }
    total
}

/// Returns the power of all loads on a body and of the dampers of its springs.
pub(crate) fn power_on(case: &Case, body: &Body, input: &Point) -> f64 {
    let spin = Vector3::from(input.angular_velocity);
    let power = |acting: BodyLoad| {
        acting.force_without_potential.dot(&acting.velocity) + acting.couple.dot(&spin)
    };
    acting_on(case, body, input).into_iter().map(power).sum()
}

/// A load or a spring.
struct BodyLoad {
    position: Vector3<f64>,
    velocity: Vector3<f64>,
    force: Vector3<f64>,
    force_without_potential: Vector3<f64>,
    couple: Vector3<f64>,
}

fn acting_on(case: &Case, body: &Body, input: &Point) -> Vec<BodyLoad> {
    let rotation = matrix(&input.rotation);
    let spin = Vector3::from(input.angular_velocity);
    let mut all = Vec::new();
    let motion = |at: [f64; 3]| {
        let arm = rotation * Vector3::from(at);
        (Vector3::from(input.position) + arm, Vector3::from(input.velocity) + spin.cross(&arm))
    };
    for (load, given) in case.chain.loads.iter().zip(&case.drives.loads) {
        let vector = |source: &Source<[f64; 3]>, given: [f64; 3]| {
            let own = match source {
                Source::None => Vector3::zeros(),
                Source::Constant(constant) => Vector3::from(*constant),
                Source::Input => Vector3::from(given),
            };
            if load.axes == Axes::Body { rotation * own } else { own }
        };
        if load.body == body.name {
            let (position, velocity) = motion(load.at.position(body));
            let (force, couple) =
                (vector(&load.force, given.force), vector(&load.torque, given.torque));
            all.push(BodyLoad {
                position,
                velocity,
                force,
                force_without_potential: force,
                couple,
            });
        }
    }
    for spring in case.chain.springs.iter().filter(|spring| spring.body == body.name) {
        let SpringEnd::Ground(to) = spring.to else { continue };
        let (position, velocity) = motion(spring.at.position(body));
        let from_ground = position - Vector3::from(to);
        let direction = from_ground.normalize();
        let pull = direction * (spring.stiffness * (from_ground.norm() - spring.length));
        let damping = direction * (spring.damping * direction.dot(&velocity));
        let (force, couple) = (-pull - damping, Vector3::zeros());
        all.push(BodyLoad { position, velocity, force, force_without_potential: -damping, couple });
    }
    all
}
