//! Accelerations compared with differences of velocities, and efforts compared with differences of
//! energies.
//!
//! These tests connect the conventions of the hinge rates, the accelerations in these rates, the
//! accelerations of the connection points, and all efforts and loads.

use crate::graph::{Graph, Spot};
use crate::loads::power_on;
use crate::samples::{Case, assert_close, gravity, matrix, plain_cases, rich_cases};
use crate::trees::trees;
use mstmm_reference::{Gravity, Group, Hinge, Point, Solution};
use nalgebra::Vector3;

/// The time in s between two solutions.
const STEP: f64 = 2e-5;
/// The accuracy of [`slope`], also for fast chains.
const TOLERANCE: f64 = 2e-7;

/// Times near the present time.
const MOMENTS: [f64; 4] = [-2.0 * STEP, -STEP, STEP, 2.0 * STEP];

/// Returns the derivative at the present time from values at [`MOMENTS`]: two central differences,
/// extrapolated to a step of zero.
fn slope([before_2, before_1, after_1, after_2]: [f64; 4]) -> f64 {
    (8.0 * (after_1 - before_1) - (after_2 - before_2)) / (12.0 * STEP)
}

fn cases() -> impl Iterator<Item = Case> {
    plain_cases().into_iter().chain(rich_cases()).chain(trees())
}

/// Returns the case at [`MOMENTS`].
fn around(case: &Case, now: &Solution) -> [Case; 4] {
    MOMENTS.map(|t| {
        let drives = case.drives.moved(&case.chain, t);
        let mut state = case.chain.moved(&case.state, &now.accelerations, t);
        if case.chain.closed() {
            // The error is of third order.
            state = case.chain.close(&state, &drives).expect("a state that almost closes");
        }
        Case { chain: case.chain.clone(), state, drives }
    })
}

#[test]
fn points_accelerate_as_their_velocities_change() {
    for case in cases() {
        let now = case.solve();
        let around = around(&case, &now).map(|moment| moment.solve());
        for (number, now) in now.points.iter().enumerate() {
            let slope = |f: &dyn Fn(&Point) -> f64| {
                slope([0, 1, 2, 3].map(|moment| f(&around[moment].points[number])))
            };
            let name = &case.chain.name;
            let scale = 1.0 + now.acceleration.iter().map(|a| a.abs()).sum::<f64>();
            let tolerance = TOLERANCE * scale;
            for k in 0..3 {
                assert_close(slope(&|p| p.position[k]), now.velocity[k], tolerance, name);
                assert_close(slope(&|p| p.velocity[k]), now.acceleration[k], tolerance, name);
                let angular = now.angular_acceleration[k];
                assert_close(slope(&|p| p.angular_velocity[k]), angular, tolerance, name);
            }
        }
    }
}

/// Only motors, drives, moving ends, loads, gravity as an input, dampers and friction change the
/// energy.
#[test]
fn energy_changes_by_the_power_of_all_that_acts() {
    for case in cases() {
        let now = case.solve();
        let around = around(&case, &now);
        let energies = around.each_ref().map(|moment| {
            let solution = moment.solve();
            solution.kinetic_energy + solution.potential_energy
        });
        let rates = strain_rates(&case, &around);
        let power = power_of_efforts(&case, &now) - dissipation(&case, &rates)
            + power_at_ends(&case, &now)
            + power_of_loads(&case, &now);
        let tolerance = TOLERANCE * (1.0 + now.kinetic_energy);
        assert_close(slope(energies), power, tolerance, &case.chain.name);
    }
}

/// Returns the rates of all hinges, also of prescribed ones.
fn hinge_rates(case: &Case) -> Vec<Vec<f64>> {
    let mut free = case.state.v[case.chain.base_dof_count()..].iter().copied();
    let mut prescribed = case.drives.motions.iter();
    let of_hinge = |hinge: &Hinge| match hinge.prescribed {
        true => prescribed.next().unwrap().v.clone(),
        false => free.by_ref().take(hinge.kind.dof_count()).collect(),
    };
    case.chain.hinges().map(of_hinge).collect()
}

/// Returns the strain rates of all hinges: derivatives of coordinates, and angular velocities instead
/// of the derivatives of quaternions.
fn strain_rates(case: &Case, around: &[Case; 4]) -> Vec<Vec<f64>> {
    let of_hinge = |(number, (hinge, v)): (usize, (&Hinge, Vec<f64>))| {
        let q = around.each_ref().map(|moment| coordinates(moment, number));
        let slope = |k: usize| slope(q.each_ref().map(|q| q[k]));
        if hinge.kind.has_quaternion() {
            let shifts = hinge.kind.linear();
            let first = shifts.end;
            shifts.map(slope).chain(v[first..].iter().copied()).collect()
        } else {
            (0..v.len()).map(slope).collect()
        }
    };
    case.chain.hinges().zip(hinge_rates(case)).enumerate().map(of_hinge).collect()
}

