//! Gimbal: rotates about an axis fixed on the inboard side, then about an axis that the first
//! rotation moves, then about an axis fixed on the outboard side.
//!
//! Coordinates: the three angles in rad; `A = A_a(α) A_b(β) A_c(γ)`. The axis of the second rotation
//! is constant in the middle frame, `A_a(α)`. One of the aligned axes lies along the outboard axis.
//!
//! The columns of the motion subspace are dependent where the three axes are in one plane; for
//! successive axes at right angles, where `β` is a right angle. The articulated inertia along them
//! is then singular.

use super::axis::{Alignment, rotation_about_unit};
use super::law::{HingeLaw, rates_are_coordinate_rates, without_quaternions};
use super::{HingeGeometry, StrainMap, SubspaceColumn};
use crate::equations::SymbolValues;
use crate::math::{FrameOrientation, Mat3, Scalar};
use crate::model::Value;

/// A gimbal.
#[derive(Clone, Copy, Debug)]
pub struct Gimbal<'a> {
    /// The axes in the zero position.
    pub axes: &'a [[Value; 3]; 3],
}

impl<S: Scalar> HingeLaw<S> for Gimbal<'_> {
    /// Three rotations, of which each also rotates the axes of the later ones.
    fn geometry(&self, values: &SymbolValues<S>, q: &[S]) -> HingeGeometry<S> {
        let [a, b, c] = self.axes;
        let outboard = Alignment::with(c, values);
        let [first, second] = [a, b].map(|axis| outboard.to_aligned(axis, values));
        let to_inboard = rotation_about_unit(first, q[0].sin_cos());
        let inner =
            rotation_about_unit(second, q[1].sin_cos()) * outboard.rotation_by(q[2]).matrix();
        HingeGeometry {
            rotation: FrameOrientation::from_matrix(to_inboard * inner),
            columns: vec![
                SubspaceColumn::rotation(first),
                SubspaceColumn::rotation(to_inboard * second).middle(),
                SubspaceColumn::rotation(outboard.direction()).outboard(),
            ],
            ..HingeGeometry::fixed()
        }
    }

    fn alignment(&self, values: &SymbolValues<S>) -> Mat3<S> {
        Alignment::with(&self.axes[2], values).rotation
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
