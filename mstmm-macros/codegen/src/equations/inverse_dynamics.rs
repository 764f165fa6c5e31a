//! Inverse dynamics: the efforts that the actuators must supply for given accelerations.
//!
//! ```text
//! M(q) v̇ + bias(q, v) = τ          τ: efforts of the actuators, one for each rate
//! ```
//!
//! With `v̇` given, the accelerations of all points follow outward and the wrenches in all hinges
//! inward; no equation is solved. The bias is `τ` at `v̇ = 0`.
//!
//! # Notation
//!
//! | symbol | meaning | axes |
//! |---|---|---|
//! | `a = X a_p + b` | acceleration of a link's point, from its parent's (1) | work axes of the link |
//! | `F = I a + p + Σ Xᵀ F_c` | wrench that the hinge exerts on its link, from those in the children's hinges (2) | work axes of the link |
//! | `τ = Sᵀ F − τ_passive` | effort of the actuator; `τ_passive` are the efforts of springs, dampers, friction and stops, minus the rotor efforts that the rates require (3) | rates |

use super::base_parameters::to_base_parameters;
use super::kinematics::LinkKinematics;
use super::loads::loads;
use super::loop_hinge::loop_hinge;
use super::strategy::uses_base_parameters;
use super::sweep::PerLink;
use super::{Axes, EvalContext, Trace, kinematics};
use crate::math::{Motion, Scalar, Wrench};
use crate::model::SolutionMethod;

/// Returns the bias efforts: the efforts at all free rates that keep the rates constant, in the
/// layout's order. They balance gravity, velocities, springs, dampers, friction, stops, loads,
/// moving ends and prescribed motions. A closed chain is treated as its tree, with the loop hinge
/// open.
pub fn bias_efforts<S: Scalar>(
    context: &EvalContext<S>,
    axes: Axes,
    trace: &mut Trace<S>,
) -> Vec<S> {
    let layout = context.layout;
    let mut links = kinematics(context, axes, trace);
    let loop_hinge = loop_hinge(context, axes, &links);
    if uses_base_parameters(SolutionMethod::Riccati, axes, loop_hinge.is_some()) {
        to_base_parameters(context, &mut links, trace);
    }
    let by_link = efforts(context, &links, trace);
    let mut efforts = vec![S::zero(); layout.dof_count()];
    links.iter().zip(by_link).for_each(|(link, of_hinge)| {
        efforts[layout.v[link.hinge.id].clone()].copy_from_slice(&of_hinge);
    });
    if let Some(loop_hinge) = loop_hinge {
        let range = layout.v[loop_hinge.hinge.id].clone();
        for (effort, &passive) in efforts[range].iter_mut().zip(&loop_hinge.hinge.passives.efforts)
        {
            *effort = -passive;
        }
    }
    efforts
}

/// Returns `τ` of all free rates at `v̇ = 0`, by links: equations (1) to (3).
fn efforts<S: Scalar>(
    context: &EvalContext<S>,
    links: &PerLink<LinkKinematics<S>>,
    trace: &mut Trace<S>,
) -> PerLink<Vec<S>> {
    let external = loads(context, links);
    let (_, accelerations) = context.tree.outward(context.base_acceleration(), |link, &parent| {
        let hinge = &links[link].hinge;
        let a: Motion<S> = hinge.acceleration_from_parent(parent, hinge.bias_acceleration);
        trace.section(
            format!("{}_acceleration", hinge.name),
            format!("Acceleration of `{}` at constant rates", hinge.name),
            "[P, Eqs. (13), (36), (44)]",
        );
        trace.motion(&format!("{}_acc", hinge.name), a);
        (a, a)
    });
    let wrenches = links.enumerate().map(|(index, link)| {
        link.spatial_inertia().times(accelerations[index]) + link.velocity_wrench()
            - external[index]
    });
    let step = |link, wrench: Wrench<S>, parent: &mut Wrench<S>| {
        let hinge = &links[link].hinge;
        trace.section(
            format!("{}_wrench", hinge.name),
            format!("Wrench in `{}`", hinge.name),
            "[P, Eqs. (18), (19)]",
        );
        trace.wrench(&format!("{}_wrench", hinge.name), wrench);
        *parent = *parent + hinge.wrench_to_parent(wrench);
        if context.layout.v[hinge.id].is_empty() {
            return Vec::new();
        }
        let rates = hinge.subspace.iter().zip(&hinge.passives.efforts);
        rates.map(|(column, &passive)| column.power(wrench) - passive).collect()
    };
    context.tree.inward(wrenches.collect(), Wrench::zero(), step).0
}
