//! Kinematics without dynamics: the motions of all bodies at `v̇ = 0`, and the motion that each rate
//! causes.
//!
//! # Notation
//!
//! All vectors are in inertial axes. Subscript `p` marks the parent of a link; `arm` is from the
//! parent's point to the link's.
//!
//! | symbol | meaning |
//! |---|---|
//! | `r`, `A` | position of a body's input, rotation from its axes to inertial axes |
//! | `ṙ`, `Ω` | velocity of the input, angular velocity |
//! | `b`, `β` | bias accelerations: `r̈` and `Ω̇` at `v̇ = 0`, without gravity (1) |
//! | `J_j = [u; ω]` | column of rate `j`: the velocity `u` of the point of the outboard body that is at the inertial origin, and its angular velocity `ω`, for a rate of one (2) |
//!
//! ```text
//! (1)  b = b_p + β_p × arm + Ω_p × (Ω_p × arm) + b_hinge      β = β_p + β_hinge
//! (2)  ω = s_ω,  u = s_r + r × s_ω                            s: column of the motion subspace at r
//! ```
//!
//! At the inertial origin a column serves all points of all bodies outboard of its hinge: the velocity of
//! the point at `P` is `u + ω × P`. A sum of columns is moved to the point once.

use super::kinematics::{BiasAcceleration, LinkKinematics, Pose, link_of, poses};
use super::sweep::PerLink;
use super::{Axes, EvalContext, Trace, kinematics};
use crate::math::{Mat3, Motion, Scalar, Vec3};
use crate::model::BodyId;

/// The motion of a body at `v̇ = 0`, inertial axes.
#[derive(Clone, Copy, Debug)]
pub struct BodyMotion<S> {
    /// Position of the input in m.
    pub position: Vec3<S>,
    /// Rotation from the axes of the body to inertial axes.
    pub rotation: Mat3<S>,
    /// Velocity of the input in m/s.
    pub velocity: Vec3<S>,
    /// Angular velocity in rad/s.
    pub omega: Vec3<S>,
    /// Bias accelerations of the input.
    pub bias_acceleration: Motion<S>,
}

/// The motions of all bodies, and the columns of all rates.
#[derive(Clone, Debug)]
pub struct ChainKinematics<S> {
    /// The motion of each requested body.
    pub bodies: Vec<BodyMotion<S>>,
    /// The columns of all free rates, in the layout's order; zero for the loop hinge.
    pub columns: Vec<Motion<S>>,
}

/// Returns the motions of `bodies` and the columns of all rates.
pub fn chain_kinematics<S: Scalar>(
    context: &EvalContext<S>,
    bodies: &[BodyId],
    trace: &mut Trace<S>,
) -> ChainKinematics<S> {
    let links = kinematics(context, Axes::Inertial, trace);
    let poses = poses(context, &links);
    let bias = bias_accelerations(context, &links);
    links.enumerate().for_each(|(index, link)| {
        let name = &link.hinge.name;
        trace.section(
            format!("{name}_motion"),
            format!("Motion outboard of `{name}`"),
            "[P, Eqs. (12), (13)]",
        );
        trace.vector(&format!("{name}_position"), poses[index].position);
        trace.vector(&format!("{name}_velocity"), poses[index].velocity);
        trace.motion(&format!("{name}_bias"), bias[index]);
    });
    let reader = MotionReader { context, links: &links, poses: &poses, bias: &bias };
    let bodies = bodies.iter().map(|&body| reader.body(body)).collect();
    ChainKinematics { bodies, columns: columns(context, &links, &poses, trace) }
}

