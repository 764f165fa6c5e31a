//! Forward dynamics: the accelerations of all hinges, by either method.
//!
//! `F` and `a` are those of [`super`]; `F = I a + p` for every link, with the bias force `p` of
//! velocities and external loads. Quantities of a link belong to its point, in its work axes;
//! quantities of the loop hinge to its outboard side, in the work axes of a link on it.

use super::base_parameters::to_base_parameters;
use super::constraint_forces::ConstraintForces;
use super::free_base::move_to_children;
use super::hinge_wrenches::hinge_wrenches;
use super::kinematics::LinkKinematics;
use super::loads::loads;
use super::loop_hinge::{LoopHinge, loop_hinge};
use super::motion_problem::{HingePivot, LoopConstraints, MotionProblem, MotionSolution};
use super::strategy::uses_base_parameters;
use super::sweep::PerLink;
use super::{Axes, EvalContext, Trace, kinematics, riccati, transfer};
use crate::ids::IdVec;
use crate::math::{Mat3, Motion, Rotation, Scalar, Wrench};
use crate::model::{HingeId, SolutionMethod};

/// The wrench in the loop hinge.
#[derive(Clone, Debug)]
pub struct LoopReaction<S> {
    /// The wrench on the outboard side at the hinge, in axes of its inboard frame, in N and N m.
    pub wrench: Wrench<S>,
    /// Unit wrenches, in the same axes, that could be added without changing the motion: one for
    /// each constraint, zero where the wrench is determined.
    pub undetermined: Vec<Wrench<S>>,
    /// The relative pivot of each step of the solution, the largest first: one if nothing cancels,
    /// the size of rounding errors if the constraint depends on others.
    pub pivots: Vec<S>,
}

/// The result of forward dynamics.
#[derive(Clone, Debug)]
pub struct ForwardDynamics<S> {
    /// `v̇` of all free rates, in the layout's order.
    pub accelerations: Vec<S>,
    /// The pivots that the method divides by.
    pub pivots: Vec<HingePivot<S>>,
    /// The wrench in the loop hinge, if the chain is closed.
    pub reaction: Option<LoopReaction<S>>,
}

/// Acceleration and wrench at the point outboard of a hinge, in work axes.
#[derive(Clone, Copy, Debug)]
pub struct OutboardState<S> {
    /// The proper acceleration of the point, as an accelerometer measures it: the acceleration
    /// minus gravity.
    pub proper_acceleration: Motion<S>,
    /// The wrench that the hinge exerts on the outboard part, about the point.
    pub wrench: Wrench<S>,
}

/// Accelerations and wrenches at all hinges.
#[derive(Clone, Debug)]
pub struct SweepResult<S> {
    /// The kind of the work axes.
    pub axes: Axes,
    /// By hinges; `None` for the loop hinge and for welds between merged bodies.
    pub outboard: IdVec<HingeId, Option<OutboardState<S>>>,
}

/// Solves for the accelerations of all hinges.
pub fn forward_dynamics<S: Scalar>(
    context: &EvalContext<S>,
    method: SolutionMethod,
    axes: Axes,
    trace: &mut Trace<S>,
) -> ForwardDynamics<S> {
    let layout = context.layout;
    let use_base_parameters = uses_base_parameters(method, axes, !layout.loop_hinges.is_empty());
    let (solved, ()) = solve(context, (method, axes, use_base_parameters), trace, |_, _, _| ());
    solved
}

/// Solves for the accelerations of all hinges and for the wrenches in them.
pub fn forward_dynamics_with_wrenches<S: Scalar>(
    context: &EvalContext<S>,
    method: SolutionMethod,
    axes: Axes,
    trace: &mut Trace<S>,
) -> (ForwardDynamics<S>, SweepResult<S>) {
    // With base parameters the wrenches would lack the inertia that was transferred to parents.
    solve(context, (method, axes, false), trace, |problem, solution, trace| {
        let wrenches = hinge_wrenches(problem, solution, trace);
        let mut outboard = IdVec::filled(None, context.chain.hinges.len());
        problem.links.enumerate().for_each(|(link, LinkKinematics { hinge, .. })| {
            let (proper_acceleration, wrench) = (solution.link_accelerations[link], wrenches[link]);
            outboard[hinge.id] = Some(OutboardState { proper_acceleration, wrench });
        });
        SweepResult { axes, outboard }
    })
}

/// Solves for the accelerations of all hinges, and calls `finish` with the solution. Base
/// parameters are used if `use_base_parameters` is true.
fn solve<S: Scalar, R>(
    context: &EvalContext<S>,
    (method, axes, use_base_parameters): (SolutionMethod, Axes, bool),
    trace: &mut Trace<S>,
    finish: impl FnOnce(&MotionProblem<S>, &MotionSolution<S>, &mut Trace<S>) -> R,
) -> (ForwardDynamics<S>, R) {
    let mut links = kinematics(context, axes, trace);
    let loop_hinge = loop_hinge(context, axes, &links);
    let free_bases =
        if use_base_parameters { move_to_children(context, &mut links) } else { Vec::new() };
    let original_inertias =
        use_base_parameters.then(|| to_base_parameters(context, &mut links, trace));
    let problem = MotionProblem {
        original_inertias,
        ..motion_problem(context, &links, loop_hinge.as_ref(), trace)
    };
    let (solution, pivots) = match method {
        SolutionMethod::Riccati => riccati::solve(&problem, trace),
        SolutionMethod::Transfer => {
            let (pivots, constraint_forces, affine_wrenches) =
                riccati::pivots_and_constraint_forces(&problem, trace);
            // A wrench as a sum over all outboard bodies would have a rounding error that grows
            // with the square of their number.
            (
                MotionSolution {
                    affine_wrenches,
                    ..transfer::solve(&problem, constraint_forces, trace)
                },
                pivots,
            )
        }
    };
    let layout = context.layout;
    let mut accelerations = solution.rates(&links, layout);
    for base in &free_bases {
        let rates = base.rates(context, &links[base.link], solution.link_accelerations[base.link]);
        accelerations[layout.v[base.hinge].clone()].copy_from_slice(&rates);
    }
    if let Some(constraints) = &problem.loop_constraints {
        let a =
            acceleration_from_inboard(constraints.loop_hinge, problem.base_acceleration, &solution);
        let a_child = child_acceleration(constraints.loop_hinge, &links, &problem);
        let relative = a_child - a;
        let range = layout.v[constraints.loop_hinge.hinge.id].clone();
        let rates = constraints.loop_hinge.rates(relative);
        if !range.is_empty() {
            accelerations[range].copy_from_slice(&rates);
        }
    }
    let reaction = problem
        .loop_constraints
        .as_ref()
        .map(|constraints| loop_reaction(context, constraints, &links, &solution));
    let result = finish(&problem, &solution, trace);
    (ForwardDynamics { accelerations, pivots, reaction }, result)
}

