//! The internal loads at the connection points, compared with the motions of the bodies.

use crate::graph::{Graph, Spot};
use crate::loads::wrench_on;
use crate::samples::{
    Case, assert_close, central_inertia, gravity, matrix, plain_cases, rich_cases,
};
use crate::trees::{large_trees, trees};
use mstmm_reference::{
    Body, Dimension, Drives, End, Group, Point, Solution, Source, Spring, SpringEnd, State,
};
use nalgebra::{Matrix3, Vector3};

/// Chains of one route.
fn chains() -> impl Iterator<Item = Case> {
    plain_cases().into_iter().chain(rich_cases())
}

fn cases() -> impl Iterator<Item = Case> {
    chains().chain(trees())
}

/// Returns the acceleration of a body's centre of mass, computed from its input point.
fn com_acceleration(body: &Body, input: &Point) -> Vector3<f64> {
    let arm = matrix(&input.rotation) * Vector3::from(body.com);
    let spin = Vector3::from(input.angular_velocity);
    Vector3::from(input.acceleration)
        + Vector3::from(input.angular_acceleration).cross(&arm)
        + spin.cross(&spin.cross(&arm))
}

/// Returns the relevant part of a body's inertia, about its centre of mass.
fn counting_inertia(case: &Case, body: &Body) -> Matrix3<f64> {
    match case.chain.dimension {
        Dimension::Space => central_inertia(body),
        Dimension::Plane => {
            Matrix3::from_diagonal(&Vector3::new(0.0, 0.0, central_inertia(body)[(2, 2)]))
        }
        Dimension::Line => Matrix3::zeros(),
    }
}

/// Every body fulfils Newton's and Euler's equations about the inertial origin under its weight, the
/// external loads, the load at its input and those of the hinges that leave it.
#[test]
fn every_body_is_in_balance() {
    for case in cases() {
        check_balances(&case, 1e-11);
    }
}

/// The errors of the reference are roundings, also with many bodies.
#[test]
fn large_trees_are_in_balance_to_rounding() {
    for case in large_trees() {
        check_balances(&case, 1e-13);
    }
}

fn check_balances(case: &Case, tolerance: f64) {
    let solution = case.solve();
    let graph = Graph::new(&case.chain);
    for (number, body) in case.chain.bodies().enumerate() {
        let input = graph.input(&solution, number);
        let rotation = matrix(&input.rotation);
        let com = Vector3::from(input.position) + rotation * Vector3::from(body.com);
        let acceleration = com_acceleration(body, input);
        let [outside, outside_moment] = wrench_on(case, &solution, number);
        let weight = gravity(case) * body.mass;
        let inertia = rotation * counting_inertia(case, body) * rotation.transpose();
        let spin = Vector3::from(input.angular_velocity);
        let momentum_rate = com.cross(&(acceleration * body.mass))
            + inertia * Vector3::from(input.angular_acceleration)
            + spin.cross(&(inertia * spin));

        let force_in = Vector3::from(input.force);
        let mut newton = force_in + weight + outside - acceleration * body.mass;
        let mut moment = Vector3::from(input.position).cross(&force_in)
            - Vector3::from(input.moment)
            + com.cross(&weight)
            + outside_moment;
        for ([inboard, _], load) in graph.hinges.iter().zip(&solution.hinge_loads) {
            if graph.body(*inboard) == Some(number) {
                let (force, point) = (Vector3::from(load.force), &solution.points[*inboard]);
                newton -= force;
                moment += Vector3::from(load.moment) - Vector3::from(point.position).cross(&force);
            }
        }

        let scale = 1.0 + force_in.norm() + momentum_rate.norm();
        let context = format!("{} {}", case.chain.name, body.name);
        assert!(newton.norm() < tolerance * scale, "{context}: {newton}");
        let turning = (moment - momentum_rate).norm();
        assert!(turning < tolerance * scale || is_line(case), "{context}: {turning:e}");
    }
}

/// The load at an output, a named point or a start is the sum over the hinges that begin there.
#[test]
fn points_have_the_loads_of_their_hinges() {
    for case in cases() {
        let solution = case.solve();
        let graph = Graph::new(&case.chain);
        assert_eq!(solution.points.len(), graph.spots.len());
        for (spot, point) in graph.spots.iter().zip(&solution.points) {
            let begins = |hinge: &usize| match spot {
                Spot::Share(number, _) => hinge == number,
                _ => graph.starts[*hinge] == *spot,
            };
            let is_input = matches!(spot, Spot::On(_, place) if place == "input");
            if is_input || *spot == Spot::Finish {
                continue;
            }
            let mut rest = (Vector3::from(point.force), Vector3::from(point.moment));
            let scale = 1.0 + rest.0.norm() + rest.1.norm();
            for hinge in (0..graph.hinges.len()).filter(begins) {
                rest.0 -= Vector3::from(solution.hinge_loads[hinge].force);
                rest.1 -= Vector3::from(solution.hinge_loads[hinge].moment);
            }
            let rest = rest.0.norm() + rest.1.norm();
            assert!(rest < 1e-13 * scale, "{} {spot:?}: {rest:e}", case.chain.name);
        }
    }
}

/// Returns whether the chain is a line chain, in which moments are ignored.
fn is_line(case: &Case) -> bool {
    case.chain.dimension == Dimension::Line
}

