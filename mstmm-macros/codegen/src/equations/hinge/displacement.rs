//! Small displacements of a hinge along its rates, to first order.
//!
//! A displacement `δ` has one entry for each rate: the hinge moves as at the rates `δ` in a unit of time.
//! With the motion subspace `S`, the outboard frame rotates by `S_ω δ` and its origin moves by `S_v δ`.
//! This holds for every kind of hinge. It also holds for quaternions whose length is not exactly one,
//! since the displaced rotation is that of the quaternion, followed by the small rotation.

use super::{ColumnFrame, HingeGeometry, SubspaceColumn};
use crate::math::{AxisRotation, FrameOrientation, Motion, Scalar, Vec3};
use crate::model::HingeKind;

/// Returns the coordinates after a displacement from `q` along the rates: `q + N(q) δ`.
pub fn displaced<S: Scalar>(kind: &HingeKind, q: &[S], displacement: &[S]) -> Vec<S> {
    let changes = kind.law().coordinate_rates(q, displacement);
    q.iter().zip(changes).map(|(&q, change)| q + change).collect()
}

impl<S: Scalar> HingeGeometry<S> {
    /// Returns the geometry after a displacement along the rates, and the small rotation, in outboard axes, that follows
    /// the rotation if it is not about an axis.
    pub fn displaced(self, displacement: &[S]) -> (Self, Option<Vec3<S>>) {
        let along = |frame: ColumnFrame| {
            let columns = self.columns.iter().zip(displacement);
            let chosen = columns.filter(|(column, _)| column.frame == frame);
            chosen.fold(Motion::zero(), |sum, (column, &amount)| sum + column.motion.scaled(amount))
        };
        let (of_middle, outboard) = (along(ColumnFrame::Inboard), along(ColumnFrame::Outboard));
        // In inboard axes, also the columns that are constant in the middle frame.
        let inboard = of_middle + along(ColumnFrame::Middle);
        let before = self.rotation.matrix();
        let back = before.transposed();
        let turned = back * inboard.angular + outboard.angular;
        let axis_rotation = self.axis_rotation.map(|rotation| rotation.advanced(turned));
        let rotation = match &axis_rotation {
            Some(rotation) => rotation.matrix(),
            None => before.followed_by_small(turned),
        };
        let small = axis_rotation.is_none().then_some(turned);
        let offset = self.offset + inboard.linear + before * outboard.linear;
        let rotation = FrameOrientation::from_matrix(rotation);
        let moved = |column: SubspaceColumn<S>| match column.frame {
            ColumnFrame::Inboard | ColumnFrame::Outboard => column,
            ColumnFrame::Middle => {
                let Motion { linear, angular } = column.motion;
                let angular = angular + of_middle.angular.cross(angular);
                SubspaceColumn { motion: Motion { linear, angular }, ..column }
            }
        };
        let columns = self.columns.into_iter().map(moved).collect();
        (HingeGeometry { rotation, axis_rotation, offset, columns }, small)
    }
}

impl<S: Scalar> AxisRotation<S> {
    /// Returns the rotation after a small one about the same axis, the only one along which `small` has
    /// an entry.
    fn advanced(self, small: Vec3<S>) -> Self {
        let angle = small[self.axis];
        AxisRotation { sin: self.sin + self.cos * angle, cos: self.cos - self.sin * angle, ..self }
    }
}
