//! Inverse dynamics: the efforts that the drives must supply for given accelerations; and its parts.
//!
//! ```text
//! M(q) v̇ + bias(q, v) = τ          τ: efforts of the drives, one for each rate
//! ```
//!
//! With `v̇` given, the accelerations of all points follow outward and the wrenches in all hinges
//! inward; no equation is solved. The bias is `τ` at `v̇ = 0`. A closed chain is treated as its tree,
//! with the loop hinge open.
//!
//! # Notation
//!
//! | symbol | meaning | axes |
//! |---|---|---|
//! | `a = X a_p + b + S v̇` | acceleration of a link's point, from its parent's (1) | work axes of the link |
//! | `F = I a + p + Σ Xᵀ F_c` | wrench that the hinge exerts on its link, from those in the children's hinges (2) | work axes of the link |
//! | `τ = Sᵀ F + H v̇ − τ_passive` | effort of the drive; `H` are rotor inertias, `τ_passive` the efforts of springs, dampers, friction and stops, minus the rotor efforts that the rates require (3) | rates |

use super::base_parameters::base_kinematics;
use super::forward_dynamics::{ForwardDynamics, OutboardState, SweepResult};
use super::hinge::combine;
use super::kinematics::{HingeKinematics, LinkKinematics};
use super::loads::{loads, spring_wrenches};
use super::loop_hinge::{LoopHinge, loop_hinge};
use super::sweep::PerLink;
use super::{Axes, EvalContext, Trace, kinematics};
use crate::ids::IdVec;
use crate::math::{Motion, Scalar, Wrench};

/// Returns the efforts that the drives must supply, at all free rates in the layout's order. Without
/// given accelerations they are the bias efforts, which keep the rates constant. They balance gravity,
/// velocities, springs, dampers, friction, stops, loads, moving ends and prescribed motions.
pub fn inverse_dynamics<S: Scalar>(
    context: &EvalContext<S>,
    axes: Axes,
    trace: &mut Trace<S>,
) -> Vec<S> {
    let links = base_kinematics(context, axes, trace);
    let closed = loop_hinge(context, axes, &links);
    let external = loads(context, &links);
    let accelerations = accelerations(context, &links, context.base_acceleration(), trace);
    let wrenches = links.enumerate().map(|(index, link)| {
        link.spatial_inertia().times(accelerations[index]) + link.velocity_wrench()
            - external[index]
    });
    let wrenches = hinge_wrenches(context, &links, wrenches.collect(), trace);
    let of_link = |hinge: &HingeKinematics<S>, wrench| {
        let along = along_rates(hinge, wrench);
        let given = context.given_accelerations(hinge.id);
        along.into_iter().zip(own_efforts(hinge, given)).map(|(along, own)| along - own).collect()
    };
    let of_loop_hinge = |hinge: &HingeKinematics<S>| {
        let given = context.given_accelerations(hinge.id);
        own_efforts(hinge, given).into_iter().map(|own| -own).collect()
    };
    let mut efforts = by_rates(context, &links, &wrenches, of_link);
    if let Some(closed) = closed {
        let range = context.layout.v[closed.hinge.id].clone();
        efforts[range].copy_from_slice(&of_free_rates(context, &closed.hinge, of_loop_hinge));
    }
    efforts
}

/// Returns the accelerations of all points and the wrenches in all hinges for given accelerations, as
/// forward dynamics returns them. The chain must be open.
pub fn inverse_dynamics_with_wrenches<S: Scalar>(
    context: &EvalContext<S>,
    axes: Axes,
    trace: &mut Trace<S>,
) -> (ForwardDynamics<S>, SweepResult<S>) {
    let links = kinematics(context, axes, trace);
    let external = loads(context, &links);
    let accelerations = accelerations(context, &links, context.base_acceleration(), trace);
    let wrenches = links.enumerate().map(|(index, link)| {
        link.spatial_inertia().times(accelerations[index]) + link.velocity_wrench()
            - external[index]
    });
    let wrenches = hinge_wrenches(context, &links, wrenches.collect(), trace);
    let mut outboard = IdVec::filled(None, context.chain.hinges.len());
    links.enumerate().for_each(|(link, LinkKinematics { hinge, .. })| {
        let (proper_acceleration, wrench) = (accelerations[link], wrenches[link]);
        outboard[hinge.id] = Some(OutboardState { proper_acceleration, wrench });
    });
    let given = context.accelerations.map_or_else(Vec::new, <[S]>::to_vec);
    let solved = ForwardDynamics { accelerations: given, pivots: Vec::new(), reaction: None };
    (solved, SweepResult { axes, outboard })
}

