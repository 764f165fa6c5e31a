//! Loads and springs on a body, implemented a second time for the tests.

use crate::graph::Graph;
use crate::samples::{Case, matrix};
use mstmm_reference::{Axes, BodyPoint, Point, Solution, Source, Spring, SpringEnd};
use nalgebra::Vector3;

/// Returns the force of all loads and springs on a body, given by its number, and their moment about
/// the inertial origin.
pub(crate) fn wrench_on(case: &Case, solution: &Solution, body: usize) -> [Vector3<f64>; 2] {
    let mut total = [Vector3::zeros(); 2];
    for acting in acting_on(case, solution, body) {
        total[0] += acting.force;
        total[1] += acting.couple + acting.position.cross(&acting.force);
    }
    total
}

/// Returns the power of all loads on a body and of the dampers of its springs.
pub(crate) fn power_on(case: &Case, solution: &Solution, body: usize) -> f64 {
    let input = Graph::new(&case.chain).input(solution, body);
    let spin = Vector3::from(input.angular_velocity);
    let power = |acting: BodyLoad| {
        acting.force_without_potential.dot(&acting.velocity) + acting.couple.dot(&spin)
    };
    acting_on(case, solution, body).into_iter().map(power).sum()
}

/// A load or a spring.
struct BodyLoad {
    position: Vector3<f64>,
    velocity: Vector3<f64>,
    force: Vector3<f64>,
    force_without_potential: Vector3<f64>,
    couple: Vector3<f64>,
}

/// Returns the position and the velocity of a point of a body, given the motion of its input.
fn motion_of(at: [f64; 3], input: &Point) -> [Vector3<f64>; 2] {
    let arm = matrix(&input.rotation) * Vector3::from(at);
    let spin = Vector3::from(input.angular_velocity);
    [Vector3::from(input.position) + arm, Vector3::from(input.velocity) + spin.cross(&arm)]
}

/// Returns the positions and the velocities of both ends of a spring, that on its own body first.
pub(crate) fn ends_of(case: &Case, solution: &Solution, spring: &Spring) -> [[Vector3<f64>; 2]; 2] {
    let graph = Graph::new(&case.chain);
    let end = |name: &str, at: &BodyPoint| {
        let mut bodies = case.chain.bodies().enumerate();
        let (number, body) = bodies.find(|(_, body)| body.name == name).expect("the body");
        motion_of(at.position(body), graph.input(solution, number))
    };
    let to = match &spring.to {
        SpringEnd::Ground(position) => [Vector3::from(*position), Vector3::zeros()],
        SpringEnd::Body { body, at } => end(body, at),
    };
    [end(&spring.body, &spring.at), to]
}

fn acting_on(case: &Case, solution: &Solution, number: usize) -> Vec<BodyLoad> {
    let body = case.chain.bodies().nth(number).expect("a body of this number");
    let input = Graph::new(&case.chain).input(solution, number);
    let rotation = matrix(&input.rotation);
    let mut all = Vec::new();
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
            let [position, velocity] = motion_of(load.at.position(body), input);
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
    for (spring, &input) in case.chain.springs.iter().zip(&case.drives.springs) {
        let ends = ends_of(case, solution, spring);
        let on_this = spring.body == body.name;
        let to_this = matches!(&spring.to, SpringEnd::Body { body: to, .. } if *to == body.name);
        for [own, other] in [(on_this, ends), (to_this, [ends[1], ends[0]])]
            .into_iter()
            .filter(|(acts, _)| *acts)
            .map(|(_, ends)| ends)
        {
            let between = own[0] - other[0];
            let direction = between.normalize();
            let pull = direction * (spring.stiffness * (between.norm() - spring.length));
            let rate = direction.dot(&(own[1] - other[1]));
            let damping = direction * (spring.damping * rate);
            let push = direction * spring.actuator(input);
            all.push(BodyLoad {
                position: own[0],
                velocity: own[1],
                force: push - pull - damping,
                force_without_potential: push - damping,
                couple: Vector3::zeros(),
            });
        }
    }
    all
}
