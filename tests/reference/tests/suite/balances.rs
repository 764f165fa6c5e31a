//! The internal loads reported at the connection points, weighed against the bodies' motions.

use crate::samples::{Case, assert_close, central_inertia, matrix, random_cases};
use mstmm_reference::{Body, Element, End, HingeKind, Point, Solution};
use nalgebra::Vector3;

fn solve(case: &Case) -> Solution {
    case.chain.solve(&case.state, &case.efforts)
}

/// Returns the acceleration of a body's centre of mass, reckoned from its input point.
fn com_acceleration(body: &Body, input: &Point) -> Vector3<f64> {
    let arm = matrix(&input.rotation) * Vector3::from(body.com);
    let spin = Vector3::from(input.angular_velocity);
    Vector3::from(input.acceleration)
        + Vector3::from(input.angular_acceleration).cross(&arm)
        + spin.cross(&spin.cross(&arm))
}

/// Every body obeys Newton and Euler under its weight and the loads at its two ends, about a point
/// that has nothing to do with it: the inertial origin.
#[test]
fn every_body_is_in_balance() {
    for case in random_cases() {
        let solution = solve(&case);
        for (k, element) in case.chain.elements.iter().enumerate() {
            let Element::Body(body) = element else { continue };
            let (input, output) = (&solution.points[k], &solution.points[k + 1]);
            let rotation = matrix(&input.rotation);
            let com = Vector3::from(input.position) + rotation * Vector3::from(body.com);
            let acceleration = com_acceleration(body, input);
            let weight = Vector3::from(case.chain.gravity) * body.mass;

            let (force_in, force_out) = (Vector3::from(input.force), Vector3::from(output.force));
            let newton = force_in - force_out + weight - acceleration * body.mass;

            let inertia = rotation * central_inertia(body) * rotation.transpose();
            let spin = Vector3::from(input.angular_velocity);
            let momentum_rate = com.cross(&(acceleration * body.mass))
                + inertia * Vector3::from(input.angular_acceleration)
                + spin.cross(&(inertia * spin));
            let moment = Vector3::from(output.moment) - Vector3::from(input.moment)
                + Vector3::from(input.position).cross(&force_in)
                - Vector3::from(output.position).cross(&force_out)
                + com.cross(&weight);

            let scale = 1.0 + force_in.norm() + momentum_rate.norm();
            let context = format!("{} {}", case.chain.name, body.name);
            assert!(newton.norm() < 1e-11 * scale, "{context}: {newton}");
            assert!((moment - momentum_rate).norm() < 1e-11 * scale, "{context}: {moment}");
        }
    }
}

/// Hinges pass loads on, hold their points together, and carry along their freedoms nothing but
/// what the motor gives.
#[test]
fn hinges_keep_their_word() {
    for case in random_cases() {
        let solution = solve(&case);
        let mut efforts = case.efforts.iter().skip(if case.chain.floats() { 6 } else { 0 });
        for (k, element) in case.chain.elements.iter().enumerate() {
            let Element::Hinge(hinge) = element else { continue };
            let (inboard, outboard) = (&solution.points[k], &solution.points[k + 1]);
            assert_eq!(inboard.force, outboard.force);
            assert_eq!(inboard.moment, outboard.moment);
            let pairs = [
                (inboard.position, outboard.position),
                (inboard.velocity, outboard.velocity),
                (inboard.acceleration, outboard.acceleration),
            ];
            for (a, b) in pairs {
                (0..3).for_each(|i| assert_close(a[i], b[i], 1e-11, &case.chain.name));
            }
            let moment = matrix(&outboard.rotation).transpose() * Vector3::from(outboard.moment);
            match hinge.kind {
                HingeKind::Weld => {}
                HingeKind::Pin { axis } => {
                    let along = -moment.dot(&Vector3::from(axis).normalize());
                    assert_close(along, *efforts.next().unwrap(), 1e-11, &case.chain.name);
                }
                HingeKind::Ball => {
                    for component in moment.iter() {
                        let effort = *efforts.next().unwrap();
                        assert_close(-component, effort, 1e-11, &case.chain.name);
                    }
                }
            }
        }
    }
}

/// Ends that are free carry nothing, and ground does not move.
#[test]
fn ends_are_as_described() {
    for case in random_cases() {
        let solution = solve(&case);
        assert_eq!(solution.points.len(), case.chain.elements.len() + 1);
        let first = (&case.chain.start, &solution.points[0]);
        let last = (&case.chain.finish, &solution.points[case.chain.elements.len()]);
        for (end, point) in [first, last] {
            match end {
                End::Free => assert_eq!([point.force, point.moment], [[0.0; 3]; 2]),
                End::Held(frame) => {
                    assert_eq!(point.position, frame.position);
                    assert_eq!(point.rotation, frame.rotation());
                    let rates = [point.velocity, point.angular_velocity];
                    let accelerations = [point.acceleration, point.angular_acceleration];
                    assert_eq!([rates, accelerations], [[[0.0; 3]; 2]; 2]);
                }
            }
        }
    }
}

/// Nothing inside a floating chain moves its common centre of mass off its free fall.
#[test]
fn floating_chains_fall_freely() {
    for case in random_cases().iter().filter(|case| case.chain.floats()) {
        let solution = solve(case);
        let mut excess = Vector3::zeros();
        for (k, element) in case.chain.elements.iter().enumerate() {
            if let Element::Body(body) = element {
                let acceleration = com_acceleration(body, &solution.points[k]);
                excess += (acceleration - Vector3::from(case.chain.gravity)) * body.mass;
            }
        }
        assert!(excess.norm() < 1e-10, "{}: {excess}", case.chain.name);
    }
}
