//! Screw (helical joint): rotates about an axis that is fixed on both sides and translates along
//! it, by `pitch` metres per radian.
//!
//! Coordinate: the angle in rad as for a pin; the displacement of the outboard origin is `pitch ·
//! angle`.

use super::axis::Alignment;
use super::law::{HingeLaw, rates_are_coordinate_rates, without_quaternions};
use super::{HingeGeometry, StrainMap, SubspaceColumn};
use crate::equations::SymbolValues;
use crate::math::{Mat3, Motion, Scalar};
use crate::model::Value;

/// A screw.
#[derive(Clone, Copy, Debug)]
pub struct Screw<'a> {
    /// The axis, the same on both sides.
    pub axis: &'a [Value; 3],
    /// Displacement in m for a rotation by one rad.
    pub pitch: &'a Value,
}

impl<S: Scalar> HingeLaw<S> for Screw<'_> {
    /// A rotation with its translation, `S = [pitch ζ; ζ]`.
    fn geometry(&self, values: &SymbolValues<S>, q: &[S]) -> HingeGeometry<S> {
        let along = Alignment::with(self.axis, values);
        let direction = along.direction();
        let translation = direction * values.scalar(self.pitch);
        HingeGeometry {
            offset: translation * q[0],
            columns: vec![SubspaceColumn::inboard(Motion {
                linear: translation,
                angular: direction,
            })],
            ..HingeGeometry::rotated(along.rotation_by(q[0]))
        }
    }

    fn alignment(&self, values: &SymbolValues<S>) -> Mat3<S> {
        Alignment::with(self.axis, values).rotation
    }

    fn coordinate_rates(&self, _: &[S], v: &[S]) -> Vec<S> {
        rates_are_coordinate_rates(v)
    }

    fn normalized(&self, q: &[S]) -> Vec<S> {
        without_quaternions(q)
    }

    fn strains(&self, _: &[S]) -> StrainMap<S> {
        StrainMap::identity(1)
    }
}
