//! Universal: rotates about an axis fixed on the inboard side, then about an axis fixed on the
//! outboard side.
//!
//! Coordinates: both angles in rad; `A = A_a(α) A_b(β)`. One of the aligned axes lies along the
//! outboard axis.

use super::axis::{Alignment, rotation_about_unit};
use super::law::{HingeLaw, rates_are_coordinate_rates, without_quaternions};
use super::{HingeGeometry, StrainMap, SubspaceColumn};
use crate::equations::SymbolValues;
use crate::math::{FrameOrientation, Mat3, Scalar};
use crate::model::Value;

/// A universal hinge.
#[derive(Clone, Copy, Debug)]
pub struct Universal<'a> {
    /// The axis fixed on the inboard side, and the one fixed on the outboard side.
    pub axes: &'a [[Value; 3]; 2],
}

impl<S: Scalar> HingeLaw<S> for Universal<'_> {
    /// Two rotations, each about an axis fixed on its side; the first also rotates the axis of the
    /// second.
    fn geometry(&self, values: &SymbolValues<S>, q: &[S]) -> HingeGeometry<S> {
        let outboard = Alignment::with(&self.axes[1], values);
        let first = outboard.to_aligned(&self.axes[0], values);
        let rotation =
            rotation_about_unit(first, q[0].sin_cos()) * outboard.rotation_by(q[1]).matrix();
        HingeGeometry {
            rotation: FrameOrientation::from_matrix(rotation),
            columns: vec![
                SubspaceColumn::rotation(first),
                SubspaceColumn::rotation(outboard.direction()).outboard(),
            ],
            ..HingeGeometry::fixed()
        }
    }

    fn alignment(&self, values: &SymbolValues<S>) -> Mat3<S> {
        Alignment::with(&self.axes[1], values).rotation
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
