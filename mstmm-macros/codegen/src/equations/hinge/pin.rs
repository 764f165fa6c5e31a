//! Pin (revolute joint): rotates about an axis `ζ` that is fixed on both sides [P, Sect. 3.3].
//!
//! Coordinate: the angle `Θ` in rad of the outboard frame relative to the inboard frame,
//! right-handed about `ζ`. One of the aligned axes lies along `ζ`, so the moment about it is one
//! entry: `H_2 Aᵀ m = 0` of [P, Eq. (35)].

use super::axis::Alignment;
use super::law::{HingeLaw, rates_are_coordinate_rates, without_quaternions};
use super::{HingeGeometry, StrainMap, SubspaceColumn};
use crate::equations::SymbolValues;
use crate::math::{Mat3, Scalar};
use crate::model::Value;

/// A pin.
#[derive(Clone, Copy, Debug)]
pub struct Pin<'a> {
    /// The axis, the same on both sides.
    pub axis: &'a [Value; 3],
}

impl<S: Scalar> HingeLaw<S> for Pin<'_> {
    /// A rotation about the axis: `Ω_O = Ω_I + A_O ω_r` [P, Eq. (36)].
    fn geometry(&self, values: &SymbolValues<S>, q: &[S]) -> HingeGeometry<S> {
        let along = Alignment::with(self.axis, values);
        let rotation = SubspaceColumn::rotation(along.direction());
        HingeGeometry { columns: vec![rotation], ..HingeGeometry::rotated(along.rotation_by(q[0])) }
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
