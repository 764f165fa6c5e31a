//! Accelerations of all hinges, by either method.

use super::base_parameters::redistribute;
use super::constraint_forces::ConstraintForces;
use super::hinge_wrenches::transmitted;
use super::kinematics::LinkKinematics;
use super::loads::loads;
use super::loop_hinge::{LoopHinge, closing};
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
    pub felt: Motion<S>,
    /// What the hinge exerts on the part behind it, about the point.
    pub wrench: Wrench<S>,
}

/// What the sweeps know of all hinges besides their accelerations.
#[derive(Clone, Debug)]
pub struct SweepResult<S> {
    /// The axes that they are in.
    pub axes: Axes,
    /// By hinges; nothing of one that closes the chain, and of a weld between merged bodies.
    pub behind: IdVec<HingeId, Option<OutboardState<S>>>,
}

/// Solves for the accelerations of all hinges.
pub fn accelerations<S: Scalar>(
    context: &EvalContext<S>,
    method: SolutionMethod,
    axes: Axes,
    trace: &mut Trace<S>,
) -> ForwardDynamics<S> {
    let layout = context.layout;
    let to_parents = uses_base_parameters(method, axes, !layout.loop_hinges.is_empty());
    let (solved, ()) = solve(context, (method, axes, to_parents), trace, |_, _, _| ());
    solved
}

/// Solves for the accelerations of all hinges and for what passes through them.
pub fn sweep<S: Scalar>(
    context: &EvalContext<S>,
    method: SolutionMethod,
    axes: Axes,
    trace: &mut Trace<S>,
) -> (ForwardDynamics<S>, SweepResult<S>) {
    // What is given to parents would be missing in the wrenches.
    solve(context, (method, axes, false), trace, |problem, movement, trace| {
        let wrenches = transmitted(problem, movement, trace);
        let mut behind = IdVec::filled(None, context.chain.hinges.len());
        problem.links.enumerate().for_each(|(link, LinkKinematics { hinge, .. })| {
            let (felt, wrench) = (movement.points[link], wrenches[link]);
            behind[hinge.id] = Some(OutboardState { felt, wrench });
        });
        SweepResult { axes, behind }
    })
}

/// Solves for the accelerations of all hinges, and for what `more` makes of how the links move;
/// inertias may be redistributed before.
fn solve<S: Scalar, R>(
    context: &EvalContext<S>,
    (method, axes, to_parents): (SolutionMethod, Axes, bool),
    trace: &mut Trace<S>,
    more: impl FnOnce(&MotionProblem<S>, &MotionSolution<S>, &mut Trace<S>) -> R,
) -> (ForwardDynamics<S>, R) {
    let mut links = kinematics(context, axes, trace);
    let closing = closing(context, axes, &links);
    let given = to_parents.then(|| redistribute(context, &mut links, trace));
    let problem = MotionProblem { given, ..forces(context, &links, closing.as_ref(), trace) };
    let (movement, pivots) = match method {
        SolutionMethod::Riccati => riccati::solve(&problem, trace),
        SolutionMethod::Transfer => {
            let (pivots, closure, relations) = riccati::reduced(&problem, trace);
            // By the sum over all bodies beyond a hinge, rounding would grow with the square of
            // their number.
            (MotionSolution { relations, ..transfer::solve(&problem, closure, trace) }, pivots)
        }
    };
    let layout = context.layout;
    let mut accelerations = movement.rates(&links, layout);
    if let Some(demand) = &problem.closing {
        let a = reached(demand.closing, problem.ground, &movement);
        let a_child = child(demand.closing, &links, &problem);
        let relative = a_child - a;
        let range = layout.v[demand.closing.hinge.id].clone();
        let rates = demand.closing.rates(relative);
        if !range.is_empty() {
            accelerations[range].copy_from_slice(&rates);
        }
    }
    let reaction =
        problem.closing.as_ref().map(|demand| reaction(context, demand, &links, &movement));
    let more = more(&problem, &movement, trace);
    (ForwardDynamics { accelerations, pivots, reaction }, more)
}