/// Returns the efforts at all free rates that balance gravity alone, with every rate zero: the gradient
/// of the potential energy of gravity.
pub fn gravity_efforts<S: Scalar>(
    context: &EvalContext<S>,
    axes: Axes,
    trace: &mut Trace<S>,
) -> Vec<S> {
    let links = base_kinematics(context, axes, trace);
    let (felt, _) = context.tree.outward(context.base_acceleration(), |link, parent| {
        (links[link].hinge.motion_from_parent(*parent), ())
    });
    let wrenches = links.enumerate().map(|(index, link)| Wrench {
        force: felt[index].linear * link.mass,
        moment: link.first_moment.cross(felt[index].linear),
    });
    let wrenches = hinge_wrenches(context, &links, wrenches.collect(), trace);
    by_rates(context, &links, &wrenches, along_rates)
}

/// Returns the efforts of passive elements at all free rates: springs, dampers, friction and stops of
/// hinges, and springs between bodies. They act beside the drives, with the same sign.
pub fn passive_efforts<S: Scalar>(
    context: &EvalContext<S>,
    axes: Axes,
    trace: &mut Trace<S>,
) -> Vec<S> {
    let links = kinematics(context, axes, trace);
    let wrenches = hinge_wrenches(context, &links, spring_wrenches(context, &links), trace);
    let of_elements = |hinge: &HingeKinematics<S>| hinge.passives.element_efforts.clone();
    let closed = loop_hinge(context, axes, &links);
    with_efforts_of_hinges(context, (&links, closed), &wrenches, of_elements)
}

/// Returns the efforts at all free rates that balance loads and springs between bodies.
pub(super) fn external_efforts<S: Scalar>(
    context: &EvalContext<S>,
    axes: Axes,
    trace: &mut Trace<S>,
) -> Vec<S> {
    let links = kinematics(context, axes, trace);
    let required = loads(context, &links).into_iter().map(Wrench::reversed).collect();
    let wrenches = hinge_wrenches(context, &links, required, trace);
    by_rates(context, &links, &wrenches, along_rates)
}

/// Returns the product of the mass matrix with a vector, `M x`: the efforts for accelerations `x` of a
/// chain at rest without gravity, loads and passive elements. Rotors are part of the mass matrix.
pub fn mass_matrix_times<S: Scalar>(
    context: &EvalContext<S>,
    axes: Axes,
    trace: &mut Trace<S>,
) -> Vec<S> {
    let links = base_kinematics(context, axes, trace);
    let closed = loop_hinge(context, axes, &links);
    let (accelerations, _) = context.tree.outward(Motion::zero(), |link, parent| {
        let hinge = &links[link].hinge;
        let own = combine(hinge.subspace.iter(), context.factors(hinge.id));
        (hinge.motion_from_parent(*parent) + own, ())
    });
    let wrenches = links.enumerate();
    let wrenches =
        wrenches.map(|(index, link)| link.spatial_inertia().times(accelerations[index])).collect();
    let wrenches = hinge_wrenches(context, &links, wrenches, trace);
    let rotors =
        |hinge: &HingeKinematics<S>| hinge.passives.rotor_efforts(context.factors(hinge.id));
    with_efforts_of_hinges(context, (&links, closed), &wrenches, rotors)
}

/// Returns the accelerations of all links' points by equation (1).
pub(super) fn accelerations<S: Scalar>(
    context: &EvalContext<S>,
    links: &PerLink<LinkKinematics<S>>,
    base: Motion<S>,
    trace: &mut Trace<S>,
) -> PerLink<Motion<S>> {
    let (accelerations, _) = context.tree.outward(base, |link, &parent| {
        let hinge = &links[link].hinge;
        let bias = hinge.acceleration_from_parent(parent, hinge.bias_acceleration);
        let a = match context.given_accelerations(hinge.id) {
            Some(given) => bias + combine(hinge.subspace.iter(), given),
            None => bias,
        };
        trace.section(
            format!("{}_acceleration", hinge.name),
            format!("Acceleration of `{}`", hinge.name),
            "[P, Eqs. (13), (36), (44)]",
        );
        trace.motion(&format!("{}_acc", hinge.name), a);
        (a, ())
    });
    accelerations
}

