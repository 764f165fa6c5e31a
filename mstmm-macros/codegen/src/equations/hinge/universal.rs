//! Universal: rotates about an axis fixed on the inboard side, then about an axis fixed on the
//! outboard side.
//!
//! Coordinates: both angles in rad; `A = A_a(α) A_b(β)`. One of the aligned axes lies along the
//! outboard axis.

use super::axis::{Alignment, rotation_about};
use super::law::{HingeLaw, rates_are_coordinate_rates, without_quaternions};
use super::{HingeGeometry, StrainMap, SubspaceColumn};
use crate::equations::SymbolValues;
use crate::math::{FrameOrientation, Mat3, Scalar, Vec3};
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
        let first = inboard_axis(&self.axes[0], &outboard, values);
        let rotation = first_rotation(first, q[0].sin_cos()) * outboard.rotation_by(q[1]).matrix();
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

/// Returns the inboard axis in aligned axes.
fn inboard_axis<S: Scalar>(
    axis: &[Value; 3],
    outboard: &Alignment<S>,
    values: &SymbolValues<S>,
) -> Vec3<S> {
    outboard.rotation.transposed() * values.unit(axis)
}

fn first_rotation<S: Scalar>(axis: Vec3<S>, angle: (S, S)) -> Mat3<S> {
    let others = |k: usize| axis[(k + 1) % 3].vanishes() && axis[(k + 2) % 3].vanishes();
    match (0..3).find(|&k| others(k)) {
        // A unit vector along a coordinate axis is plus or minus that axis.
        Some(k) => Mat3::axis_rotation(k, (angle.0 * axis[k], angle.1)),
        None => rotation_about(axis, angle),
    }
}
