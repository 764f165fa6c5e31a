//! Cylindrical: translates along an axis that is fixed on both sides, and rotates about it.
//!
//! Coordinates: the displacement in m as for a slider, the angle in rad as for a pin.

use super::axis::Alignment;
use super::law::{HingeLaw, rates_are_coordinate_rates, without_quaternions};
use super::{HingeGeometry, StrainMap, SubspaceColumn};
use crate::equations::SymbolValues;
use crate::math::{Mat3, Scalar};
use crate::model::Value;

/// A cylindrical hinge.
#[derive(Clone, Copy, Debug)]
pub struct Cylindrical<'a> {
    /// The axis, the same on both sides.
    pub axis: &'a [Value; 3],
}

impl<S: Scalar> HingeLaw<S> for Cylindrical<'_> {
    /// A translation and a rotation.
    fn geometry(&self, values: &SymbolValues<S>, q: &[S]) -> HingeGeometry<S> {
        let along = Alignment::with(self.axis, values);
        let direction = along.direction();
        HingeGeometry {
            offset: direction * q[0],
            columns: vec![
                SubspaceColumn::translation(direction),
                SubspaceColumn::rotation(direction),
            ],
            ..HingeGeometry::rotated(along.rotation_by(q[1]))
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
        StrainMap::identity(2)
    }
}
