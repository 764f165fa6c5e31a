//! Planar: translates in a plane and rotates about its normal.
//!
//! Coordinates: the displacements in m of the outboard origin along the two inboard axes that
//! follow the normal, and the angle in rad about the normal.

use super::law::{HingeLaw, identity_alignment, rates_are_coordinate_rates, without_quaternions};
use super::{HingeGeometry, StrainMap, SubspaceColumn};
use crate::equations::SymbolValues;
use crate::math::{AxisRotation, Mat3, Scalar, Vec3};

/// A planar hinge.
#[derive(Clone, Copy, Debug)]
pub struct Planar {
    /// The index of the axis along the normal.
    pub normal: usize,
}

impl<S: Scalar> HingeLaw<S> for Planar {
    /// Two translations along inboard axes and a rotation.
    fn geometry(&self, _: &SymbolValues<S>, q: &[S]) -> HingeGeometry<S> {
        let [first, second] = [1, 2].map(|k| Vec3::unit((self.normal + k) % 3));
        let (sin, cos) = q[2].sin_cos();
        HingeGeometry {
            offset: first * q[0] + second * q[1],
            columns: vec![
                SubspaceColumn::translation(first),
                SubspaceColumn::translation(second),
                SubspaceColumn::rotation(Vec3::unit(self.normal)),
            ],
            ..HingeGeometry::rotated(AxisRotation { axis: self.normal, sin, cos })
        }
    }

    fn alignment(&self, _: &SymbolValues<S>) -> Mat3<S> {
        identity_alignment()
    }

    fn coordinate_rates(&self, _: &[S], v: &[S]) -> Vec<S> {
        rates_are_coordinate_rates(v)
    }

    fn normalized(&self, q: &[S]) -> Vec<S> {
        without_quaternions(q)
    }

    fn strains(&self, _: &[S]) -> StrainMap<S> {
        StrainMap::identity(3)
    }
}
