//! All accelerations of a pendulum of rods by two-ports, in one part or in parts that are computed in
//! parallel.

use rayon::prelude::*;

use super::two_port::{Joint, TwoPort, Vector, fold, unfold};
use crate::rods::{INERTIA, LENGTH, Rods};

/// The memory for an evaluation in parts.
pub struct Parts {
    parts: Vec<Part>,
    /// The number of rods of each part; the last part may have fewer.
    length: usize,
    joints: Vec<Joint>,
    accelerations: Vec<f64>,
}

/// A part: neighbouring rods.
struct Part {
    /// The absolute angle and rate of the last rod inboard of the part.
    inboard: [f64; 2],
    /// The directions of its rods.
    directions: Vec<Vector>,
    joints: Vec<Joint>,
    total: Option<TwoPort>,
    /// The forces on both ends.
    ends: [Vector; 2],
    /// The angular acceleration of its last rod.
    last: f64,
}

impl Parts {
    pub fn new(rods: usize, parts: usize) -> Self {
        let length = rods.div_ceil(parts);
        let part = |_| Part {
            inboard: [0.0; 2],
            directions: Vec::with_capacity(length),
            joints: Vec::with_capacity(length),
            total: None,
            ends: [Vector::zeros(); 2],
            last: 0.0,
        };
        let parts = (0..rods.div_ceil(length)).map(part).collect();
        Parts { parts, length, joints: Vec::new(), accelerations: vec![0.0; rods] }
    }

    /// The accelerations of the hinges, part by part.
    pub fn compute_serially(&mut self, rods: &Rods) -> &[f64] {
        self.sum_up(rods);
        let Parts { parts, length, .. } = self;
        let motions = rods.angles.chunks(*length).zip(rods.rates.chunks(*length));
        parts.iter_mut().zip(motions).for_each(|(part, motions)| part.join_rods(motions));
        self.solve(rods);
        let Parts { parts, length, accelerations, .. } = self;
        let accelerations = accelerations.chunks_mut(*length);
        parts
            .iter_mut()
            .zip(accelerations)
            .for_each(|(part, accelerations)| part.compute_accelerations(accelerations));
        self.finish()
    }

    /// The same in parallel, by the threads of the current pool.
    pub fn compute_in_parallel(&mut self, rods: &Rods) -> &[f64] {
        self.sum_up(rods);
        let Parts { parts, length, .. } = self;
        let motions = rods.angles.par_chunks(*length).zip(rods.rates.par_chunks(*length));
        let joining = parts.par_iter_mut().zip(motions).with_max_len(1);
        joining.for_each(|(part, motions)| part.join_rods(motions));
        self.solve(rods);
        let Parts { parts, length, accelerations, .. } = self;
        let tasks = parts.par_iter_mut().zip(accelerations.par_chunks_mut(*length));
        tasks
            .with_max_len(1)
            .for_each(|(part, accelerations)| part.compute_accelerations(accelerations));
        self.finish()
    }

    /// Sets the absolute angle and rate inboard of each part.
    fn sum_up(&mut self, rods: &Rods) {
        let motions = rods.angles.chunks(self.length).zip(rods.rates.chunks(self.length));
        // No part is outboard of the last one.
        let motions = motions.take(self.parts.len() - 1);
        let mut inboard = [0.0; 2];
        for (part, (angles, rates)) in self.parts.iter_mut().zip(motions) {
            part.inboard = inboard;
            for (angle, rate) in angles.iter().zip(rates) {
                inboard = [inboard[0] + angle, inboard[1] + rate];
            }
        }
        if let Some(last) = self.parts.last_mut() {
            last.inboard = inboard;
        }
    }

    /// The forces between the parts: the ground holds the first pin, and the tip is free.
    fn solve(&mut self, rods: &Rods) {
        let Parts { parts, joints, .. } = self;
        let Some(total) = fold(parts.iter().filter_map(|part| part.total), joints) else { return };
        // Gravity as an acceleration of the ground.
        let first = total.force_for(Vector::new(0.0, rods.gravity));
        unfold(joints, [first, Vector::zeros()], |part, ends| parts[part].ends = ends);
    }

    /// Makes the absolute accelerations at the first hinges of the parts relative.
    fn finish(&mut self) -> &[f64] {
        let firsts = self.accelerations.chunks_mut(self.length).skip(1);
        for (part, accelerations) in self.parts.iter().zip(firsts) {
            accelerations[0] -= part.last;
        }
        &self.accelerations
    }
}

impl Part {
    /// Computes the two-port of the part from its rods.
    fn join_rods(&mut self, (angles, rates): (&[f64], &[f64])) {
        let Part { directions, joints, total, .. } = self;
        let [mut angle, mut rate] = self.inboard;
        directions.clear();
        let rods = angles.iter().zip(rates).map(|(relative, relative_rate)| {
            angle += relative;
            rate += relative_rate;
            let (sine, cosine) = angle.sin_cos();
            let direction = Vector::new(cosine, sine);
            directions.push(direction);
            TwoPort::rod(direction, rate)
        });
        *total = fold(rods, joints);
    }

    /// Computes the accelerations of its hinges from the forces on its ends. The first acceleration is
    /// absolute.
    fn compute_accelerations(&mut self, accelerations: &mut [f64]) {
        let Part { directions, joints, ends, last, .. } = self;
        let mut next: Option<f64> = None;
        unfold(joints, *ends, |rod, [first, second]| {
            let direction = directions[rod];
            let pull = second - first;
            let moment = direction.x * pull.y - direction.y * pull.x;
            let turning = moment * (LENGTH / 2.0 / INERTIA);
            match next {
                Some(next) => accelerations[rod + 1] = next - turning,
                None => *last = turning,
            }
            next = Some(turning);
        });
        accelerations[0] = next.unwrap_or(f64::NAN);
    }
}
