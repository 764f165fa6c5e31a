//! Screw: turns about an axis fixed on both sides and shifts along it, `pitch` metres a radian.
//!
//! Coordinate: the angle in rad as for a pin; the outboard origin is shifted by `pitch · angle`.

use super::axis::Alignment;
use super::law::{HingeLaw, coordinates_change_by, free_of_quaternions};
use super::{HingeGeometry, StrainMap, SubspaceColumn};
use crate::equations::SymbolValues;
use crate::math::{Mat3, Motion, Scalar};
use crate::model::Value;

/// A screw.
#[derive(Clone, Copy, Debug)]
pub struct Screw<'a> {
    /// The axis, the same on both sides.
    pub axis: &'a [Value; 3],
    /// Shift in m for a turn by one rad.
    pub pitch: &'a Value,
}

impl<S: Scalar> HingeLaw<S> for Screw<'_> {
    /// A turn with its shift, `S = [pitch ζ; ζ]`.
    fn geometry(&self, numbers: &SymbolValues<S>, q: &[S]) -> HingeGeometry<S> {
        let along = Alignment::with(self.axis, numbers);
        let direction = along.direction();
        let shift = direction * numbers.scalar(self.pitch);
        HingeGeometry {
            offset: shift * q[0],
            directions: vec![SubspaceColumn::inboard(Motion { linear: shift, angular: direction })],
            ..HingeGeometry::turned(along.turn(q[0]))
        }
    }

    fn alignment(&self, numbers: &SymbolValues<S>) -> Mat3<S> {
        Alignment::with(self.axis, numbers).rotation
    }

    fn coordinate_rates(&self, _: &[S], v: &[S]) -> Vec<S> {
        coordinates_change_by(v)
    }

    fn normalized(&self, q: &[S]) -> Vec<S> {
        free_of_quaternions(q)
    }

    fn strains(&self, _: &[S]) -> StrainMap<S> {
        StrainMap::change_by_rates(1)
    }
}
