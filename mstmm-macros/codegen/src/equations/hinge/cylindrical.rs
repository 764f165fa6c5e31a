//! Cylindrical: shifts along an axis fixed on both sides and turns about it.
//!
//! Coordinates: the way in m as for a slider, the angle in rad as for a pin.

use super::axis::Alignment;
use super::{Direction, Geometry};
use crate::equations::Numbers;
use crate::math::Scalar;
use crate::model::Value;

/// A shift and a turn.
pub fn geometry<S: Scalar>(axis: &[Value; 3], numbers: &Numbers<S>, q: &[S]) -> Geometry<S> {
    let along = Alignment::with(axis, numbers);
    let direction = along.direction();
    Geometry {
        offset: direction * q[0],
        directions: vec![Direction::along(direction), Direction::about(direction)],
        ..Geometry::turned(along.turn(q[1]))
    }
}
