//! All accelerations of a pendulum of rods by two-ports, in one piece or in parts that are computed in
//! parallel.

use rayon::prelude::*;

use super::two_port::{Seam, TwoPort, Vector, fold, unfold};
use crate::rods::{INERTIA, LENGTH, Rods};

/// Room for an evaluation in so many parts.
pub struct Parts {
    parts: Vec<Part>,
    /// How many rods each part has but for the last one.
    length: usize,
    seams: Vec<Seam>,
    accelerations: Vec<f64>,
}

/// Neighbouring rods.
struct Part {
    /// Absolute angle and rate of the rod before.
    before: [f64; 2],
    /// The directions of its rods.
    directions: Vec<Vector>,
    seams: Vec<Seam>,
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
            before: [0.0; 2],
            directions: Vec::with_capacity(length),
            seams: Vec::with_capacity(length),
            total: None,
            ends: [Vector::zeros(); 2],
            last: 0.0,
        };
        let parts = (0..rods.div_ceil(length)).map(part).collect();
        Parts { parts, length, seams: Vec::new(), accelerations: vec![0.0; rods] }
    }

    /// The hinges' accelerations, each part after the other.
    pub fn in_turn(&mut self, rods: &Rods) -> &[f64] {
        self.sum_up(rods);
        let Parts { parts, length, .. } = self;
        let given = rods.angles.chunks(*length).zip(rods.rates.chunks(*length));
        parts.iter_mut().zip(given).for_each(|(part, given)| part.gather(given));
        self.solve(rods);
        let Parts { parts, length, accelerations, .. } = self;
        let wanted = accelerations.chunks_mut(*length);
        parts.iter_mut().zip(wanted).for_each(|(part, wanted)| part.spread(wanted));
        self.finish()
    }

    /// The same with all parts at once, by the threads of the pool that this runs in.
    pub fn at_once(&mut self, rods: &Rods) -> &[f64] {
        self.sum_up(rods);
        let Parts { parts, length, .. } = self;
        let given = rods.angles.par_chunks(*length).zip(rods.rates.par_chunks(*length));
        let gathering = parts.par_iter_mut().zip(given).with_max_len(1);
        gathering.for_each(|(part, given)| part.gather(given));
        self.solve(rods);
        let Parts { parts, length, accelerations, .. } = self;
        let spreading = parts.par_iter_mut().zip(accelerations.par_chunks_mut(*length));
        spreading.with_max_len(1).for_each(|(part, wanted)| part.spread(wanted));
        self.finish()
    }

    /// The absolute angles and rates that the parts begin with.
    fn sum_up(&mut self, rods: &Rods) {
        let given = rods.angles.chunks(self.length).zip(rods.rates.chunks(self.length));
        // What comes after the last part is not asked for.
        let given = given.take(self.parts.len() - 1);
        let mut before = [0.0; 2];
        for (part, (angles, rates)) in self.parts.iter_mut().zip(given) {
            part.before = before;
            for (angle, rate) in angles.iter().zip(rates) {
                before = [before[0] + angle, before[1] + rate];
            }
        }
        if let Some(last) = self.parts.last_mut() {
            last.before = before;
        }
    }

    /// The forces between the parts: the ground holds the first pin, and the tip is free.
    fn solve(&mut self, rods: &Rods) {
        let Parts { parts, seams, .. } = self;
        let Some(total) = fold(parts.iter().filter_map(|part| part.total), seams) else { return };
        // Gravity as an acceleration of the ground.
        let first = total.hold(Vector::new(0.0, rods.gravity));
        unfold(seams, [first, Vector::zeros()], |part, ends| parts[part].ends = ends);
    }

    /// From absolute to relative accelerations where parts meet.
    fn finish(&mut self) -> &[f64] {
        let firsts = self.accelerations.chunks_mut(self.length).skip(1);
        for (part, wanted) in self.parts.iter().zip(firsts) {
            wanted[0] -= part.last;
        }
        &self.accelerations
    }
}

impl Part {
    /// From its rods to the two-port of the part.
    fn gather(&mut self, (angles, rates): (&[f64], &[f64])) {
        let Part { directions, seams, total, .. } = self;
        let [mut angle, mut rate] = self.before;
        directions.clear();
        let rods = angles.iter().zip(rates).map(|(relative, relative_rate)| {
            angle += relative;
            rate += relative_rate;
            let (sine, cosine) = angle.sin_cos();
            let direction = Vector::new(cosine, sine);
            directions.push(direction);
            TwoPort::rod(direction, rate)
        });
        *total = fold(rods, seams);
    }

    /// From the forces on its ends to the accelerations of its hinges, the first of them absolute.
    fn spread(&mut self, accelerations: &mut [f64]) {
        let Part { directions, seams, ends, last, .. } = self;
        let mut next: Option<f64> = None;
        unfold(seams, *ends, |rod, [first, second]| {
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
