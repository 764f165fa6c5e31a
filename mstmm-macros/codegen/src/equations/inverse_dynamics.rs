//! Inverse dynamics: which efforts the drives must supply for given accelerations.
//!
//! ```text
//! M(q) v̇ + bias(q, v) = τ          τ: efforts of the drives, one for each rate
//! ```
//!
//! With `v̇` given, the accelerations of all points follow outwards and the wrenches in all hinges
//! inwards; nothing is solved. The bias is `τ` at `v̇ = 0`.
//!
//! # Notation
//!
//! | symbol | meaning | axes |
//! |---|---|---|
//! | `a = X a_p + b` | acceleration of a link's point, from its parent's (1) | work axes of the link |
//! | `F = A a + p + Σ Xᵀ F_c` | what the hinge exerts on its part, from those of its children (2) | work axes of the link |
//! | `τ = Sᵀ F − τ_passive` | what the drive must supply, `τ_passive` of springs, dampers, friction and stops, less what rates alone demand of rotors (3) | rates |

use super::base_parameters::redistribute;
use super::kinematics::LinkKinematics;
use super::loads::loads;
use super::loop_hinge::closing;
use super::strategy::uses_base_parameters;
use super::sweep::PerLink;
use super::{Axes, EvalContext, Trace, motion};
use crate::math::{Motion, Scalar, Wrench};
use crate::model::SolutionMethod;

/// The efforts that the drives of all free rates must supply so that no rate changes, in the
/// layout's order: against gravity, velocities, springs, dampers, friction, stops, loads, moving
/// ends and prescribed motions. A closed chain is the tree of its hinges, with the closing hinge
/// open.
pub fn bias_efforts<S: Scalar>(
    situation: &EvalContext<S>,
    axes: Axes,
    trace: &mut Trace<S>,
) -> Vec<S> {
    let layout = situation.layout;
    let mut links = motion(situation, axes, trace);
    let closing = closing(situation, axes, &links);
    if uses_base_parameters(SolutionMethod::Riccati, axes, closing.is_some()) {
        redistribute(situation, &mut links, trace);
    }
    let along = efforts(situation, &links, trace);
    let mut efforts = vec![S::zero(); layout.dof_count()];
    links.iter().zip(along).for_each(|(link, along)| {
        efforts[layout.v[link.over.hinge].clone()].copy_from_slice(&along);
    });
    if let Some(closing) = closing {
        let range = layout.v[closing.over.hinge].clone();
        for (effort, &passive) in efforts[range].iter_mut().zip(&closing.over.passives.efforts) {
            *effort = -passive;
        }
    }
    efforts
}

/// `τ` of all free rates at `v̇ = 0`, by links: equations (1) to (3).
fn efforts<S: Scalar>(
    situation: &EvalContext<S>,
    links: &PerLink<LinkKinematics<S>>,
    trace: &mut Trace<S>,
) -> PerLink<Vec<S>> {
    let outer = loads(situation, links);
    let (_, accelerations) = situation.tree.outward(situation.ground(), |link, &parent| {
        let over = &links[link].over;
        let a: Motion<S> = over.carried_with(parent, over.drift);
        trace.section(
            format!("{}_bias", over.name),
            format!("Acceleration of `{}` without changes of rates", over.name),
            "[P, Eqs. (13), (36), (44)]",
        );
        trace.motion(&format!("{}_bias", over.name), a);
        (a, a)
    });
    let own = links.enumerate().map(|(index, link)| {
        link.rigid().times(accelerations[index]) + link.velocity_load() - outer[index]
    });
    let step = |link, wrench: Wrench<S>, parent: &mut Wrench<S>| {
        let over = &links[link].over;
        trace.section(
            format!("{}_wrench", over.name),
            format!("Wrench in `{}`", over.name),
            "[P, Eqs. (18), (19)]",
        );
        trace.wrench(&format!("{}_wrench", over.name), wrench);
        *parent = *parent + over.returned(wrench);
        if situation.layout.v[over.hinge].is_empty() {
            return Vec::new();
        }
        let rates = over.subspace.iter().zip(&over.passives.efforts);
        rates.map(|(column, &passive)| column.power(wrench) - passive).collect()
    };
    situation.tree.inward(own.collect(), Wrench::zero(), step).0
}
