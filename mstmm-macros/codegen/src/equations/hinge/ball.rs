//! Ball and socket: turns in every way [P, Sect. 3.2].
//!
//! Coordinates: the unit quaternion (w, x, y, z) that turns outboard components into inboard ones.
//! Rates: the angular velocity of the outboard frame against the inboard one, outboard axes.

use super::{Column, Crossing, Freedom, WorkAxes, rows};
use crate::math::{Mat3, Scalar, Vec3};

/// A turn by the quaternion.
pub fn crossing<S: Scalar>(q: &[S]) -> Crossing<S> {
    let rotation = Mat3::from_quaternion([q[0], q[1], q[2], q[3]]);
    Crossing { rotation, turn: None, offset: Vec3::zero() }
}

/// Turns about all axes are free; the moment vanishes, as [P, Eq. (25)] has it for the next hinge.
pub fn freedom<S: Scalar>(axes: WorkAxes<S>, reversed: bool) -> Freedom<S> {
    let basis = if reversed { -axes.from_parent } else { axes.from_child };
    Freedom { columns: (3..6).map(Column::Axis).collect(), basis: rows(basis) }
}

/// `½ (w, x, y, z) ∘ (0, ω)`
pub fn coordinate_rates<S: Scalar>(q: &[S], v: &[S]) -> Vec<S> {
    let (w, r) = (q[0], Vec3([q[1], q[2], q[3]]));
    let half = Vec3([v[0], v[1], v[2]]) * S::number(0.5);
    let vector = half * w + r.cross(half);
    let mut rates = vec![-r.dot(half)];
    rates.extend(vector.0);
    rates
}

/// The quaternion divided by its length.
pub fn normalized<S: Scalar>(q: &[S]) -> Vec<S> {
    let square = q.iter().fold(S::zero(), |sum, &x| sum + x * x);
    let scale = square.sqrt().recip();
    q.iter().map(|&x| x * scale).collect()
}
