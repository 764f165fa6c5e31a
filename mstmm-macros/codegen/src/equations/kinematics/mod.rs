//! Kinematics: orientations, angular velocities and bias accelerations of all links, from the
//! ground outward; and the poses of all links.
//!
//! # Notation
//!
//! | symbol | in code | meaning |
//! |---|---|---|
//! | `Ω` | [`LinkKinematics::omega`] | angular velocity, work axes |
//! | `m`, `m r_C`, `J` | `mass`, `first_moment`, `inertia` | of a part about its point, work axes |
//! | `S` | [`HingeKinematics::subspace`] | motion subspace: motion of the child relative to the parent for each rate |
//! | `b` | [`BiasAcceleration`] | bias acceleration of a link's point relative to the parent's |
//! | `X` | [`HingeKinematics::motion_from_parent`] | motion of the parent's point to motion of the child's point |
//!
//! Frames: the equations of a link are written in its *work axes* ([`Axes`]). `part_to_work`
//! rotates from the frame of the link's part to the work axes; `to_parent` rotates from the work
//! axes to those of the parent.

mod hinge_kinematics;
mod pose;
mod rigid_inertia;

pub use hinge_kinematics::{BiasAcceleration, HingeKinematics, hinge_kinematics};
pub use pose::{Pose, poses};
pub use rigid_inertia::RigidInertia;

use super::hinge::BasisVector;
use super::strategy::Axes;
use super::sweep::{Flatten, PerLink};
use super::{EvalContext, Trace};
use crate::ids::LinkId;
use crate::math::{FrameOrientation, Mat3, Scalar, SpatialInertia, Sym3, Vec3, Wrench};
use crate::model::{Attachment, Chain, Dimension, Hinge, Link, MovesWith};

/// The kinematics of a link, in its work axes unless another frame is named.
#[derive(Clone, Debug)]
pub struct LinkKinematics<S> {
    /// The name of the part's first body.
    pub name: String,
    /// The hinge between the link and its parent.
    pub hinge: HingeKinematics<S>,
    /// The parent link; `None` for the ground.
    pub parent: Option<LinkId>,
    /// The position of the link's point, in the frame of its part.
    pub point: Vec3<S>,
    /// Rotation from the axes of the part's frame to work axes.
    pub part_to_work: Mat3<S>,
    /// Angular velocity `Ω`.
    pub omega: Vec3<S>,
    /// Mass.
    pub mass: S,
    /// First moment `m r_C` about the point.
    pub first_moment: Vec3<S>,
    /// Rotational inertia `J` about the point.
    pub inertia: Sym3<S>,
}

/// The kinematics of a part, as its children need them.
#[derive(Clone, Copy, Debug)]
pub struct PartKinematics<S> {
    /// Rotation from the axes of the part's frame to work axes.
    pub part_to_work: FrameOrientation<S>,
    /// The position of the link's point, in the part's frame.
    pub point: Vec3<S>,
    /// Angular velocity `Ω`, work axes.
    pub omega: Vec3<S>,
}

impl<S: Scalar> PartKinematics<S> {
    /// The ground, which is at rest.
    pub fn ground() -> Self {
        let (point, omega) = (Vec3::zero(), Vec3::zero());
        PartKinematics { part_to_work: FrameOrientation::identity(), point, omega }
    }
}

impl<S: Scalar> Flatten<S> for PartKinematics<S> {
    fn visit(self, replace: &mut dyn FnMut(S) -> S) -> Self {
        let part_to_work = FrameOrientation::from_matrix(self.part_to_work.matrix().visit(replace));
        PartKinematics { part_to_work, omega: self.omega.visit(replace), ..self }
    }
}

impl<S: Scalar> LinkKinematics<S> {
    /// Returns the kinematics of the link's part.
    pub fn part(&self) -> PartKinematics<S> {
        let part_to_work = FrameOrientation::from_matrix(self.part_to_work);
        PartKinematics { part_to_work, point: self.point, omega: self.omega }
    }

    /// Whether the link is a free base: it can move in all directions of the dimension relative to
    /// the ground, without any effort.
    pub fn is_free(&self, dimension: Dimension) -> bool {
        let LinkKinematics { hinge, parent, .. } = self;
        let directions = dimension.translations().len() + dimension.rotations().len();
        let is_axis = |column: &BasisVector<S>| matches!(column, BasisVector::Axis(_));
        parent.is_none()
            && hinge.basis.columns.len() == directions
            && hinge.basis.columns.iter().all(is_axis)
            && hinge.basis.armature.iter().chain(&hinge.efforts).all(|value| value.vanishes())
    }

    /// Returns the inertia of the link about its point.
    pub fn rigid_inertia(&self) -> RigidInertia<S> {
        let &LinkKinematics { mass, first_moment, inertia, .. } = self;
        RigidInertia { mass, first_moment, inertia }
    }

