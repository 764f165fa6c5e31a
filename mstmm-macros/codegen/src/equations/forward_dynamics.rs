//! Accelerations of all hinges, by either method.

use super::base_parameters::to_base_parameters;
use super::constraint_forces::ConstraintForces;
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

/// What the closing hinge exerts.
#[derive(Clone, Debug)]
pub struct LoopReaction<S> {
    /// On its outboard side at the hinge, in axes of its inboard frame.
    pub wrench: Wrench<S>,
    /// Unit wrenches, in the same axes, that could be added without any difference to the motion,
    /// one for each direction that the hinge holds; zeros where there is none.
    pub undetermined: Vec<Wrench<S>>,
    /// How well each direction is determined that the solution took, the largest first: one where
    /// nothing cancels, rounding where the direction is held already.
    pub pivots: Vec<S>,
}

/// The result of a method.
#[derive(Clone, Debug)]
pub struct ForwardDynamics<S> {
    /// `v̇` in the layout's order.
    pub accelerations: Vec<S>,
    /// The numbers divided by on the way.
    pub pivots: Vec<HingePivot<S>>,
    /// What the closing hinge exerts, if there is one.
    pub reaction: Option<LoopReaction<S>>,
}

/// What the sweeps know at the point behind a hinge, in work axes there.
#[derive(Clone, Copy, Debug)]
pub struct OutboardState<S> {
    /// The acceleration of the point, that of free fall the other way among it: what a sensor there
    /// feels.
    pub proper_acceleration: Motion<S>,
    /// What the hinge exerts on the part behind it, about the point.
    pub wrench: Wrench<S>,
}

/// What the sweeps know of all hinges besides their accelerations.
#[derive(Clone, Debug)]
pub struct SweepResult<S> {
    /// The axes that they are in.
    pub axes: Axes,
    /// By hinges; nothing of one that closes the chain, and of a weld between merged bodies.
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

/// Solves for the accelerations of all hinges and for what passes through them.
pub fn forward_dynamics_with_wrenches<S: Scalar>(
    context: &EvalContext<S>,
    method: SolutionMethod,
    axes: Axes,
    trace: &mut Trace<S>,
) -> (ForwardDynamics<S>, SweepResult<S>) {
    // What is given to parents would be missing in the wrenches.
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

/// Solves for the accelerations of all hinges, and for what `more` makes of how the links move;
/// inertias may be redistributed before.
fn solve<S: Scalar, R>(
    context: &EvalContext<S>,
    (method, axes, use_base_parameters): (SolutionMethod, Axes, bool),
    trace: &mut Trace<S>,
    finish: impl FnOnce(&MotionProblem<S>, &MotionSolution<S>, &mut Trace<S>) -> R,
) -> (ForwardDynamics<S>, R) {
    let mut links = kinematics(context, axes, trace);
    let loop_hinge = loop_hinge(context, axes, &links);
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
            // By the sum over all bodies beyond a hinge, rounding would grow with the square of
            // their number.
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

/// Newton's and Euler's laws as a problem: forces, efforts and velocities.
fn motion_problem<'a, S: Scalar>(
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
        trace.wrench(&format!("{name}_velocity_load"), link.velocity_wrench());
        trace.wrench(&format!("{name}_load"), external);
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

/// The acceleration that the outboard side of the closing hinge has of itself.
fn child_acceleration<S: Scalar>(
    loop_hinge: &LoopHinge<S>,
    links: &PerLink<LinkKinematics<S>>,
    problem: &MotionProblem<S>,
) -> Motion<S> {
    let own = match loop_hinge.child {
        None => problem.base_acceleration,
        // A moving end hangs on the ground, its motion prescribed.
        Some(link) => problem.acceleration_from_parent(link, problem.base_acceleration),
    };
    loop_hinge.motion_from_child(own) + loop_hinge.child_bias_acceleration(links)
}

/// The acceleration at the closing hinge that comes over from its inboard side, with what joins on
/// the way.
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
    let (_, _, rotation) = context.place(&hinge.inboard);
    let to_hinge = Rotation::from_matrix(part_to_work * rotation);
    let of =
        |wrench: Wrench<S>| wrench.rotated(&loop_hinge.hinge.to_parent).rotated_back(&to_hinge);
    let along = |amounts: &Vec<S>| of(loop_hinge.wrench(Wrench::zero(), amounts));
    let ConstraintForces { reactions, undetermined, pivots, .. } = &solution.constraint_forces;
    LoopReaction {
        wrench: of(loop_hinge.wrench(constraints.applied, reactions)),
        undetermined: undetermined.iter().map(along).collect(),
        pivots: pivots.clone(),
    }
}