fn power_of_efforts(case: &Case, now: &Solution) -> f64 {
    let rates = hinge_rates(case).concat();
    now.efforts.concat().iter().zip(&rates).map(|(effort, rate)| effort * rate).sum()
}

/// Returns the power that dampers, friction and limits dissipate.
fn dissipation(case: &Case, strain_rates: &[Vec<f64>]) -> f64 {
    let entry = |list: &[f64], k: usize| list.get(k).or(list.first()).copied().unwrap_or(0.0);
    let mut total = 0.0;
    for (number, (hinge, rates)) in case.chain.hinges().zip(strain_rates).enumerate() {
        for (is_turning, (group, own)) in hinge.groups().into_iter().enumerate() {
            let quaternion = is_turning == 1 && hinge.kind.has_quaternion();
            let rates = &rates[own.clone()];
            let speed = rates.iter().map(|rate| rate * rate).sum::<f64>().sqrt();
            for (k, rate) in rates.iter().enumerate() {
                let relevant = if quaternion { speed } else { *rate };
                let friction = if group.friction.is_empty() {
                    0.0
                } else {
                    entry(&group.friction, k) / relevant.hypot(group.friction_speed)
                };
                let limit = limit_damping(case, number, group, own.start + k, quaternion);
                total += (entry(&group.damping, k) + friction + limit) * rate * rate;
            }
        }
    }
    total
}

/// Returns the damping constant of a limit where it is exceeded.
fn limit_damping(case: &Case, number: usize, group: &Group, k: usize, quaternion: bool) -> f64 {
    let Some(limits) = &group.limits else { return 0.0 };
    let q = coordinates(case, number);
    let hinge = case.chain.hinges().nth(number).unwrap();
    let beyond = if quaternion {
        let first = hinge.kind.linear().end;
        let rest = hinge.rest_coordinates();
        let along: f64 = q[first..].iter().zip(&rest[first..]).map(|(a, b)| a * b).sum();
        let norm = |q: &[f64]| q.iter().map(|x| x * x).sum::<f64>().sqrt();
        let cosine = (along / norm(&q[first..]) / norm(&rest[first..])).abs();
        2.0 * cosine.acos() > limits.range[1]
    } else {
        q[k] < limits.range[0] || q[k] > limits.range[1]
    };
    if beyond { limits.damping } else { 0.0 }
}

/// Returns the coordinates of a hinge.
fn coordinates(case: &Case, number: usize) -> Vec<f64> {
    let before = || case.chain.hinges().take(number);
    let hinge = case.chain.hinges().nth(number).unwrap();
    if hinge.prescribed {
        let place = before().filter(|hinge| hinge.prescribed).count();
        return case.drives.motions[place].q.clone();
    }
    let first = case.chain.base_coordinates() + before().map(Hinge::coordinates).sum::<usize>();
    case.state.q[first..first + hinge.coordinates()].to_vec()
}

/// Returns the power that the frames at the ends supply to the chain.
fn power_at_ends(case: &Case, now: &Solution) -> f64 {
    let dot = |a: [f64; 3], b: [f64; 3]| Vector3::from(a).dot(&Vector3::from(b));
    let into_next = |point: &Point| {
        dot(point.force, point.velocity) - dot(point.moment, point.angular_velocity)
    };
    let spots = Graph::new(&case.chain).spots;
    let power = |(spot, point): (Spot, &Point)| match spot {
        Spot::Start(_) => into_next(point),
        Spot::Finish => -into_next(point),
        Spot::On(..) | Spot::Share(..) => 0.0,
    };
    spots.into_iter().zip(&now.points).map(power).sum()
}

/// Returns the power of loads, dampers of springs, and gravity if it has no potential.
fn power_of_loads(case: &Case, now: &Solution) -> f64 {
    let mut power = 0.0;
    let graph = Graph::new(&case.chain);
    for (number, body) in case.chain.bodies().enumerate() {
        power += power_on(case, now, number);
        let input = graph.input(now, number);
        if case.chain.gravity == Gravity::Input {
            let arm = matrix(&input.rotation) * Vector3::from(body.com);
            let spin = Vector3::from(input.angular_velocity);
            let velocity = Vector3::from(input.velocity) + spin.cross(&arm);
            power += body.mass * gravity(case).dot(&velocity);
        }
    }
    power
}
