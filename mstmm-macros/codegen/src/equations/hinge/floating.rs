//! Floating: nothing is held; the paper's acceleration hinge [P, Sect. A.2].
//!
//! Coordinates: the outboard origin in inboard axes, then the quaternion as for a ball. Rates: the
//! velocity of that origin in inboard axes, then the angular velocity as for a ball.

use super::{Direction, Geometry, ball};
use crate::math::{Scalar, Vec3};

/// A shift and a turn, both free: `m = 0` and `q = 0` [P, Eqs. (57), (58)].
pub fn geometry<S: Scalar>(q: &[S]) -> Geometry<S> {
    Geometry {
        offset: Vec3([q[0], q[1], q[2]]),
        directions: directions(),
        ..ball::geometry(&q[3..])
    }
}

/// The shifts along the inboard axes, then the turns about the outboard ones.
pub fn directions<S: Scalar>() -> Vec<Direction<S>> {
    let shifts = (0..3).map(|k| Direction::along(Vec3::unit(k)));
    shifts.chain(ball::turns()).collect()
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
