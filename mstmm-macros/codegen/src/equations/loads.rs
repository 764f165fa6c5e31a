//! External loads on bodies: `f_C`, `m_C` of [P, Eqs. (14), (15)].
//!
//! A wrench belongs to the point of a link, in the link's work axes, unless another frame is named.
//! `r` is the vector from the end of a spring to the other end.

use super::EvalContext;
use super::kinematics::{LinkKinematics, Pose, link_of, poses};
use super::sweep::PerLink;
use crate::ids::LinkId;
use crate::math::{Rotation, Scalar, Vec3, Wrench};
use crate::model::{BodyId, InputKind, Load, LoadAxes, LoadId, Source, Spring, SpringEnd};

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
    for spring in &chain.springs {
        add(spring.on.body, &|link| spring_wrench(context, spring, &links[link], &poses[link]));
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

/// Returns the wrench of a spring of length `l`, `−(k (l − l₀) + c l̇) n`.
fn spring_wrench<S: Scalar>(
    context: &EvalContext<S>,
    spring: &Spring,
    link: &LinkKinematics<S>,
    pose: &Pose<S>,
) -> Wrench<S> {
    let values = context.values;
    let arm = link.part_to_work * (spring_point(context, spring) - link.point);
    let inertial = pose.position + pose.to_inertial * arm - spring_end(context, spring);
    let displacement = Rotation::from_matrix(pose.to_inertial).rotate_back(inertial);
    let velocity = pose.velocity + link.omega.cross(arm);
    let [stiffness, damping, length] =
        [&spring.stiffness, &spring.damping, &spring.length].map(|value| values.scalar(value));
    let inverse = inverse_length(displacement);
    // c l̇ / l and k (l − l₀) / l, both finite for a spring of length zero.
    let damped = damping * displacement.dot(velocity) * (inverse * inverse);
    let force = -(displacement * (stiffness - stiffness * length * inverse + damped));
    Wrench { force, moment: Vec3::zero() }.shifted_from(arm)
}

/// Returns the point where a spring is attached to a body, in the frame of the body's part.
fn spring_point<S: Scalar>(context: &EvalContext<S>, spring: &Spring) -> Vec3<S> {
    let (origin, rotation) = context.frame(spring.on.body);
    origin + rotation * context.values.vector(&spring.on.at)
}

/// Returns the other end of a spring, inertial frame.
fn spring_end<S: Scalar>(context: &EvalContext<S>, spring: &Spring) -> Vec3<S> {
    match &spring.to {
        SpringEnd::Ground(point) => context.values.vector(point),
        SpringEnd::Body(_) | SpringEnd::Previous { .. } => {
            bug!("springs between bodies are not evaluated")
        }
    }
}

/// Returns `1 / |r|`, kept finite by a length far below any that matters.
fn inverse_length<S: Scalar>(displacement: Vec3<S>) -> S {
    (displacement.dot(displacement) + S::number(1e-30)).sqrt().recip()
}

/// Returns the energy of the springs between a link's part and the ground, in J; without a link,
/// that of springs on bodies that do not move.
pub fn spring_energy<S: Scalar>(
    context: &EvalContext<S>,
    on: Option<(LinkId, &LinkKinematics<S>, &Pose<S>)>,
) -> S {
    let is_on_part = |spring: &&Spring| {
        link_of(context.layout.parts[spring.on.body]) == on.map(|(index, ..)| index)
    };
    let mut energy = S::zero();
    for spring in context.chain.springs.iter().filter(is_on_part) {
        let values = context.values;
        let point = spring_point(context, spring);
        let position = on.map_or(point, |(_, link, pose)| {
            pose.position + pose.to_inertial * (link.part_to_work * (point - link.point))
        });
        let displacement = position - spring_end(context, spring);
        let stretch = if spring.length.is_zero() {
            displacement.dot(displacement)
        } else {
            let elongation = displacement.dot(displacement) * inverse_length(displacement)
                - values.scalar(&spring.length);
            elongation * elongation
        };
        energy = energy + values.scalar(&spring.stiffness) * stretch * S::number(0.5);
    }
    energy
}