/// Returns the columns of the Jacobian of the point at `place` in the frame of a body: one for each free rate
/// in the layout's order, about the point. The columns of rates that do not move the body vanish.
///
/// Only the links between the ground and the body matter, so that a function for a single body computes
/// nothing else.
pub fn point_jacobian<S: Scalar>(
    context: &EvalContext<S>,
    body: BodyId,
    place: Vec3<S>,
    trace: &mut Trace<S>,
) -> Vec<Motion<S>> {
    let mut columns = vec![Motion::zero(); context.layout.dof_count()];
    let Some(moved) = link_of(context.layout.parts[body]) else { return columns };
    let links = kinematics(context, Axes::Inertial, trace);
    let poses = poses(context, &links);
    let link = &links[moved];
    let (origin, rotation) = context.frame(body);
    let arm = link.part_to_work * (origin - link.point + rotation * place);
    let point = poses[moved].position + arm;
    trace.section("jacobian", "Jacobian of the point", "");
    for inboard in context.tree.path_to(moved) {
        let hinge = &links[inboard].hinge;
        let range = context.layout.v[hinge.id].clone();
        let free = columns[range].iter_mut().zip(&hinge.subspace);
        for (number, (column, unit)) in free.enumerate() {
            *column = unit.shifted_to(point - poses[inboard].position);
            trace.motion(&format!("{}_column{number}", hinge.name), *column);
        }
    }
    columns
}

/// Returns the bias accelerations of all links' points by equation (1).
fn bias_accelerations<S: Scalar>(
    context: &EvalContext<S>,
    links: &PerLink<LinkKinematics<S>>,
) -> PerLink<Motion<S>> {
    let (bias, _) = context.tree.outward(Motion::zero(), |index, &parent| {
        let hinge = &links[index].hinge;
        // This form shares `Ω_p × arm` with the velocity.
        let on_parent = hinge.arm.centripetal(hinge.parent_omega);
        let own = BiasAcceleration { on_parent, ..hinge.bias_acceleration };
        (hinge.acceleration_from_parent(parent, own), ())
    });
    bias
}

/// Returns the columns of all free rates by equation (2).
fn columns<S: Scalar>(
    context: &EvalContext<S>,
    links: &PerLink<LinkKinematics<S>>,
    poses: &PerLink<Pose<S>>,
    trace: &mut Trace<S>,
) -> Vec<Motion<S>> {
    trace.section("jacobian", "Motion of each rate", "");
    let mut columns = vec![Motion::zero(); context.layout.dof_count()];
    links.enumerate().for_each(|(index, link)| {
        let range = context.layout.v[link.hinge.id].clone();
        let free = columns[range].iter_mut().zip(&link.hinge.subspace);
        for (number, (column, unit)) in free.enumerate() {
            *column = unit.shifted_to(-poses[index].position);
            trace.motion(&format!("{}_column{number}", link.hinge.name), *column);
        }
    });
    columns
}

/// The data that the motions of bodies are read from, in inertial axes.
struct MotionReader<'a, S> {
    context: &'a EvalContext<'a, S>,
    links: &'a PerLink<LinkKinematics<S>>,
    poses: &'a PerLink<Pose<S>>,
    bias: &'a PerLink<Motion<S>>,
}

impl<S: Scalar> MotionReader<'_, S> {
    fn body(&self, body: BodyId) -> BodyMotion<S> {
        let (origin, rotation) = self.context.frame(body);
        let Some(index) = link_of(self.context.layout.parts[body]) else {
            let (velocity, omega) = (Vec3::zero(), Vec3::zero());
            let bias_acceleration = Motion::zero();
            return BodyMotion { position: origin, rotation, velocity, omega, bias_acceleration };
        };
        let (link, pose) = (&self.links[index], &self.poses[index]);
        let arm = link.part_to_work * (origin - link.point);
        let Motion { linear, angular } = self.bias[index].shifted_to(arm);
        let linear = linear + arm.centripetal(link.omega);
        BodyMotion {
            position: pose.position + arm,
            rotation: link.part_to_work * rotation,
            velocity: pose.velocity + link.omega.cross(arm),
            omega: link.omega,
            bias_acceleration: Motion { linear, angular },
        }
    }
}
