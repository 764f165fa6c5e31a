//! Universal: turns about an axis fixed on the inboard side, then about one fixed on the outboard
//! side.
//!
//! Coordinates: both angles in rad; `A = A_a(α) A_b(β)`. Aligned axes have one coordinate axis
//! along the outboard one.

use super::axis::{Alignment, turn_about};
use super::law::{HingeLaw, coordinates_change_by, free_of_quaternions};
use super::{HingeGeometry, StrainMap, SubspaceColumn};
use crate::equations::SymbolValues;
use crate::math::{Mat3, Scalar, Vec3};
use crate::model::Value;

/// A universal hinge.
#[derive(Clone, Copy, Debug)]
pub struct Universal<'a> {
    /// The axis fixed on the inboard side, and the one fixed on the outboard side.
    pub axes: &'a [[Value; 3]; 2],
}

impl<S: Scalar> HingeLaw<S> for Universal<'_> {
    /// Two turns, each about an axis fixed on its side; the first carries the second's axis with
    /// it.
    fn geometry(&self, numbers: &SymbolValues<S>, q: &[S]) -> HingeGeometry<S> {
        let outboard = Alignment::with(&self.axes[1], numbers);
        let first = inboard_axis(&self.axes[0], &outboard, numbers);
        let rotation = first_turn(first, q[0].sin_cos()) * outboard.turn(q[1]).matrix();
        HingeGeometry {
            rotation,
            directions: vec![
                SubspaceColumn::about(first),
                SubspaceColumn::about(outboard.direction()).outboard(),
            ],
            ..HingeGeometry::fixed()
        }
    }

    fn alignment(&self, numbers: &SymbolValues<S>) -> Mat3<S> {
        Alignment::with(&self.axes[1], numbers).rotation
    }

    fn coordinate_rates(&self, _: &[S], v: &[S]) -> Vec<S> {
        coordinates_change_by(v)
    }

    fn normalized(&self, q: &[S]) -> Vec<S> {
        free_of_quaternions(q)
    }

    fn strains(&self, _: &[S]) -> StrainMap<S> {
        StrainMap::change_by_rates(2)
    }
}

/// The inboard axis in aligned axes.
fn inboard_axis<S: Scalar>(
    axis: &[Value; 3],
    outboard: &Alignment<S>,
    numbers: &SymbolValues<S>,
) -> Vec3<S> {
    outboard.rotation.transposed() * numbers.unit(axis)
}

fn first_turn<S: Scalar>(axis: Vec3<S>, angle: (S, S)) -> Mat3<S> {
    let others = |k: usize| axis[(k + 1) % 3].vanishes() && axis[(k + 2) % 3].vanishes();
    match (0..3).find(|&k| others(k)) {
        // A unit vector along a coordinate axis is plus or minus that axis.
        Some(k) => Mat3::turn_about(k, (angle.0 * axis[k], angle.1)),
        None => turn_about(axis, angle),
    }
}
