//! The transform across a hinge from the parent's side to the child's side, either of which may be
//! inboard.

use super::{ColumnFrame, HingeGeometry, SubspaceColumn};
use crate::equations::SymbolValues;
use crate::equations::strategy::rotates_in_steps;
use crate::math::{AxisRotation, FrameOrientation, Mat3, Motion, Rotation, Scalar, Vec3};
use crate::model::HingeKind;

/// The transform across a hinge at given coordinates.
#[derive(Clone, Debug)]
pub struct HingeTransform<S> {
    /// Rotation from aligned child axes to aligned parent axes.
    pub rotation: FrameOrientation<S>,
    /// The rotation before a displacement, and the small rotation, in aligned child axes, of which the displacement consists.
    pub small_rotation: Option<(Mat3<S>, Vec3<S>)>,
    /// The same rotation, if it is about one of the aligned axes.
    pub axis_rotation: Option<AxisRotation<S>>,
    /// From the parent's point to the child's in m, aligned parent axes.
    pub offset: Vec3<S>,
    /// The motion subspace: the motion of the child's point and frame relative to the parent's
    /// frame.
    columns: Vec<OrientedColumn<S>>,
    /// From the inboard origin to the outboard origin, aligned inboard axes; only if the child is
    /// the inboard side.
    outboard_offset: Option<Vec3<S>>,
}

/// A column of the motion subspace, in aligned axes of one side.
#[derive(Clone, Copy, Debug)]
struct OrientedColumn<S> {
    /// Whether that is the child's side.
    on_child: bool,
    /// The frame in which the column is constant. The middle frame has inboard axes.
    frame: ColumnFrame,
    motion: Motion<S>,
}

/// Rotations from the aligned axes of both sides to the work axes of the child.
#[derive(Clone, Copy, Debug)]
pub struct ToWorkAxes<S> {
    /// From aligned parent axes.
    pub parent_to_work: Mat3<S>,
    /// From aligned child axes.
    pub child_to_work: Mat3<S>,
}

impl<S: Scalar> ToWorkAxes<S> {
    /// The rotations to work axes from aligned axes of both sides.
    pub fn new(parent: FrameOrientation<S>, child: FrameOrientation<S>) -> Self {
        ToWorkAxes { parent_to_work: parent.matrix(), child_to_work: child.matrix() }
    }
}

/// Returns the transform across a hinge at coordinates `q`, or at a displacement from them.
pub fn hinge_transform<S: Scalar>(
    kind: &HingeKind,
    values: &SymbolValues<S>,
    (q, displacement): (&[S], Option<&[S]>),
    reversed: bool,
) -> HingeTransform<S> {
    let geometry = kind.law().geometry(values, q);
    let before = geometry.rotation.matrix();
    let (geometry, small) = match displacement {
        Some(along) => geometry.displaced(along),
        None => (geometry, None),
    };
    let transform = if reversed { inward(geometry) } else { outward(geometry) };
    let small_rotation = small.map(|small| match reversed {
        true => (before.transposed(), -(before * small)),
        false => (before, small),
    });
    HingeTransform { small_rotation, ..transform }
}

fn outward<S: Scalar>(geometry: HingeGeometry<S>) -> HingeTransform<S> {
    let HingeGeometry { rotation, axis_rotation, offset, columns } = geometry;
    let oriented = |SubspaceColumn { frame, motion }| {
        let on_child = frame == ColumnFrame::Outboard;
        OrientedColumn { on_child, frame, motion }
    };
    let columns = columns.into_iter().map(oriented).collect();
    HingeTransform {
        rotation,
        small_rotation: None,
        axis_rotation,
        offset,
        columns,
        outboard_offset: None,
    }
}

/// Returns the transform from the outboard to the inboard side. The inboard frame moves relative to
/// the outboard frame by the opposite motion, at its own origin.
fn inward<S: Scalar>(geometry: HingeGeometry<S>) -> HingeTransform<S> {
    let HingeGeometry { rotation, axis_rotation, offset, columns } = geometry;
    let back = rotation.matrix().transposed() * offset;
    let oriented = |SubspaceColumn { frame, motion }: SubspaceColumn<S>| {
        let on_child = frame != ColumnFrame::Outboard;
        let to_inboard = if on_child { -offset } else { -back };
        let motion = motion.shifted_to(to_inboard).scaled(-S::one());
        OrientedColumn { on_child, frame, motion }
    };
    HingeTransform {
        rotation: rotation.inverse(),
        small_rotation: None,
        axis_rotation: axis_rotation.map(AxisRotation::inverse),
        offset: -back,
        columns: columns.into_iter().map(oriented).collect(),
        outboard_offset: Some(offset),
    }
}

impl<S: Scalar> HingeTransform<S> {
    /// Returns the rotation to the parent: that of the hinge, followed by the fixed rotation
    /// `side`.
    pub fn rotation_to_parent(&self, side: Mat3<S>) -> Rotation<S> {
        match (self.axis_rotation, self.small_rotation) {
            (Some(steps), _) if rotates_in_steps(side) => Rotation::from_steps(side, steps),
            (_, Some((before, small))) => Rotation::from_matrix(side * before).with_small(small),
            _ => Rotation::from_matrix(side * self.rotation.matrix()),
        }
    }

