//! Poses of the links and velocities of their points.

use super::super::EvalContext;
use super::super::sweep::{Flatten, PerLink};
use super::LinkKinematics;
use crate::math::{Mat3, Scalar, Vec3};

/// The pose of a link, and the velocity of its point.
#[derive(Clone, Copy, Debug)]
pub struct Pose<S> {
    /// The position of the point in m, inertial frame.
    pub position: Vec3<S>,
    /// Rotation from work axes to inertial axes.
    pub to_inertial: Mat3<S>,
    /// The velocity of the point in m/s, work axes.
    pub velocity: Vec3<S>,
}

impl<S: Scalar> Pose<S> {
    /// The pose of the ground.
    pub fn ground() -> Self {
        Pose { position: Vec3::zero(), to_inertial: Mat3::identity(), velocity: Vec3::zero() }
    }
}

impl<S: Scalar> Flatten<S> for Pose<S> {
    fn visit(self, replace: &mut dyn FnMut(S) -> S) -> Self {
        let position = self.position.visit(replace);
        let to_inertial = self.to_inertial.visit(replace);
        Pose { position, to_inertial, velocity: self.velocity.visit(replace) }
    }
}

/// Returns the poses of all links [P, Eq. (12)].
pub fn poses<S: Scalar>(
    context: &EvalContext<S>,
    links: &PerLink<LinkKinematics<S>>,
) -> PerLink<Pose<S>> {
    let (poses, _) = context.tree.outward(Pose::ground(), |index, from| {
        let hinge = &links[index].hinge;
        let carried = from.velocity + hinge.parent_omega.cross(hinge.arm);
        let pose = Pose {
            position: from.position + from.to_inertial * hinge.arm,
            to_inertial: from.to_inertial * hinge.to_parent.matrix(),
            velocity: hinge.to_parent.rotate_back(carried) + hinge.relative_velocity.linear,
        };
        (pose, ())
    });
    poses
}
