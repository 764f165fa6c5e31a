//! Elastic in the plane: the plane cut of [P, Sect. A.1], where the intermediate frame is the
//! outboard one's axes at the inboard origin.
//!
//! Coordinates: the displacement of the outboard origin in m along the turned axes, and the angle in
//! rad. Rates: as for a planar hinge. Efforts act along the rates of the coordinates, as for the
//! elastic hinge in space.

use super::{Geometry, planar};
use crate::math::Scalar;

/// Two shifts and a turn.
pub fn geometry<S: Scalar>(q: &[S]) -> Geometry<S> {
    let (sin, cos) = q[2].sin_cos();
    let offset = [cos * q[0] - sin * q[1], sin * q[0] + cos * q[1]];
    planar::geometry(2, &[offset[0], offset[1], q[2]])
}

/// From rates to the rates of the coordinates, and back.
pub fn strains<S: Scalar>(q: &[S]) -> (Vec<Vec<S>>, Vec<Vec<S>>) {
    let (zero, one) = (S::zero(), S::one());
    let (sin, cos) = q[2].sin_cos();
    let turned = [-q[1], q[0]];
    let along = |x: S, y: S| x * turned[0] + y * turned[1];
    let to = vec![vec![cos, sin, -turned[0]], vec![-sin, cos, -turned[1]], vec![zero, zero, one]];
    let back = vec![
        vec![cos, -sin, along(cos, -sin)],
        vec![sin, cos, along(sin, cos)],
        vec![zero, zero, one],
    ];
    (to, back)
}
