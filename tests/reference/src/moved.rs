//! States and drives a short time later.

use crate::chain::{Chain, State};
use crate::drives::Drives;
use crate::hinge::{Hinge, HingeKind};
use crate::strain::Strains;
use nalgebra::{DVector, Quaternion};

/// Returns the coordinates of a hinge a time `t` later to second order, given the rates and their
/// derivatives.
pub(crate) fn moved_coordinates(hinge: &Hinge, q: &[f64], [v, a]: [&[f64]; 2], t: f64) -> Vec<f64> {
    let strains = Strains::new(hinge, q, v);
    let second = &strains.jacobian * DVector::from_column_slice(a) + &strains.bias;
    let change = strains.rates * t + second * (0.5 * t * t);
    if hinge.kind.has_quaternion() {
        let first = hinge.kind.linear().end;
        let turn = &change.as_slice()[first..];
        let shifted = q[..first].iter().zip(change.iter()).map(|(q, change)| q + change);
        shifted.chain(turned(&q[first..], turn)).collect()
    } else {
        q.iter().zip(change.iter()).map(|(q, change)| q + change).collect()
    }
}

/// Rotates a quaternion (w, x, y, z) further by a rotation vector in outboard components.
pub(crate) fn turned(wxyz: &[f64], by: &[f64]) -> [f64; 4] {
    let quaternion = Quaternion::new(wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
    let on = quaternion * Quaternion::new(0.0, 0.5 * by[0], 0.5 * by[1], 0.5 * by[2]).exp();
    [on.w, on.i, on.j, on.k]
}

impl Chain {
    /// Returns the state a time `t` later to second order, given the derivatives of the rates.
    pub fn moved(&self, state: &State, accelerations: &[f64], t: f64) -> State {
        let (mut q, mut rate) = (Vec::new(), 0);
        let mut add = |hinge: &Hinge| {
            let own = rate..rate + hinge.kind.dof_count();
            let (from, motion) =
                (&state.q[q.len()..], [&state.v[own.clone()], &accelerations[own]]);
            let moved = moved_coordinates(hinge, &from[..hinge.kind.coordinates()], motion, t);
            q.extend(moved);
            rate += hinge.kind.dof_count();
        };
        if self.floats() {
            add(&Hinge::new("base", HingeKind::of_base(self.dimension)));
        }
        self.hinges().filter(|hinge| !hinge.prescribed).for_each(add);
        let v = state.v.iter().zip(accelerations).map(|(v, a)| v + t * a).collect();
        State { q, v }
    }
}

impl Drives {
    /// Returns the drives a time `t` later, with prescribed motions to second order. All other drives
    /// are constant.
    pub fn moved(&self, chain: &Chain, t: f64) -> Drives {
        let mut moved = self.clone();
        let prescribed = chain.hinges().filter(|hinge| hinge.prescribed);
        for (hinge, motion) in prescribed.zip(&mut moved.motions) {
            motion.q = moved_coordinates(hinge, &motion.q, [&motion.v, &motion.a], t);
            motion.v.iter_mut().zip(&motion.a).for_each(|(v, a)| *v += t * a);
        }
        let ends = [&mut moved.start, &mut moved.finish];
        for frame in ends.into_iter().chain(&mut moved.route_starts) {
            let ahead = |v: &[f64; 3], a: &[f64; 3], t: f64| [0, 1, 2].map(|k| v[k] + t * a[k]);
            let mean = ahead(&frame.velocity, &frame.acceleration, 0.5 * t);
            frame.position = ahead(&frame.position, &mean, t);
            frame.velocity = ahead(&frame.velocity, &frame.acceleration, t);
            let mean = ahead(&frame.rate, &frame.rate_derivative, 0.5 * t);
            frame.orientation = turned(&frame.orientation, &mean.map(|rate| t * rate));
            frame.rate = ahead(&frame.rate, &frame.rate_derivative, t);
        }
        moved
    }
}
