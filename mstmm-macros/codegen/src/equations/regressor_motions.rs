//! The motions that the regressor of a chain in space is made of.
//!
//! An entry of the regressor is the power of a wrench on a virtual motion (see [`mod@super::regressor`]). The
//! wrench depends on the body and the parameter, the virtual motion on the body and the rate. In inertial
//! axes, about one point, the virtual motions of a rate are the same for all bodies outboard of it. So a
//! regressor follows from one column for each rate and from the pose and the motion of each body, and the
//! virtual motions of all rates are rotated to the axes of a body side by side.
//!
//! Positions are relative to the point of the first link, so that a chain far from the inertial origin has
//! the same rounding errors as one that is there.

use super::inverse_dynamics::accelerations;
use super::kinematics::{LinkKinematics, link_of};
use super::regressor::{ToBody, of_element};
use super::sweep::{Flatten, PerLink};
use super::{Axes, EvalContext, Trace, kinematics};
use crate::math::{Mat3, Motion, Scalar, Vec3};
use crate::model::{BodyId, DynamicParameter};

/// The pose of a body, and its motion for the given accelerations.
#[derive(Clone, Copy, Debug)]
pub struct GivenMotion<S> {
    /// Position of the input relative to the point of the first link, inertial axes.
    pub position: Vec3<S>,
    /// Rotation from the axes of the body to inertial axes.
    pub rotation: Mat3<S>,
    /// Angular velocity, axes of the body.
    pub omega: Vec3<S>,
    /// Proper acceleration of the input, axes of the body.
    pub acceleration: Motion<S>,
}

/// What the regressor of a chain follows from.
#[derive(Clone, Debug)]
pub struct RegressorMotions<S> {
    /// The motions of all bodies.
    pub bodies: Vec<GivenMotion<S>>,
    /// The motions that all free rates cause at the point of the first link, inertial axes.
    pub columns: Vec<Motion<S>>,
    /// The entries of the columns of passive elements at the rates of their hinges.
    pub passive: Vec<S>,
}

/// Returns what the regressor of an open tree in space follows from.
pub fn regressor_motions<S: Scalar>(
    context: &EvalContext<S>,
    axes: Axes,
    trace: &mut Trace<S>,
) -> RegressorMotions<S> {
    let links = kinematics(context, axes, trace);
    let accelerations = accelerations(context, &links, context.base_acceleration(), trace);
    let poses = relative_poses(context, &links);
    let of_body = |body: BodyId| {
        let Some(index) = link_of(context.layout.parts[body]) else {
            // No rate moves a body on the ground.
            let (position, omega) = (Vec3::zero(), Vec3::zero());
            let acceleration = Motion::zero();
            return GivenMotion { position, rotation: Mat3::identity(), omega, acceleration };
        };
        let (link, RelativePose { position, to_inertial }) = (&links[index], poses[index]);
        let to_body = ToBody::new(context, link, body);
        GivenMotion {
            position: position + to_inertial * to_body.arm,
            rotation: to_inertial * to_body.rotation.transposed(),
            omega: to_body.rotation * link.omega,
            acceleration: to_body.acceleration(link, accelerations[index]),
        }
    };
    let mut columns = vec![Motion::zero(); context.layout.dof_count()];
    links.enumerate().for_each(|(index, LinkKinematics { hinge, .. })| {
        let RelativePose { position, to_inertial } = poses[index];
        let range = context.layout.v[hinge.id].clone();
        for (column, unit) in columns[range].iter_mut().zip(&hinge.subspace) {
            *column = unit.rotated(to_inertial).shifted_to(-position);
        }
    });
    let parameters = context.chain.dynamic_parameters().into_iter();
    let passive = parameters.filter_map(|parameter| match parameter {
        DynamicParameter::Passive(hinge, k, element) => {
            Some(of_element(context, hinge, (k, element)))
        }
        DynamicParameter::Inertial(..) => None,
    });
    RegressorMotions {
        bodies: context.chain.physical_bodies().map(of_body).collect(),
        columns,
        passive: passive.flatten().collect(),
    }
}

/// The pose of a link relative to the point of the first link.
#[derive(Clone, Copy)]
struct RelativePose<S> {
    position: Vec3<S>,
    /// Rotation from work axes to inertial axes.
    to_inertial: Mat3<S>,
}

impl<S: Scalar> Flatten<S> for RelativePose<S> {
    fn visit(self, replace: &mut dyn FnMut(S) -> S) -> Self {
        let position = self.position.visit(replace);
        RelativePose { position, to_inertial: self.to_inertial.visit(replace) }
    }
}

fn relative_poses<S: Scalar>(
    context: &EvalContext<S>,
    links: &PerLink<LinkKinematics<S>>,
) -> PerLink<RelativePose<S>> {
    let first = context.layout.links.enumerate().next().map(|(index, _)| index);
    let origin = first.map_or_else(Vec3::zero, |first| links[first].hinge.arm);
    let ground = RelativePose { position: -origin, to_inertial: Mat3::identity() };
    let (poses, _) = context.tree.outward(ground, |index, from| {
        let hinge = &links[index].hinge;
        let position = match Some(index) == first {
            true => Vec3::zero(),
            false => from.position + from.to_inertial * hinge.arm,
        };
        let to_inertial = from.to_inertial * hinge.to_parent.matrix();
        (RelativePose { position, to_inertial }, ())
    });
    poses
}
