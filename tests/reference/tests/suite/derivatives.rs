//! The reported accelerations, held against differences of reported velocities.
//!
//! This ties together what is easily wrong on its own: the conventions of the hinge rates, the
//! accelerations in these rates, and the accelerations of the connection points.

use crate::samples::{assert_close, random_cases};
use mstmm_reference::{Chain, HingeKind, Solution, State};
use nalgebra::Quaternion;

const STEP: f64 = 1e-5;
/// What a central difference with this step can be trusted to, fast chains included.
const TOLERANCE: f64 = 2e-7;

/// Returns the state a time `t` later, to second order.
fn moved(chain: &Chain, state: &State, accelerations: &[f64], t: f64) -> State {
    let at_middle = |k: usize| state.v[k] + 0.5 * t * accelerations[k];
    let (mut q, mut rate) = (Vec::new(), 0);
    if chain.floats() {
        q.extend((0..3).map(|k| state.q[k] + t * at_middle(k)));
        q.extend(turned(&state.q[3..7], [3, 4, 5].map(|k| t * at_middle(k))));
        rate = 6;
    }
    for hinge in chain.hinges() {
        let own = &state.q[q.len()..];
        match hinge.kind {
            HingeKind::Weld => {}
            HingeKind::Pin { .. } => q.push(own[0] + t * at_middle(rate)),
            HingeKind::Ball => {
                q.extend(turned(own, [rate, rate + 1, rate + 2].map(|k| t * at_middle(k))));
            }
        }
        rate += hinge.kind.freedoms();
    }
    let v = (0..state.v.len()).map(|k| state.v[k] + t * accelerations[k]).collect();
    State { q, v }
}

/// Turns a quaternion on by a small rotation vector given in the frame it turns from.
fn turned(wxyz: &[f64], [x, y, z]: [f64; 3]) -> [f64; 4] {
    let quaternion = Quaternion::new(wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
    let on = quaternion * Quaternion::new(0.0, 0.5 * x, 0.5 * y, 0.5 * z).exp();
    [on.w, on.i, on.j, on.k]
}

/// Returns the solutions a moment later and a moment earlier.
fn around(chain: &Chain, state: &State, efforts: &[f64], now: &Solution) -> [Solution; 2] {
    [STEP, -STEP].map(|t| chain.solve(&moved(chain, state, &now.accelerations, t), efforts))
}

#[test]
fn points_accelerate_as_their_velocities_change() {
    for case in random_cases() {
        let now = case.chain.solve(&case.state, &case.efforts);
        let [after, before] = around(&case.chain, &case.state, &case.efforts, &now);
        for ((now, after), before) in now.points.iter().zip(&after.points).zip(&before.points) {
            for k in 0..3 {
                let slope = |f: &dyn Fn(&mstmm_reference::Point) -> f64| {
                    (f(after) - f(before)) / (2.0 * STEP)
                };
                let name = &case.chain.name;
                let scale = 1.0 + now.acceleration.iter().map(|a| a.abs()).sum::<f64>();
                let tolerance = TOLERANCE * scale;
                assert_close(slope(&|p| p.position[k]), now.velocity[k], tolerance, name);
                assert_close(slope(&|p| p.velocity[k]), now.acceleration[k], tolerance, name);
                let angular = now.angular_acceleration[k];
                assert_close(slope(&|p| p.angular_velocity[k]), angular, tolerance, name);
            }
        }
    }
}

/// The motors' power is all that changes the energy.
#[test]
fn energy_changes_by_the_power_of_the_motors() {
    for case in random_cases() {
        let now = case.chain.solve(&case.state, &case.efforts);
        let energies = around(&case.chain, &case.state, &case.efforts, &now)
            .map(|solution| solution.kinetic_energy + solution.potential_energy);
        let power: f64 = case.efforts.iter().zip(&case.state.v).map(|(e, v)| e * v).sum();
        let slope = (energies[0] - energies[1]) / (2.0 * STEP);
        let tolerance = TOLERANCE * (1.0 + now.kinetic_energy);
        assert_close(slope, power, tolerance, &case.chain.name);
    }
}