/// Returns the wrenches in all hinges by equation (2), from the wrenches that the links' own parts
/// require.
pub(super) fn hinge_wrenches<S: Scalar>(
    context: &EvalContext<S>,
    links: &PerLink<LinkKinematics<S>>,
    of_parts: PerLink<Wrench<S>>,
    trace: &mut Trace<S>,
) -> PerLink<Wrench<S>> {
    let step = |link, wrench: Wrench<S>, parent: &mut Wrench<S>| {
        let hinge = &links[link].hinge;
        trace.section(
            format!("{}_wrench", hinge.name),
            format!("Wrench in `{}`", hinge.name),
            "[P, Eqs. (18), (19)]",
        );
        trace.wrench(&format!("{}_wrench", hinge.name), wrench);
        *parent = *parent + hinge.wrench_to_parent(wrench);
        wrench
    };
    context.tree.inward(of_parts, Wrench::zero(), step).0
}

/// Returns `Sᵀ F`.
pub(super) fn along_rates<S: Scalar>(hinge: &HingeKinematics<S>, wrench: Wrench<S>) -> Vec<S> {
    hinge.subspace.iter().map(|column| column.power(wrench)).collect()
}

/// Returns `τ_passive − H v̇`: the efforts along the rates of a hinge that its passive elements and its
/// rotors supply.
pub(super) fn own_efforts<S: Scalar>(
    hinge: &HingeKinematics<S>,
    accelerations: Option<&[S]>,
) -> Vec<S> {
    let passive = hinge.passives.efforts.iter();
    match accelerations {
        None => passive.copied().collect(),
        Some(accelerations) => {
            let rotors = hinge.passives.rotor_efforts(accelerations);
            passive.zip(rotors).map(|(&passive, rotor)| passive - rotor).collect()
        }
    }
}

/// Returns the efforts at all free rates, from those of each hinge; zero for a hinge that has no link.
pub(super) fn by_rates<S: Scalar>(
    context: &EvalContext<S>,
    links: &PerLink<LinkKinematics<S>>,
    wrenches: &PerLink<Wrench<S>>,
    of_hinge: impl Fn(&HingeKinematics<S>, Wrench<S>) -> Vec<S>,
) -> Vec<S> {
    let mut efforts = vec![S::zero(); context.layout.dof_count()];
    links.iter().zip(wrenches).for_each(|(link, &wrench)| {
        let of_link = of_free_rates(context, &link.hinge, |hinge| of_hinge(hinge, wrench));
        efforts[context.layout.v[link.hinge.id].clone()].copy_from_slice(&of_link);
    });
    efforts
}

/// Returns the efforts at all free rates, from the wrenches in the hinges and the efforts of their own parts. The loop hinge
/// of a closed chain is open and has only the latter.
pub(super) fn with_efforts_of_hinges<S: Scalar>(
    context: &EvalContext<S>,
    (links, closed): (&PerLink<LinkKinematics<S>>, Option<LoopHinge<S>>),
    wrenches: &PerLink<Wrench<S>>,
    own: impl Fn(&HingeKinematics<S>) -> Vec<S>,
) -> Vec<S> {
    let of_link = |hinge: &HingeKinematics<S>, wrench| {
        let along = along_rates(hinge, wrench).into_iter();
        along.zip(own(hinge)).map(|(along, own)| along + own).collect()
    };
    let mut efforts = by_rates(context, links, wrenches, of_link);
    if let Some(closed) = closed {
        let range = context.layout.v[closed.hinge.id].clone();
        efforts[range].copy_from_slice(&of_free_rates(context, &closed.hinge, own));
    }
    efforts
}

/// Returns the efforts of a hinge, or none if its motion is prescribed.
fn of_free_rates<S: Scalar>(
    context: &EvalContext<S>,
    hinge: &HingeKinematics<S>,
    of_hinge: impl Fn(&HingeKinematics<S>) -> Vec<S>,
) -> Vec<S> {
    if context.layout.v[hinge.id].is_empty() { Vec::new() } else { of_hinge(hinge) }
}
