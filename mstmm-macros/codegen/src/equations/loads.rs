//! External loads on bodies: `f_C`, `m_C` of [P, Eqs. (14), (15)].
//!
//! A wrench belongs to the point of a link, in the link's work axes, unless another frame is named.

use super::EvalContext;
use super::kinematics::{LinkKinematics, Pose, link_of, poses};
use super::springs::Springs;
use super::sweep::PerLink;
use crate::ids::LinkId;
use crate::math::{Scalar, Wrench};
use crate::model::{BodyId, InputKind, Load, LoadAxes, LoadId, Source};

/// Returns the external wrench on every link, about its point, in its work axes.
pub fn loads<S: Scalar>(
    context: &EvalContext<S>,
    links: &PerLink<LinkKinematics<S>>,
) -> PerLink<Wrench<S>> {
    let chain = context.chain;
    let mut wrenches = PerLink::filled(Wrench::zero(), links.len());
    if chain.loads.is_empty() && chain.springs.is_empty() {
        return wrenches;
    }
    let poses = poses(context, links);
    let mut add = |body: BodyId, wrench: &dyn Fn(LinkId) -> Wrench<S>| {
        // Loads on the ground have no effect.
        if let Some(link) = link_of(context.layout.parts[body]) {
            wrenches[link] = wrenches[link] + wrench(link);
        }
    };
    for (index, load) in chain.loads.enumerate() {
        add(load.body, &|link| load_wrench(context, (index, load), &links[link], &poses[link]));
    }
    Springs::new(context, links, &poses).add_to(&mut wrenches);
    wrenches
}

/// Returns the wrench of springs and dampers between bodies on every link, without their actuators, about its
/// point, in its work axes.
pub fn spring_wrenches<S: Scalar>(
    context: &EvalContext<S>,
    links: &PerLink<LinkKinematics<S>>,
) -> PerLink<Wrench<S>> {
    let mut wrenches = PerLink::filled(Wrench::zero(), links.len());
    if !context.chain.springs.is_empty() {
        Springs::new(context, links, &poses(context, links)).passive().add_to(&mut wrenches);
    }
    wrenches
}

fn load_wrench<S: Scalar>(
    context: &EvalContext<S>,
    (index, load): (LoadId, &Load),
    link: &LinkKinematics<S>,
    pose: &Pose<S>,
) -> Wrench<S> {
    let dimension = context.chain.dimension;
    let (origin, rotation) = context.frame_on(load.body, &load.at);
    let to_work = match load.axes {
        LoadAxes::Body => link.part_to_work * rotation,
        LoadAxes::Inertial => pose.to_inertial.transposed(),
    };
    let vector = |source: &Source, what, axes| to_work * context.vector(source, what, axes);
    let wrench = Wrench {
        force: vector(&load.force, InputKind::Force(index), dimension.translations()),
        moment: vector(&load.torque, InputKind::Torque(index), dimension.rotations()),
    };
    wrench.shifted_from(link.part_to_work * (origin - link.point))
}