/// A hinge without springs, dampers and so on transmits the effort of its motor or drive along each
/// of its rates, and both its points carry the same wrench.
#[test]
fn hinges_pass_on_their_efforts() {
    let open = |case: &Case| !case.chain.closed();
    for case in cases().filter(open) {
        let solution = case.solve();
        let graph = Graph::new(&case.chain);
        let (mut rate, mut motion) = (case.chain.base_dof_count(), 0);
        let hinges = case.chain.hinges().zip(&graph.hinges).enumerate();
        for ((number, (hinge, [from, to])), efforts) in hinges.zip(&solution.efforts) {
            let (inboard, outboard) = (&solution.points[*from], &solution.points[*to]);
            let at_inboard = &solution.hinge_loads[number];
            let between = Vector3::from(outboard.position) - Vector3::from(inboard.position);
            let (force, moment) = (Vector3::from(outboard.force), -Vector3::from(outboard.moment));
            let carried = -(moment + between.cross(&force)) - Vector3::from(at_inboard.moment);
            assert_eq!(at_inboard.force, outboard.force);
            assert!(carried.norm() < 1e-11 * (1.0 + moment.norm()), "{}", case.chain.name);

            let motors = |group: &Group| Group { motor: Source::None, ..group.clone() };
            let idle = [&hinge.linear, &hinge.turning].iter().all(|g| motors(g).is_empty());
            for (number, effort) in efforts.iter().enumerate().filter(|_| idle) {
                let alone = only(&case, hinge.prescribed, rate + number, [motion, number]);
                let (inboard, outboard) = (&alone.points[*from], &alone.points[*to]);
                let velocity = Vector3::from(outboard.velocity)
                    - Vector3::from(inboard.velocity)
                    - Vector3::from(inboard.angular_velocity).cross(&between);
                let spin = Vector3::from(outboard.angular_velocity)
                    - Vector3::from(inboard.angular_velocity);
                let passed_on = force.dot(&velocity) + moment.dot(&spin);
                let tolerance = 1e-11 * (1.0 + force.norm() + moment.norm());
                assert_close(passed_on, *effort, tolerance, &case.chain.name);
            }
            rate += hinge.dof_count();
            motion += usize::from(hinge.prescribed);
        }
    }
}

/// Solves the case with one rate equal to 1 and all others 0.
fn only(case: &Case, prescribed: bool, rate: usize, place: [usize; 2]) -> Solution {
    let mut state = State { v: vec![0.0; case.state.v.len()], ..case.state.clone() };
    let mut drives = case.drives.clone();
    for motion in &mut drives.motions {
        motion.v.fill(0.0);
    }
    if prescribed {
        drives.motions[place[0]].v[place[1]] = 1.0;
    } else {
        state.v[rate] = 1.0;
    }
    case.chain.solve_driven(&state, &drives)
}

/// Free ends carry no load, the ground does not move, and moving ends move as prescribed.
#[test]
fn ends_are_as_described() {
    for case in chains() {
        let solution = case.solve();
        assert_eq!(solution.points.len(), case.chain.elements.len() + 1);
        let Drives { start, finish, .. } = &case.drives;
        let first = (&case.chain.start, &solution.points[0], start);
        let last = (&case.chain.finish, &solution.points[case.chain.elements.len()], finish);
        for (end, point, motion) in [first, last] {
            match end {
                End::Free => assert_eq!([point.force, point.moment], [[0.0; 3]; 2]),
                End::Held(frame) => {
                    assert_eq!(point.position, frame.position);
                    assert_eq!(point.rotation, frame.rotation());
                    let rates = [point.velocity, point.angular_velocity];
                    let accelerations = [point.acceleration, point.angular_acceleration];
                    assert_eq!([rates, accelerations], [[[0.0; 3]; 2]; 2]);
                }
                End::Place(_) => unreachable!("a chain of one route"),
                End::Moving { .. } => {
                    assert_eq!(point.position, motion.position);
                    assert_eq!(point.velocity, motion.velocity);
                    assert_eq!(point.acceleration, motion.acceleration);
                    let rotation = matrix(&point.rotation);
                    let own = [
                        (point.angular_velocity, motion.rate),
                        (point.angular_acceleration, motion.rate_derivative),
                    ];
                    for (inertial, own) in own {
                        let turned = rotation * Vector3::from(own) - Vector3::from(inertial);
                        assert!(turned.norm() < 1e-14, "{}", case.chain.name);
                    }
                }
            }
        }
    }
}

/// The common centre of mass of a floating chain falls freely, whatever acts inside the chain.
#[test]
fn floating_chains_fall_freely() {
    let inner = |case: &Case| {
        let to_bodies = |spring: &Spring| matches!(spring.to, SpringEnd::Body { .. });
        let starts = case.chain.later_routes.iter().map(|route| &route.start);
        let branches = starts.into_iter().all(|start| matches!(start, End::Place(_)));
        branches && case.chain.loads.is_empty() && case.chain.springs.iter().all(to_bodies)
    };
    for case in cases().filter(|case| case.chain.floats()).filter(inner) {
        let solution = case.solve();
        let graph = Graph::new(&case.chain);
        let mut excess = Vector3::zeros();
        for (number, body) in case.chain.bodies().enumerate() {
            let acceleration = com_acceleration(body, graph.input(&solution, number));
            excess += (acceleration - gravity(&case)) * body.mass;
        }
        assert!(excess.norm() < 1e-10, "{}: {excess}", case.chain.name);
    }
}
