//! Reads the states of connection points from the states of links and the wrenches in hinges.

use super::EvalContext;
use super::kinematics::{HingeKinematics, LinkKinematics, Pose, link_of};
use super::loop_hinge::LoopHinge;
use super::sweep::PerLink;
use crate::ids::IdVec;
use crate::math::{Mat3, Motion, Scalar, Vec3, Wrench};
use crate::model::{ConnectionPoint, Dimension, HingeId, LinkId, Transmitted};

/// A vector with the axes of its components.
#[derive(Clone, Copy, Debug)]
pub struct FramedVector<S> {
    /// Rotation from these axes to inertial axes.
    pub axes: Mat3<S>,
    /// The components.
    pub vector: Vec3<S>,
}

impl<S: Scalar> FramedVector<S> {
    /// Returns the components in inertial axes.
    pub fn inertial(&self) -> Vec3<S> {
        self.axes * self.vector
    }
}

/// The state at a connection point.
#[derive(Clone, Copy, Debug)]
pub struct PointState<S> {
    /// Its position in m, inertial frame.
    pub position: Vec3<S>,
    /// Rotation from the axes of its frame to inertial axes.
    pub rotation: Mat3<S>,
    /// Its velocity in m/s.
    pub velocity: FramedVector<S>,
    /// The angular velocity `Ω` of its frame in rad/s.
    pub omega: FramedVector<S>,
    /// Its proper acceleration in m/s²: `r̈` minus gravity.
    pub proper_acceleration: FramedVector<S>,
    /// The angular acceleration `Ω̇` in rad/s².
    pub angular_acceleration: FramedVector<S>,
    /// The internal moment `m` in N m, with the signs of [P, Sect. 2.1].
    pub moment: FramedVector<S>,
    /// The internal force `q` in N.
    pub force: FramedVector<S>,
}

/// A hinge with the wrench in it.
pub struct HingeWrench<S> {
    pub hinge: HingeKinematics<S>,
    /// The link whose work axes the first two wrenches are in; `None` for inertial axes.
    pub axes: Option<LinkId>,
    /// Exerted by the inboard side on the outboard side, about the origin of the outboard side.
    pub at_outboard: Wrench<S>,
    /// Exerted by the inboard side on the outboard side, about the origin of the inboard side.
    pub at_inboard: Wrench<S>,
    /// Exerted on the child, about its point, in the hinge's work axes.
    pub on_child: Wrench<S>,
    /// The outboard link, if both sides of the hinge are one point that is also the link's point.
    pub concentric_link: Option<LinkId>,
}

impl<S: Scalar> HingeWrench<S> {
    /// Returns the wrench in a link's hinge. At the boundary of a repeated part, the axes inboard
    /// of the hinge are used, since those outboard of it belong to another repetition.
    pub fn across(
        context: &EvalContext<S>,
        index: LinkId,
        link: &LinkKinematics<S>,
        on_child: Wrench<S>,
    ) -> Self {
        let (layout, hinge) = (&context.layout.links[index], link.hinge.clone());
        let (axes, at_child, offset) = match layout.boundary {
            Some(_) => (link.parent, on_child.rotated(&hinge.to_parent), hinge.offset),
            None => (Some(index), on_child, hinge.to_parent.rotate_back(hinge.offset)),
        };
        let at_parent = at_child.shifted_from(offset);
        let (at_outboard, at_inboard) = if layout.reversed {
            (at_parent.reversed(), at_child.reversed())
        } else {
            (at_child, at_parent)
        };
        let concentric_link = (layout.boundary.is_none() && hinge.is_concentric()).then_some(index);
        HingeWrench { hinge, axes, at_outboard, at_inboard, on_child, concentric_link }
    }

    /// Returns the wrench in the loop hinge, from the wrench on its outboard side in its parent's
    /// axes.
    pub fn loop_hinge(loop_hinge: &LoopHinge<S>, wrench: Wrench<S>) -> Self {
        let hinge = loop_hinge.hinge.clone();
        let at_inboard = wrench.shifted_from(hinge.offset);
        let on_child = wrench.rotated_back(&hinge.to_parent);
        HingeWrench {
            hinge,
            axes: loop_hinge.parent,
            at_outboard: wrench,
            at_inboard,
            on_child,
            concentric_link: None,
        }
    }
}

/// The data that the states of connection points are read from.
pub struct PointReader<'a, S> {
    pub context: &'a EvalContext<'a, S>,
    pub links: &'a PerLink<LinkKinematics<S>>,
    pub poses: &'a PerLink<Pose<S>>,
    pub proper_acceleration: &'a PerLink<Motion<S>>,
    pub hinges: &'a IdVec<HingeId, Option<HingeWrench<S>>>,
}

