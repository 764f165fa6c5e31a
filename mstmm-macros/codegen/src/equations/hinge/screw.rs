//! Screw: turns about an axis fixed on both sides and shifts along it, `pitch` metres a radian.
//!
//! Coordinate: the angle in rad as for a pin; the outboard origin is shifted by `pitch · angle`.

use super::axis::Alignment;
use super::{Direction, Geometry};
use crate::equations::Numbers;
use crate::math::{Motion, Scalar};
use crate::model::Value;

/// A turn with its shift, `S = [pitch ζ; ζ]`.
pub fn geometry<S: Scalar>(
    axis: &[Value; 3],
    pitch: &Value,
    numbers: &Numbers<S>,
    q: &[S],
) -> Geometry<S> {
    let along = Alignment::with(axis, numbers);
    let direction = along.direction();
    let shift = direction * numbers.scalar(pitch);
    Geometry {
        offset: shift * q[0],
        directions: vec![Direction::inboard(Motion { linear: shift, angular: direction })],
        ..Geometry::turned(along.turn(q[0]))
    }
}
