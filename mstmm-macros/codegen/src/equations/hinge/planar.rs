//! Planar: shifts in a plane and turns about its normal.
//!
//! Coordinates: the ways in m of the outboard origin along the two inboard axes that follow the
//! normal, and the angle in rad about the normal.

use super::law::{HingeLaw, coordinates_change_by, free_of_quaternions, own_axes};
use super::{HingeGeometry, StrainMap, SubspaceColumn};
use crate::equations::SymbolValues;
use crate::math::{AxisRotation, Mat3, Scalar, Vec3};

/// A planar hinge.
#[derive(Clone, Copy, Debug)]
pub struct Planar {
    /// Which axis the normal is.
    pub normal: usize,
}

impl<S: Scalar> HingeLaw<S> for Planar {
    /// Two shifts along inboard axes and a turn.
    fn geometry(&self, _: &SymbolValues<S>, q: &[S]) -> HingeGeometry<S> {
        let [first, second] = [1, 2].map(|k| Vec3::unit((self.normal + k) % 3));
        let (sin, cos) = q[2].sin_cos();
        HingeGeometry {
            offset: first * q[0] + second * q[1],
            directions: vec![
                SubspaceColumn::along(first),
                SubspaceColumn::along(second),
                SubspaceColumn::about(Vec3::unit(self.normal)),
            ],
            ..HingeGeometry::turned(AxisRotation { axis: self.normal, sin, cos })
        }
    }

    fn alignment(&self, _: &SymbolValues<S>) -> Mat3<S> {
        own_axes()
    }

    fn coordinate_rates(&self, _: &[S], v: &[S]) -> Vec<S> {
        coordinates_change_by(v)
    }

    fn normalized(&self, q: &[S]) -> Vec<S> {
        free_of_quaternions(q)
    }

    fn strains(&self, _: &[S]) -> StrainMap<S> {
        StrainMap::change_by_rates(3)
    }
}
