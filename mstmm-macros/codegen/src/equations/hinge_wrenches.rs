//! The wrenches in all hinges, from the accelerations of the links [P, Eqs. (18), (19)].
//!
//! With `a` of the link's point, the inertia `I` and the bias force `p` of the link's part, and the
//! wrenches `F_c` in the children's hinges, all in work axes:
//!
//! (1)  `F = I a + p + Σ X_cᵀ F_c`
//! (2)  `F = Iᴬ a' + pᴬ`, with the articulated inertia of the Riccati transfer

use super::Trace;
use super::motion_problem::{MotionProblem, MotionSolution};
use super::strategy::MAX_SUMMED_BODIES;
use super::sweep::{Flatten, PerLink};
use crate::ids::LinkId;
use crate::math::{Scalar, Wrench};

/// Returns the wrench that every link's hinge exerts on the link, about the link's point, in its
/// work axes. Along an axis that the hinge leaves free, the wrench is exactly the hinge's effort
/// [P, Eqs. (25), (57), (58)].
pub fn hinge_wrenches<S: Scalar>(
    problem: &MotionProblem<S>,
    solution: &MotionSolution<S>,
    trace: &mut Trace<S>,
) -> PerLink<Wrench<S>> {
    let mut wrenches = sum_inward(problem, solution);
    if let Some(constraints) = &problem.loop_constraints {
        let reaction = constraints
            .loop_hinge
            .wrench(constraints.applied, &solution.constraint_forces.reactions);
        if let Some((child, on_child)) = constraints.loop_hinge.wrench_on_child(reaction) {
            wrenches[child] = wrenches[child] - on_child;
        }
    }
    let with_efforts = |(index, &wrench): (LinkId, &Wrench<S>)| {
        let hinge = &problem.links[index].hinge;
        let wrench = hinge.basis.with_applied_efforts(wrench, &hinge.efforts);
        trace.section(
            format!("{}_wrench", hinge.name),
            format!("Wrench in `{}`", hinge.name),
            "[P, Eqs. (18), (19)]",
        );
        trace.wrench(&format!("{}_wrench", hinge.name), wrench);
        wrench
    };
    wrenches.enumerate().map(with_efforts).collect()
}

/// Returns the wrenches by equation (1), from the free ends inward. Equation (2) is used if the sum
/// (1) would have many terms, and at the boundaries of repeated parts.
fn sum_inward<S: Scalar>(
    problem: &MotionProblem<S>,
    solution: &MotionSolution<S>,
) -> PerLink<Wrench<S>> {
    let own_wrench = |(index, &load): (LinkId, &Wrench<S>)| {
        problem.inertia(index).times(solution.link_accelerations[index]) + load
    };
    let mut wrenches: PerLink<Wrench<S>> =
        problem.bias_forces.enumerate().map(own_wrench).collect();
    if let (Some(constraints), Some((link, constraint_wrenches))) =
        (&problem.loop_constraints, problem.constraint_wrenches())
    {
        let applied =
            wrenches[link] + constraints.loop_hinge.hinge.wrench_to_parent(constraints.applied);
        wrenches[link] =
            with_reactions(applied, &constraint_wrenches, &solution.constraint_forces.reactions);
    }
    let uses_affine_wrench = uses_affine_wrench(problem, solution);
    let sum = |(wrench, &elsewhere)| WrenchSum(if elsewhere { None } else { Some(wrench) });
    let sums = wrenches.into_iter().zip(&uses_affine_wrench).map(sum).collect();
    let step = |link: LinkId, WrenchSum(sum): WrenchSum<S>, parent: &mut WrenchSum<S>| {
        let wrench = sum.unwrap_or_else(|| {
            let a = problem.parent_acceleration(link, &solution.link_accelerations);
            solution.affine_wrenches[link].at(problem.acceleration_from_parent(link, a))
        });
        let hinge = &problem.links[link].hinge;
        let released = hinge.basis.with_applied_efforts(wrench, &hinge.efforts);
        parent.add(|| hinge.wrench_to_parent(released));
        wrench
    };
    problem.tree.inward(sums, WrenchSum(None), step).0
}

/// Returns the hinges whose wrench follows from equation (2).
fn uses_affine_wrench<S: Scalar>(
    problem: &MotionProblem<S>,
    solution: &MotionSolution<S>,
) -> PerLink<bool> {
    if solution.affine_wrenches.is_empty() {
        return PerLink::filled(false, problem.links.len());
    }
    let counts = PerLink::filled(BodyCount(1), problem.links.len());
    let step = |link: LinkId, BodyCount(count): BodyCount, parent: &mut BodyCount| {
        let at_boundary = problem.tree.is_boundary(link);
        let is_chosen = at_boundary || count > MAX_SUMMED_BODIES;
        // The bodies outboard of a boundary belong to another repetition, and cannot be summed.
        let beyond = match is_chosen {
            _ if at_boundary => MAX_SUMMED_BODIES,
            true => 0,
            false => count,
        };
        parent.0 = parent.0.max(beyond + 1);
        is_chosen
    };
    problem.tree.inward(counts, BodyCount(0), step).0
}

/// A wrench as a sum over a part and its children; `None` if the wrench is computed in another way.
#[derive(Clone, Copy, Debug)]
pub struct WrenchSum<S>(pub Option<Wrench<S>>);

impl<S: Scalar> WrenchSum<S> {
    /// Adds a wrench, if there is a sum.
    pub fn add(&mut self, more: impl FnOnce() -> Wrench<S>) {
        if let Some(sum) = &mut self.0 {
            *sum = *sum + more();
        }
    }
}

impl<S: Scalar> Flatten<S> for WrenchSum<S> {
    fn visit(self, replace: &mut dyn FnMut(S) -> S) -> Self {
        WrenchSum(self.0.visit(replace))
    }
}

/// The largest number of bodies that are summed outboard of a link.
#[derive(Clone, Copy)]
struct BodyCount(usize);

impl<S> Flatten<S> for BodyCount {
    fn visit(self, _: &mut dyn FnMut(S) -> S) -> Self {
        self
    }
}

/// Returns the wrench with the constraint forces of a loop hinge added.
fn with_reactions<S: Scalar>(
    wrench: Wrench<S>,
    constraint_wrenches: &[Wrench<S>],
    reactions: &[S],
) -> Wrench<S> {
    constraint_wrenches
        .iter()
        .zip(reactions)
        .fold(wrench, |sum, (&pull, &reaction)| sum + pull.scaled(reaction))
}
