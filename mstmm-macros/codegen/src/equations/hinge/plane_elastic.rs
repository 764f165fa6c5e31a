//! Elastic in the plane: the planar case of [P, Sect. A.1]. The intermediate frame has the axes of
//! the outboard frame and the origin of the inboard frame.
//!
//! Coordinates: the displacement of the outboard origin in m along the rotated axes, and the angle
//! in rad. Rates: as for a planar hinge. Efforts act along the rates of the coordinates, as for the
//! elastic hinge in space.

use super::law::{HingeLaw, identity_alignment, without_quaternions};
use super::planar::Planar;
use super::{HingeGeometry, StrainMap, strain};
use crate::equations::SymbolValues;
use crate::math::{Mat3, Scalar};

/// An elastic hinge in the plane.
#[derive(Clone, Copy, Debug)]
pub struct PlaneElastic;

impl<S: Scalar> HingeLaw<S> for PlaneElastic {
    /// Two translations and a rotation.
    fn geometry(&self, values: &SymbolValues<S>, q: &[S]) -> HingeGeometry<S> {
        let (sin, cos) = q[2].sin_cos();
        let offset = [cos * q[0] - sin * q[1], sin * q[0] + cos * q[1]];
        Planar { normal: 2 }.geometry(values, &[offset[0], offset[1], q[2]])
    }

    fn alignment(&self, _: &SymbolValues<S>) -> Mat3<S> {
        identity_alignment()
    }

    /// The strains are the coordinates minus their rest values.
    fn coordinate_rates(&self, q: &[S], v: &[S]) -> Vec<S> {
        strain::times(&self.strains(q).jacobian, v)
    }

    fn normalized(&self, q: &[S]) -> Vec<S> {
        without_quaternions(q)
    }

    /// From rates to the rates of the coordinates, and back.
    fn strains(&self, q: &[S]) -> StrainMap<S> {
        let (zero, one) = (S::zero(), S::one());
        let (sin, cos) = q[2].sin_cos();
        let turned = [-q[1], q[0]];
        let along = |x: S, y: S| x * turned[0] + y * turned[1];
        let to =
            vec![vec![cos, sin, -turned[0]], vec![-sin, cos, -turned[1]], vec![zero, zero, one]];
        let back = vec![
            vec![cos, -sin, along(cos, -sin)],
            vec![sin, cos, along(sin, cos)],
            vec![zero, zero, one],
        ];
        StrainMap::new(to, back)
    }
}
