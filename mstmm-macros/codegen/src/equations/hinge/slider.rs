//! Slider (prismatic joint): translates along an axis that is fixed on both sides.
//!
//! Coordinate: the displacement in m of the outboard origin along the axis.

use super::axis::Alignment;
use super::law::{HingeLaw, rates_are_coordinate_rates, without_quaternions};
use super::{HingeGeometry, StrainMap, SubspaceColumn};
use crate::equations::SymbolValues;
use crate::math::{Mat3, Scalar};
use crate::model::Value;

/// A slider.
#[derive(Clone, Copy, Debug)]
pub struct Slider<'a> {
    /// The axis, the same on both sides.
    pub axis: &'a [Value; 3],
}

impl<S: Scalar> HingeLaw<S> for Slider<'_> {
    /// A translation along the axis.
    fn geometry(&self, values: &SymbolValues<S>, q: &[S]) -> HingeGeometry<S> {
        let along = Alignment::with(self.axis, values).direction();
        HingeGeometry {
            offset: along * q[0],
            columns: vec![SubspaceColumn::translation(along)],
            ..HingeGeometry::fixed()
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
