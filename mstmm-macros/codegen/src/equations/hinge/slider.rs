//! Slider: shifts along an axis fixed on both sides.
//!
//! Coordinate: the way in m of the outboard origin along the axis.

use super::axis::Alignment;
use super::{Direction, Geometry};
use crate::equations::Numbers;
use crate::math::Scalar;
use crate::model::Value;

/// A shift along the axis.
pub fn geometry<S: Scalar>(axis: &[Value; 3], numbers: &Numbers<S>, q: &[S]) -> Geometry<S> {
    let along = Alignment::with(axis, numbers).direction();
    Geometry {
        offset: along * q[0],
        directions: vec![Direction::along(along)],
        ..Geometry::fixed()
    }
}
