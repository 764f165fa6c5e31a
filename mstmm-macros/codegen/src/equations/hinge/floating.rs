//! Floating: nothing is held; the paper's acceleration hinge [P, Sect. A.2].
//!
//! Coordinates: the outboard origin in inboard axes, then the quaternion as for a ball. Rates: the
//! velocity of that origin in inboard axes, then the angular velocity as for a ball.

use super::{Column, Crossing, Freedom, WorkAxes, ball, rows};
use crate::math::{Scalar, Vec3};

/// A shift and a turn.
pub fn crossing<S: Scalar>(q: &[S]) -> Crossing<S> {
    Crossing { offset: Vec3([q[0], q[1], q[2]]), ..ball::crossing(&q[3..]) }
}

/// Everything is free: `m = 0` and `q = 0` [P, Eqs. (57), (58)].
///
/// Only the ground is crossed from, outwards: the shift has no part in the free turns.
pub fn freedom<S: Scalar>(axes: WorkAxes<S>, reversed: bool) -> Freedom<S> {
    debug_assert!(!reversed, "a floating base is tied to the ground from its inboard side");
    let mut basis: Vec<Vec<S>> = Vec::new();
    for mut row in rows(axes.from_parent) {
        row.extend([S::zero(); 3]);
        basis.push(row);
    }
    for row in rows(axes.from_child) {
        basis.push([S::zero(); 3].into_iter().chain(row).collect());
    }
    Freedom { columns: (0..6).map(Column::Axis).collect(), basis }
}

/// The rates of the origin and of the quaternion.
pub fn coordinate_rates<S: Scalar>(q: &[S], v: &[S]) -> Vec<S> {
    let mut rates = v[..3].to_vec();
    rates.extend(ball::coordinate_rates(&q[3..], &v[3..]));
    rates
}

/// The quaternion divided by its length.
pub fn normalized<S: Scalar>(q: &[S]) -> Vec<S> {
    let mut coordinates = q[..3].to_vec();
    coordinates.extend(ball::normalized(&q[3..]));
    coordinates
}