    /// Returns the motion subspace `S` in work axes.
    pub fn subspace(&self, axes: &ToWorkAxes<S>) -> Vec<Motion<S>> {
        let oriented = |d: &OrientedColumn<S>| {
            d.motion.rotated(if d.on_child { axes.child_to_work } else { axes.parent_to_work })
        };
        self.columns.iter().map(oriented).collect()
    }

    /// Returns the bias acceleration `Ṡ v` of the hinge relative to the parent, work axes.
    ///
    /// Translations are constant on the inboard side. With the angular rates `ω_i`, `ω_m`, `ω_o` of
    /// columns that are constant in the inboard, the middle and the outboard frame, the outward bias
    /// acceleration is `[0; ω_i × (ω_m + ω_o) + ω_m × ω_o]`. In the inward direction, the inboard
    /// origin at `−d` in the outboard frame also has `2 ω × ḋ − ω × (ω × d)`.
    pub fn bias_acceleration(
        &self,
        subspace: &[Motion<S>],
        rates: &[S],
        axes: &ToWorkAxes<S>,
    ) -> Motion<S> {
        let [inboard, middle, outboard] = self.angular_rates(subspace, rates);
        let later = middle + outboard;
        let bias = inboard.cross(later) + middle.cross(outboard);
        let Some(offset) = self.outboard_offset else {
            return Motion { linear: Vec3::zero(), angular: bias };
        };
        let omega = inboard + later;
        let offset = axes.child_to_work * offset;
        let shift = omega.cross(offset) - combine(subspace.iter(), rates).linear;
        let linear =
            bias.cross(offset) + omega.cross(shift) * S::number(2.0) - offset.centripetal(omega);
        Motion { linear, angular: -bias }
    }

    /// Returns the angular rates of the columns that are constant in the inboard, the middle and the
    /// outboard frame, all of the outboard side relative to the inboard side, work axes.
    fn angular_rates(&self, subspace: &[Motion<S>], rates: &[S]) -> [Vec3<S>; 3] {
        let frames = [ColumnFrame::Inboard, ColumnFrame::Middle, ColumnFrame::Outboard];
        frames.map(|frame| {
            let all = subspace.iter().zip(&self.columns).zip(rates);
            let chosen = all.filter(|((_, column), _)| column.frame == frame);
            let sum =
                chosen.fold(Vec3::zero(), |sum, ((motion, _), &rate)| sum + motion.angular * rate);
            // The columns of a reversed hinge are motions of the inboard side.
            if self.outboard_offset.is_some() { -sum } else { sum }
        })
    }

    /// Returns whether the columns of the rotations are orthogonal to each other if there are three.
    pub fn has_orthogonal_rotations(&self) -> bool {
        self.columns.iter().all(|column| column.frame != ColumnFrame::Middle)
    }
}

impl<S: Scalar> HingeTransform<S> {
    /// Returns `Ṡ`: the time derivatives of the columns of the motion subspace in axes that do not rotate, work
    /// axes.
    ///
    /// `omega` are the angular velocities of the parent and of the child, `relative` is the motion of the
    /// child's point and frame relative to the parent's. A column that is constant on one side rotates with
    /// it, and one that is constant in the middle frame with that frame. In the inward direction, a column is
    /// that of the outboard origin, shifted by `−d` to the inboard origin; so `ω × (−ḋ)` is added, with `−ḋ`
    /// relative to the side where the column is constant.
    pub fn subspace_rates(
        &self,
        (subspace, rates): (&[Motion<S>], &[S]),
        ([parent, child], relative): ([Vec3<S>; 2], Motion<S>),
        axes: &ToWorkAxes<S>,
    ) -> Vec<Motion<S>> {
        let offset = self.outboard_offset.map(|offset| axes.child_to_work * offset);
        let [of_middle, ..] = self.angular_rates(subspace, rates);
        let rate = |(column, fixed): (&Motion<S>, &OrientedColumn<S>)| {
            let side = if fixed.on_child { child } else { parent };
            let frame = match fixed.frame {
                ColumnFrame::Inboard | ColumnFrame::Outboard => side,
                ColumnFrame::Middle => side + of_middle,
            };
            let linear = frame.cross(column.linear);
            let angular = frame.cross(column.angular);
            let Some(offset) = offset else { return Motion { linear, angular } };
            let shift = match fixed.on_child {
                true => relative.linear + relative.angular.cross(offset),
                false => relative.linear,
            };
            Motion { linear: linear + column.angular.cross(shift), angular }
        };
        subspace.iter().zip(&self.columns).map(rate).collect()
    }
}

/// Returns `Σ motion · amount`.
pub fn combine<'a, S: Scalar + 'a>(
    motions: impl Iterator<Item = &'a Motion<S>>,
    amounts: &[S],
) -> Motion<S> {
    motions.zip(amounts).fold(Motion::zero(), |sum, (motion, &x)| sum + motion.scaled(x))
}
