//! Planar: shifts in a plane and turns about its normal.
//!
//! Coordinates: the ways in m of the outboard origin along the two inboard axes that follow the
//! normal, and the angle in rad about the normal.

use super::{Direction, Geometry};
use crate::math::{Scalar, Turn, Vec3};

/// Two shifts along inboard axes and a turn.
pub fn geometry<S: Scalar>(normal: usize, q: &[S]) -> Geometry<S> {
    let [first, second] = [1, 2].map(|k| Vec3::unit((normal + k) % 3));
    let (sin, cos) = q[2].sin_cos();
    Geometry {
        offset: first * q[0] + second * q[1],
        directions: vec![
            Direction::along(first),
            Direction::along(second),
            Direction::about(Vec3::unit(normal)),
        ],
        ..Geometry::turned(Turn { axis: normal, sin, cos })
    }
}