    /// Returns the spatial inertia of the link about its point.
    pub fn spatial_inertia(&self) -> SpatialInertia<S> {
        self.rigid_inertia().spatial()
    }

    /// Returns the wrench that the velocities require.
    pub fn velocity_wrench(&self) -> Wrench<S> {
        self.rigid_inertia().velocity_wrench(self.omega)
    }
}

/// Returns the kinematics of all links, from the ground outward.
pub fn kinematics<S: Scalar>(
    context: &EvalContext<S>,
    axes: Axes,
    trace: &mut Trace<S>,
) -> PerLink<LinkKinematics<S>> {
    let (parts, links) = context.tree.outward(PartKinematics::ground(), |index, parent| {
        let (part, next) = link_kinematics(context, axes, &context.layout.links[index], parent);
        let name = &next.hinge.name;
        trace.section(
            format!("{name}_kinematics"),
            format!("Kinematics of `{name}`"),
            "[P, Eqs. (1), (13), (36)]",
        );
        trace.matrix(&format!("{name}_rotation"), next.hinge.to_parent.matrix());
        trace.matrix(&format!("{name}_part_to_work"), next.part_to_work);
        trace.vector(&format!("{name}_omega"), next.omega);
        trace.vector(&format!("{name}_centripetal"), next.hinge.bias_acceleration.on_parent);
        trace.motion(&format!("{name}_bias_acc"), next.hinge.bias_acceleration.in_hinge);
        trace.rigid_body(&next.name, next.mass, next.first_moment, next.inertia);
        (part, next)
    });
    let beyond = |(link, part): (LinkKinematics<S>, PartKinematics<S>)| LinkKinematics {
        part_to_work: part.part_to_work.matrix(),
        omega: part.omega,
        ..link
    };
    links.into_iter().zip(parts).map(beyond).collect()
}

/// Returns the kinematics of a link's part and of the link, from the kinematics of its parent.
fn link_kinematics<S: Scalar>(
    context: &EvalContext<S>,
    axes: Axes,
    link: &Link,
    parent: &PartKinematics<S>,
) -> (PartKinematics<S>, LinkKinematics<S>) {
    let hinge = hinge_kinematics(context, axes, (link.hinge, link.reversed), parent);
    let (_, to) = attachments(context.chain, link);
    let (_, point, rotation) = context.frame_of(to);
    let alignment = context.chain.hinges[link.hinge].kind.law().alignment(context.values);
    let child_side = FrameOrientation::from_matrix(rotation * alignment);
    let orientation = hinge.child_to_work.then(child_side.inverse());
    let part_to_work = orientation.matrix();
    let carried = hinge.to_parent.rotate_back(parent.omega);
    let rigid = rigid_inertia(context, link, to, point);
    let omega = carried + hinge.relative_velocity.angular;
    let link = LinkKinematics {
        name: context.chain.bodies[link.body].name.to_string(),
        parent: link.parent,
        point,
        part_to_work,
        omega,
        mass: rigid.mass,
        first_moment: part_to_work * rigid.first_moment,
        inertia: part_to_work.rotate_tensor(rigid.inertia),
        hinge,
    };
    (PartKinematics { part_to_work: orientation, point, omega }, link)
}

fn rigid_inertia<S: Scalar>(
    context: &EvalContext<S>,
    link: &Link,
    to: &Attachment,
    point: Vec3<S>,
) -> RigidInertia<S> {
    let values = context.values;
    let mut total = RigidInertia::zero();
    for &member in &link.members {
        let body = &context.chain.bodies[member];
        let (origin, rotation) = context.frame(member);
        // The point in the frame of the member.
        let seen = rotation.transposed() * (point - origin);
        let mass = values.scalar(&body.mass);
        let inertia = match to {
            Attachment::Input(input) if *input == member => values.inertia_about_input(body),
            _ => values.inertia_about(body, seen),
        };
        total.mass = total.mass + mass;
        total.first_moment =
            total.first_moment + rotation * ((values.vector(&body.com) - seen) * mass);
        total.inertia = total.inertia + rotation.rotate_tensor(inertia);
    }
    total
}

/// Returns the attachments of a link's hinge: the parent's, then the child's.
pub(super) fn attachments<'a>(chain: &'a Chain, link: &Link) -> (&'a Attachment, &'a Attachment) {
    let Hinge { inboard, outboard, .. } = &chain.hinges[link.hinge];
    if link.reversed { (outboard, inboard) } else { (inboard, outboard) }
}

/// Returns the link that a part moves with; `None` for the ground.
pub(super) fn link_of(part: MovesWith) -> Option<LinkId> {
    match part {
        MovesWith::Ground => None,
        MovesWith::Link(link) => Some(link),
    }
}
