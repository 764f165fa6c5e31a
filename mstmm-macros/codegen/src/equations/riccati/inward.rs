//! The inward sweep, from the free ends to the ground: equations (1), (2) and (4).

use super::super::kinematics::HingeKinematics;
use super::super::motion_problem::{AffineWrench, MotionProblem};
use super::super::sweep::PerLink;
use super::super::{HingePivot, Trace, strategy};
use super::articulated_body::ArticulatedBody;
use super::eliminate::{HingeDof, constant_first, eliminate};
use super::eliminated_dof::EliminatedDof;
use super::loop_sums::LoopSums;
use crate::ids::LinkId;
use crate::math::{Scalar, SpatialInertia, Wrench};

/// The result of the inward sweep.
pub struct InwardSweep<S> {
    /// The eliminated degrees of freedom of every link.
    pub eliminated: PerLink<Vec<EliminatedDof<S>>>,
    /// `F = Iᴬ a' + pᴬ` of every link after the elimination.
    pub affine_wrenches: PerLink<AffineWrench<S>>,
    /// The sums of the loop constraints at the ground.
    pub loop_sums: Option<LoopSums<S>>,
    /// The pivots `D` of all degrees of freedom, the last link first.
    pub pivots: Vec<HingePivot<S>>,
}

/// Sweeps from the free ends to the ground.
pub fn sweep_inward<S: Scalar>(problem: &MotionProblem<S>, trace: &mut Trace<S>) -> InwardSweep<S> {
    let step = |link: LinkId, mut body: ArticulatedBody<S>, parent: &mut ArticulatedBody<S>| {
        let hinge = &problem.links[link].hinge;
        trace.section(
            format!("{}_riccati", hinge.name),
            format!("Riccati transfer over `{}`", hinge.name),
            "F = I a + p, [P, Eqs. (18), (19), (25), (35)]",
        );
        trace.inertia(&format!("{}_articulated", hinge.name), body.inertia);
        trace.wrench(&format!("{}_bias_force", hinge.name), body.bias_force);
        for (number, &wrench) in body.constraint_wrenches.iter().enumerate() {
            trace.wrench(&format!("{}_constraint{number}", hinge.name), wrench);
        }
        let mut dofs = dofs(hinge, &problem.efforts[link]);
        if problem.links[link].is_free(problem.dimension) {
            dofs = constant_first(dofs, &body, &problem.inertia(link));
        }
        let steps = eliminate(&mut body, &dofs);
        if let Some(sums) = &mut body.loop_sums {
            sums.add_dofs(&steps, problem.tree.is_repeated(link));
            sums.add_bias_acceleration(
                problem.bias_accelerations[link],
                hinge,
                &body.constraint_wrenches,
            );
        }
        let pivots = pivots(link, &body, &dofs, &steps);
        record(trace, &hinge.name, &steps, &pivots);
        let affine_wrench = AffineWrench { inertia: body.inertia, bias_force: body.bias_force };
        match problem.links[link].parent {
            Some(_) => body.add_to_parent(problem, link, parent),
            None => parent.adopt_loop(
                body.loop_on_ground(hinge.motion_from_parent(problem.base_acceleration)),
            ),
        }
        (steps, pivots, affine_wrench)
    };
    let nothing = SpatialInertia::from_fn(|_, _| S::zero());
    let ground = ArticulatedBody::new(nothing, Wrench::zero());
    let (records, ground) = problem.tree.inward(own_bodies(problem), ground, step);
    let pivots = records.iter().rev().flat_map(|(_, pivots, _)| pivots.iter().copied()).collect();
    let affine_wrenches = if strategy::keeps_affine_wrenches(problem.loop_constraints.is_some()) {
        records.iter().map(|&(.., wrench)| wrench).collect()
    } else {
        PerLink::new()
    };
    let eliminated = records.into_iter().map(|(steps, ..)| steps).collect();
    InwardSweep { eliminated, affine_wrenches, loop_sums: ground.loop_sums, pivots }
}

/// Returns the articulated bodies before the sweep: the links' own parts, with the constraint
/// wrenches of the loop hinge at its inboard link.
fn own_bodies<S: Scalar>(problem: &MotionProblem<S>) -> PerLink<ArticulatedBody<S>> {
    let body = |(link, &bias_force): (LinkId, &Wrench<S>)| {
        let inertia = problem.inertia(link);
        ArticulatedBody {
            pivot_scales: problem.pivot_scales(link),
            ..ArticulatedBody::new(inertia, bias_force)
        }
    };
    let mut bodies: PerLink<ArticulatedBody<S>> =
        problem.bias_forces.enumerate().map(body).collect();
    if let (Some(constraints), Some((link, wrenches))) =
        (&problem.loop_constraints, problem.constraint_wrenches())
    {
        let hinge = &constraints.loop_hinge.hinge;
        bodies[link].bias_force =
            bodies[link].bias_force + hinge.wrench_to_parent(constraints.applied);
        bodies[link].loop_sums = Some(LoopSums::new(wrenches.len()));
        bodies[link].constraint_wrenches = wrenches;
        bodies[link].squared_arms = hinge.arm.dot(hinge.arm);
    }
    bodies
}

/// Returns the degrees of freedom of a hinge.
fn dofs<S: Scalar>(hinge: &HingeKinematics<S>, efforts: &[S]) -> Vec<HingeDof<S>> {
    let given = efforts.iter().zip(&hinge.basis.armature);
    let columns = hinge.basis.columns.iter().zip(given).enumerate();
    let dof = |(column, (&direction, (&effort, &armature)))| HingeDof {
        column,
        direction,
        effort,
        armature,
    };
    columns.map(dof).collect()
}

/// Returns the pivots of a link's hinge.
fn pivots<S: Scalar>(
    link: LinkId,
    body: &ArticulatedBody<S>,
    dofs: &[HingeDof<S>],
    steps: &[EliminatedDof<S>],
) -> Vec<HingePivot<S>> {
    let (mass, moment) = body.pivot_scales;
    let pivot = |(dof, step): (&HingeDof<S>, &EliminatedDof<S>)| {
        let scale = dof.direction.pivot_scale(mass, moment) + dof.armature;
        HingePivot { link, value: step.pivot, scale }
    };
    dofs.iter().zip(steps).map(pivot).collect()
}

fn record<S: Scalar>(
    trace: &mut Trace<S>,
    name: &str,
    steps: &[EliminatedDof<S>],
    pivots: &[HingePivot<S>],
) {
    for (number, (step, pivot)) in steps.iter().zip(pivots).enumerate() {
        let number = if steps.len() > 1 { number.to_string() } else { String::new() };
        trace.number(format!("{name}_d{number}"), pivot.value);
        trace.number(format!("{name}_d{number}_inverse"), step.inverse);
        trace.number(format!("{name}_d{number}_scale"), pivot.scale);
        trace.wrench(&format!("{name}_gain{number}"), step.gain);
        trace.number(format!("{name}_u_over_d{number}"), step.u_over_d);
        for (constraint, &t) in step.t.iter().enumerate() {
            trace.number(format!("{name}_constraint{constraint}_t{number}"), t);
        }
    }
}
