//! Over a hinge from the parent's side to the child's, whichever of the two is the inboard one.

use super::{HingeGeometry, SubspaceColumn};
use crate::equations::SymbolValues;
use crate::equations::strategy::rotates_in_steps;
use crate::math::{AxisRotation, Mat3, Motion, Rotation, Scalar, Vec3};
use crate::model::HingeKind;

/// The crossing of a hinge at given coordinates.
#[derive(Clone, Debug)]
pub struct HingeTransform<S> {
    /// Aligned child axes to aligned parent axes.
    pub rotation: Mat3<S>,
    /// The same, if it is a turn about one of the aligned axes.
    pub axis_rotation: Option<AxisRotation<S>>,
    /// From the parent's point to the child's, aligned parent axes.
    pub offset: Vec3<S>,
    /// The motions of the child's point and frame against the parent's frame for each rate.
    columns: Vec<OrientedColumn<S>>,
    /// From the inboard origin to the outboard one, aligned inboard axes, if the child is the
    /// inboard side.
    outboard_offset: Option<Vec3<S>>,
}

/// A motion whose entries are given in aligned axes of the side that it turns with.
#[derive(Clone, Copy, Debug)]
struct OrientedColumn<S> {
    on_child: bool,
    motion: Motion<S>,
}

/// From aligned axes of a hinge's two sides to the axes that the child's equations are written in.
#[derive(Clone, Copy, Debug)]
pub struct ToWorkAxes<S> {
    /// From aligned parent axes.
    pub parent_to_work: Mat3<S>,
    /// From aligned child axes.
    pub child_to_work: Mat3<S>,
}

/// Crosses a hinge.
pub fn hinge_transform<S: Scalar>(
    kind: &HingeKind,
    numbers: &SymbolValues<S>,
    q: &[S],
    reversed: bool,
) -> HingeTransform<S> {
    let geometry = kind.law().geometry(numbers, q);
    if reversed { inward(geometry) } else { outward(geometry) }
}

fn outward<S: Scalar>(geometry: HingeGeometry<S>) -> HingeTransform<S> {
    let HingeGeometry { rotation, axis_rotation, offset, columns } = geometry;
    let of = |d: SubspaceColumn<S>| OrientedColumn { on_child: d.on_outboard, motion: d.motion };
    let columns = columns.into_iter().map(of).collect();
    HingeTransform { rotation, axis_rotation, offset, columns, outboard_offset: None }
}

/// The inboard frame moves against the outboard one by the opposite of what that does, seen at its
/// own origin.
fn inward<S: Scalar>(geometry: HingeGeometry<S>) -> HingeTransform<S> {
    let HingeGeometry { rotation, axis_rotation, offset, columns } = geometry;
    let back = rotation.transposed() * offset;
    let of = |d: SubspaceColumn<S>| {
        let to_inboard = if d.on_outboard { -back } else { -offset };
        let motion = d.motion.shifted_to(to_inboard).scaled(-S::one());
        OrientedColumn { on_child: !d.on_outboard, motion }
    };
    HingeTransform {
        rotation: rotation.transposed(),
        axis_rotation: axis_rotation.map(AxisRotation::inverse),
        offset: -back,
        columns: columns.into_iter().map(of).collect(),
        outboard_offset: Some(offset),
    }
}

impl<S: Scalar> HingeTransform<S> {
    /// Its rotation followed by the fixed one of the parent's side.
    pub fn rotation_to_parent(&self, side: Mat3<S>) -> Rotation<S> {
        match self.axis_rotation {
            Some(turn) if rotates_in_steps(side) => Rotation::from_steps(side, turn),
            _ => Rotation::from_matrix(side * self.rotation),
        }
    }

    /// `S`: the motions of the child against the parent for each rate, work axes.
    pub fn subspace(&self, axes: &ToWorkAxes<S>) -> Vec<Motion<S>> {
        let of = |d: &OrientedColumn<S>| {
            d.motion.rotated(if d.on_child { axes.child_to_work } else { axes.parent_to_work })
        };
        self.columns.iter().map(of).collect()
    }

    /// `Ṡ q̇`, the acceleration that the rates alone make, seen from the parent, work axes.
    ///
    /// Shifts are fixed on the inboard side; with the turning rates `ω_i`, `ω_o` of directions
    /// fixed on the two sides, outwards it is `[0; ω_i × ω_o]`. Inwards, seen from the outboard
    /// frame, the inboard origin at `−d` has besides `2 ω × ḋ − ω × (ω × d)`.
    pub fn bias_acceleration(
        &self,
        subspace: &[Motion<S>],
        rates: &[S],
        axes: &ToWorkAxes<S>,
    ) -> Motion<S> {
        let angular_rate = |on_child: bool| {
            let all = subspace.iter().zip(&self.columns).zip(rates);
            let chosen = all.filter(|((_, fixed), _)| fixed.on_child == on_child);
            chosen.fold(Vec3::zero(), |sum, ((motion, _), &rate)| sum + motion.angular * rate)
        };
        let (on_parent, on_child) = (angular_rate(false), angular_rate(true));
        let Some(offset) = self.outboard_offset else {
            return Motion { linear: Vec3::zero(), angular: on_parent.cross(on_child) };
        };
        // The inboard side is the child, and what turns here is it against the outboard one.
        let (inboard, outboard) = (-on_child, -on_parent);
        let (omega, bias) = (inboard + outboard, inboard.cross(outboard));
        let offset = axes.child_to_work * offset;
        let shift = omega.cross(offset) - combine(subspace.iter(), rates).linear;
        let linear =
            bias.cross(offset) + omega.cross(shift) * S::number(2.0) - offset.centripetal(omega);
        Motion { linear, angular: -bias }
    }
}

/// `Σ motion · amount`
pub fn combine<'a, S: Scalar + 'a>(
    motions: impl Iterator<Item = &'a Motion<S>>,
    amounts: &[S],
) -> Motion<S> {
    motions.zip(amounts).fold(Motion::zero(), |sum, (motion, &x)| sum + motion.scaled(x))
}