/// Returns the Newton-Euler equations as a linear problem.
pub(super) fn motion_problem<'a, S: Scalar>(
    context: &EvalContext<'a, S>,
    links: &'a PerLink<LinkKinematics<S>>,
    loop_hinge: Option<&'a LoopHinge<S>>,
    trace: &mut Trace<S>,
) -> MotionProblem<'a, S> {
    let external = loads(context, links);
    let bias_force = |(link, external): (&LinkKinematics<S>, Wrench<S>)| {
        let name = &link.name;
        let source = "[P, Eqs. (14), (15), (20)]";
        trace.section(format!("{name}_loads"), format!("Loads on `{name}`"), source);
        trace.wrench(&format!("{name}_velocity_wrench"), link.velocity_wrench());
        trace.wrench(&format!("{name}_external_wrench"), external);
        link.velocity_wrench() - external
    };
    let bias_forces = links.iter().zip(external).map(bias_force).collect();
    let mut problem = MotionProblem {
        links,
        dimension: context.chain.dimension,
        tree: context.tree,
        bias_accelerations: links.iter().map(|link| link.hinge.bias_acceleration).collect(),
        bias_forces,
        efforts: links.iter().map(|link| link.hinge.basis.to_basis(&link.hinge.efforts)).collect(),
        base_acceleration: context.base_acceleration(),
        loop_constraints: None,
        original_inertias: None,
        added_inertia: None,
    };
    problem.loop_constraints = loop_hinge.map(|loop_hinge| {
        let bias = loop_hinge
            .hinge
            .acceleration_from_parent(Motion::zero(), loop_hinge.hinge.bias_acceleration);
        let a = child_acceleration(loop_hinge, links, &problem) - bias;
        let efforts = &loop_hinge.hinge.efforts;
        let targets = loop_hinge.constraints.iter().map(|constraint| a.power(constraint.wrench));
        let rank = context.constraint_rank(loop_hinge.constraints.len());
        LoopConstraints {
            loop_hinge,
            targets: targets.collect(),
            applied: loop_hinge.applied_wrench(efforts),
            rank,
        }
    });
    if context.held_by_closure { problem.with_added_inertia() } else { problem }
}

/// Returns the known acceleration of the outboard side of the loop hinge.
fn child_acceleration<S: Scalar>(
    loop_hinge: &LoopHinge<S>,
    links: &PerLink<LinkKinematics<S>>,
    problem: &MotionProblem<S>,
) -> Motion<S> {
    let acceleration = match loop_hinge.child {
        None => problem.base_acceleration,
        // A moving end is attached to the ground, and its motion is prescribed.
        Some(link) => problem.acceleration_from_parent(link, problem.base_acceleration),
    };
    loop_hinge.motion_from_child(acceleration) + loop_hinge.child_bias_acceleration(links)
}

/// Returns the acceleration that the inboard side gives to the loop hinge, with the bias
/// acceleration.
fn acceleration_from_inboard<S: Scalar>(
    loop_hinge: &LoopHinge<S>,
    ground: Motion<S>,
    solution: &MotionSolution<S>,
) -> Motion<S> {
    let parent = loop_hinge.parent.map_or(ground, |link| solution.link_accelerations[link]);
    loop_hinge.hinge.acceleration_from_parent(parent, loop_hinge.hinge.bias_acceleration)
}

fn loop_reaction<S: Scalar>(
    context: &EvalContext<S>,
    constraints: &LoopConstraints<S>,
    links: &PerLink<LinkKinematics<S>>,
    solution: &MotionSolution<S>,
) -> LoopReaction<S> {
    let loop_hinge = constraints.loop_hinge;
    let part_to_work = loop_hinge.parent.map_or(Mat3::identity(), |link| links[link].part_to_work);
    let hinge = &context.chain.hinges[loop_hinge.hinge.id];
    let (_, _, rotation) = context.frame_of(&hinge.inboard);
    let to_hinge = Rotation::from_matrix(part_to_work * rotation);
    let to_inboard =
        |wrench: Wrench<S>| wrench.rotated(&loop_hinge.hinge.to_parent).rotated_back(&to_hinge);
    let wrench_along = |amounts: &Vec<S>| to_inboard(loop_hinge.wrench(Wrench::zero(), amounts));
    let ConstraintForces { reactions, undetermined, pivots, .. } = &solution.constraint_forces;
    LoopReaction {
        wrench: to_inboard(loop_hinge.wrench(constraints.applied, reactions)),
        undetermined: undetermined.iter().map(wrench_along).collect(),
        pivots: pivots.clone(),
    }
}