impl<S: Scalar> PointReader<'_, S> {
    /// Returns the state at a connection point.
    pub fn point(&self, at: &ConnectionPoint) -> PointState<S> {
        let (part, origin, rotation) = self.context.frame_of(&at.attachment);
        let link = link_of(part);
        let (force, moment) = self.force_and_moment(at, link);
        let Some(index) = link else {
            let none = self.framed(None, Vec3::zero());
            return PointState {
                position: origin,
                rotation,
                velocity: none,
                omega: none,
                proper_acceleration: self.framed(None, self.context.base_acceleration().linear),
                angular_acceleration: none,
                moment,
                force,
            };
        };
        let (link, pose) = (&self.links[index], &self.poses[index]);
        let arm = link.part_to_work * (origin - link.point);
        let (velocity, proper_acceleration) = self.velocity_and_acceleration(at, index, arm);
        PointState {
            position: pose.position + pose.to_inertial * arm,
            rotation: pose.to_inertial * (link.part_to_work * rotation),
            velocity,
            omega: self.framed(Some(index), link.omega),
            proper_acceleration,
            angular_acceleration: self.framed(Some(index), self.proper_acceleration[index].angular),
            moment,
            force,
        }
    }

    /// Returns velocity and proper acceleration of a point on a link. If the point of another link
    /// coincides with it, the known values of that link are returned.
    fn velocity_and_acceleration(
        &self,
        at: &ConnectionPoint,
        index: LinkId,
        arm: Vec3<S>,
    ) -> (FramedVector<S>, FramedVector<S>) {
        let hinge = match &at.transmitted {
            Transmitted::To(hinge) => Some(*hinge),
            Transmitted::From(hinges) => hinges.first().filter(|_| hinges.len() == 1).copied(),
        };
        let concentric_link = hinge.and_then(|hinge| self.hinges[hinge].as_ref()?.concentric_link);
        if let Some(other) = concentric_link {
            let (velocity, proper_acceleration) =
                (self.poses[other].velocity, self.proper_acceleration[other].linear);
            return (
                self.framed(Some(other), velocity),
                self.framed(Some(other), proper_acceleration),
            );
        }
        let (link, pose) = (&self.links[index], &self.poses[index]);
        let velocity = pose.velocity + link.omega.cross(arm);
        let proper_acceleration = self.proper_acceleration[index].shifted_to(arm).linear
            + arm.centripetal_by_products(link.omega);
        (self.framed(Some(index), velocity), self.framed(Some(index), proper_acceleration))
    }

    /// Returns `q` and `m` at a point: on a body `+q` and `−m` at its input, `−q` and `+m` at its
    /// output.
    fn force_and_moment(
        &self,
        at: &ConnectionPoint,
        link: Option<LinkId>,
    ) -> (FramedVector<S>, FramedVector<S>) {
        let (axes, wrench) = match &at.transmitted {
            Transmitted::To(hinge) => {
                let hinge = self.through(*hinge);
                (hinge.axes, hinge.at_outboard)
            }
            Transmitted::From(hinges) => match hinges[..] {
                [] => (None, Wrench::zero()),
                [hinge] => {
                    let hinge = self.through(hinge);
                    (hinge.axes, hinge.at_inboard)
                }
                _ => (link, self.sum_of(hinges, link)),
            },
        };
        (self.framed(axes, wrench.force), self.framed(axes, -wrench.moment))
    }

    fn through(&self, index: HingeId) -> &HingeWrench<S> {
        let hinge = &self.hinges[index];
        hinge.as_ref().unwrap_or_else(|| bug!("a hinge transmits nothing"))
    }

    /// Returns the sum of what hinges transmit from a place of a link, in the link's work axes.
    fn sum_of(&self, hinges: &[HingeId], link: Option<LinkId>) -> Wrench<S> {
        hinges.iter().fold(Wrench::zero(), |sum, &index| {
            let HingeWrench { hinge, axes, at_inboard, .. } = self.through(index);
            let wrench = match *axes == link {
                true => *at_inboard,
                false => at_inboard.rotated(&hinge.to_parent),
            };
            sum + wrench
        })
    }

    /// Returns a vector in the work axes of a link or in inertial axes. In a plane or on a line it
    /// is in the axes of the part's frame, since work axes may be perpendicular to these.
    fn framed(&self, link: Option<LinkId>, vector: Vec3<S>) -> FramedVector<S> {
        let Some(index) = link else { return FramedVector { axes: Mat3::identity(), vector } };
        let (axes, part_to_work) = (self.poses[index].to_inertial, self.links[index].part_to_work);
        match self.context.chain.dimension {
            Dimension::Space => FramedVector { axes, vector },
            Dimension::Plane | Dimension::Line => FramedVector {
                axes: axes * part_to_work,
                vector: part_to_work.transposed() * vector,
            },
        }
    }
}
