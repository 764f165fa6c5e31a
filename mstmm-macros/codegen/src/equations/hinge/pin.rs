//! Pin: turns about an axis `ζ` fixed on both sides [P, Sect. 3.3].
//!
//! Coordinate: the angle `Θ` in rad by which the outboard frame is turned against the inboard one,
//! right-handed about `ζ`. Aligned axes have one coordinate axis along `ζ`: the moment along it is
//! then a single number, `H_2 Aᵀ m = 0` of [P, Eq. (35)].

use super::axis::Alignment;
use super::{Direction, Geometry};
use crate::equations::Numbers;
use crate::math::Scalar;
use crate::model::Value;

/// A turn about the axis: `Ω_O = Ω_I + A_O ω_r` [P, Eq. (36)].
pub fn geometry<S: Scalar>(axis: &[Value; 3], numbers: &Numbers<S>, q: &[S]) -> Geometry<S> {
    let along = Alignment::with(axis, numbers);
    let turn = Direction::about(along.direction());
    Geometry { directions: vec![turn], ..Geometry::turned(along.turn(q[0])) }
}
