//! Angles and rates with which a linkage closes, for any angle of its first pin.

use super::algebra::{Real, norm};
use super::linkage::Linkage;
use super::svd::decomposed;
use crate::double_double::DoubleDouble;

/// The longest step of the first angle from one configuration to the next, in rad.
const LONGEST_STEP: f64 = 0.1;

impl Linkage {
    /// Returns all angles, in twice the precision, for an angle of the first pin.
    ///
    /// The branch is that of `start`, followed by small steps. The last steps of Newton's method
    /// are taken in twice the precision, so that small angles have all their digits.
    pub fn angles(&self, crank: DoubleDouble) -> Vec<DoubleDouble> {
        let mut q = self.start.clone();
        let way = crank.high - q[0];
        let steps = (way.abs() / LONGEST_STEP).ceil().max(1.0);
        let first = q[0];
        for step in 1..=steps as usize {
            q[0] = first + way * step as f64 / steps;
            (0..3).for_each(|_| self.improve(&mut q));
        }
        let mut q: Vec<DoubleDouble> = q.into_iter().map(Real::exact).collect();
        q[0] = crank;
        (0..6).for_each(|_| self.improve(&mut q));
        let gap = self.gap(&q);
        assert!(gap < 1e-28, "{} misses its closure by {gap:e} at {:e} rad", self.name, crank.high);
        q
    }

    /// Returns by how much the closure is missed, in m and rad.
    pub fn gap<T: Real>(&self, q: &[T]) -> f64 {
        let motion = self.motion(q, &vec![T::default(); q.len()]);
        norm(&motion.gap()).double()
    }

    /// Returns how fast the closure is left, in m/s and rad/s.
    pub fn drift(&self, q: &[f64], v: &[f64]) -> f64 {
        let columns = self.motion(q, v).jacobian();
        let rate = |row: usize| columns.iter().zip(v).map(|(column, v)| column[row] * v).sum();
        norm(&[0, 1, 2, 3, 4, 5].map(rate))
    }

    /// A step of Newton's method that leaves the first angle unchanged.
    fn improve<T: Real>(&self, q: &mut [T]) {
        let motion = self.motion(q, &vec![T::default(); q.len()]);
        let jacobian = decomposed(&motion.jacobian()[1..]);
        let step = jacobian.solved(q.len() - 1, &motion.gap());
        q[1..].iter_mut().zip(step).for_each(|(angle, step)| *angle -= step);
    }

    /// Returns the rates with which the linkage stays closed while the first pin has this rate.
    pub fn rates(&self, q: &[DoubleDouble], crank: f64) -> Vec<DoubleDouble> {
        let motion = self.motion(q, &vec![DoubleDouble::default(); q.len()]);
        let jacobian = decomposed(&motion.jacobian());
        let tangent = &jacobian.directions[self.rank];
        let factor = crank.exact() * mstmm::Scalar::recip(tangent[0]);
        tangent.iter().map(|x| *x * factor).collect()
    }
}
