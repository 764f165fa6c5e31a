//! Universal: turns about an axis fixed on the inboard side, then about one fixed on the outboard
//! side.
//!
//! Coordinates: both angles in rad; `A = A_a(α) A_b(β)`. Aligned axes have one coordinate axis along
//! the outboard one.

use super::axis::{Alignment, turn_about};
use super::{Direction, Geometry};
use crate::equations::Numbers;
use crate::math::{Mat3, Scalar, Vec3};
use crate::model::Value;

/// Two turns, each about an axis fixed on its side; the first carries the second's axis with it.
pub fn geometry<S: Scalar>(axes: &[[Value; 3]; 2], numbers: &Numbers<S>, q: &[S]) -> Geometry<S> {
    let outboard = Alignment::with(&axes[1], numbers);
    let first = inboard_axis(&axes[0], &outboard, numbers);
    let rotation = first_turn(first, q[0].sin_cos()) * outboard.turn(q[1]).matrix();
    Geometry {
        rotation,
        directions: vec![
            Direction::about(first),
            Direction::about(outboard.direction()).outboard(),
        ],
        ..Geometry::fixed()
    }
}

/// The inboard axis in aligned axes.
fn inboard_axis<S: Scalar>(
    axis: &[Value; 3],
    outboard: &Alignment<S>,
    numbers: &Numbers<S>,
) -> Vec3<S> {
    outboard.rotation.transposed() * numbers.unit(axis)
}

fn first_turn<S: Scalar>(axis: Vec3<S>, angle: (S, S)) -> Mat3<S> {
    let others = |k: usize| axis[(k + 1) % 3].vanishes() && axis[(k + 2) % 3].vanishes();
    match (0..3).find(|&k| others(k)) {
        // A unit vector along a coordinate axis is plus or minus that axis.
        Some(k) => Mat3::turn_about(k, (angle.0 * axis[k], angle.1)),
        None => turn_about(axis, angle),
    }
}