/// Newton's and Euler's laws as a problem: forces, efforts and velocities.
fn forces<'a, S: Scalar>(
    context: &EvalContext<'a, S>,
    links: &'a PerLink<LinkKinematics<S>>,
    closing: Option<&'a LoopHinge<S>>,
    trace: &mut Trace<S>,
) -> MotionProblem<'a, S> {
    let outer = loads(context, links);
    let own = |(link, outer): (&LinkKinematics<S>, Wrench<S>)| {
        let name = &link.name;
        let source = "[P, Eqs. (14), (15), (20)]";
        trace.section(format!("{name}_loads"), format!("Loads on `{name}`"), source);
        trace.wrench(&format!("{name}_velocity_load"), link.velocity_wrench());
        trace.wrench(&format!("{name}_load"), outer);
        link.velocity_wrench() - outer
    };
    let loads = links.iter().zip(outer).map(own).collect();
    let mut problem = MotionProblem {
        links,
        dimension: context.chain.dimension,
        tree: context.tree,
        drift: links.iter().map(|link| link.hinge.bias_acceleration).collect(),
        loads,
        efforts: links.iter().map(|link| link.hinge.basis.to_basis(&link.hinge.efforts)).collect(),
        ground: context.base_acceleration(),
        closing: None,
        given: None,
        added: None,
    };
    problem.closing = closing.map(|closing| {
        let drift =
            closing.hinge.acceleration_from_parent(Motion::zero(), closing.hinge.bias_acceleration);
        let a = child(closing, links, &problem) - drift;
        let efforts = &closing.hinge.efforts;
        let reached = closing.held.iter().map(|held| a.power(held.wrench));
        let linkage = context.constraint_rank(closing.held.len());
        LoopConstraints {
            closing,
            reached: reached.collect(),
            given: closing.given(efforts),
            linkage,
        }
    });
    if context.held_by_closure { problem.with_added_inertia() } else { problem }
}

/// The acceleration that the outboard side of the closing hinge has of itself.
fn child<S: Scalar>(
    closing: &LoopHinge<S>,
    links: &PerLink<LinkKinematics<S>>,
    problem: &MotionProblem<S>,
) -> Motion<S> {
    let own = match closing.child {
        None => problem.ground,
        // A moving end hangs on the ground, its motion prescribed.
        Some(link) => problem.motion_from_parent(link, problem.ground),
    };
    closing.of_child(own) + closing.child_drift(links)
}

/// The acceleration at the closing hinge that comes over from its inboard side, with what joins on
/// the way.
fn reached<S: Scalar>(
    closing: &LoopHinge<S>,
    ground: Motion<S>,
    movement: &MotionSolution<S>,
) -> Motion<S> {
    let parent = closing.parent.map_or(ground, |link| movement.points[link]);
    closing.hinge.acceleration_from_parent(parent, closing.hinge.bias_acceleration)
}

fn reaction<S: Scalar>(
    context: &EvalContext<S>,
    demand: &LoopConstraints<S>,
    links: &PerLink<LinkKinematics<S>>,
    movement: &MotionSolution<S>,
) -> LoopReaction<S> {
    let closing = demand.closing;
    let part_to_work = closing.parent.map_or(Mat3::identity(), |link| links[link].part_to_work);
    let hinge = &context.chain.hinges[closing.hinge.id];
    let (_, _, rotation) = context.place(&hinge.inboard);
    let to_hinge = Rotation::from_matrix(part_to_work * rotation);
    let of = |wrench: Wrench<S>| wrench.rotated(&closing.hinge.to_parent).rotated_back(&to_hinge);
    let along = |amounts: &Vec<S>| of(closing.wrench(Wrench::zero(), amounts));
    let ConstraintForces { reactions, undetermined, pivots, .. } = &movement.closure;
    LoopReaction {
        wrench: of(closing.wrench(demand.given, reactions)),
        undetermined: undetermined.iter().map(along).collect(),
        pivots: pivots.clone(),
    }
}
