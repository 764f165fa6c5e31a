//! Back onto the closure: the smallest motion, measured by the kinetic energy that it would take,
//! that closes a chain whose closing hinge has drifted apart; for coordinates and for rates.
//!
//! It is the motion that an impulse at the closing hinge makes, so the equations are those of the
//! accelerations without velocities, efforts and loads: `a` are changes of coordinates, or of rates.
//! The gap and how fast it opens are seen at the closing hinge, in its axes as they arrive from its
//! inboard side.

use super::hinge::{coordinate_rates, dot, normalized};
use super::kinematics::{BiasAcceleration, LinkKinematics, Pose, poses};
use super::loop_hinge::{LoopHinge, closing};
use super::motion_problem::{LoopConstraints, MotionProblem, MotionSolution};
use super::sweep::PerLink;
use super::{Axes, EvalContext, Trace, kinematics, riccati};
use crate::ids::LinkId;
use crate::math::{Mat3, Motion, Rotation, Scalar, Vec3, Wrench};
use crate::model::{Chain, Hinge, HingeId, Layout};

/// What brings a chain back onto its closure.
#[derive(Clone, Debug)]
pub struct Projection<S> {
    /// A motion along the rates, to be made by the coordinates.
    pub coordinates: Vec<S>,
    /// What the rates lack.
    pub rates: Vec<S>,
    /// How far the closing hinge's sides are apart, in m and rad, and how fast they part, in m/s
    /// and rad/s: the root of the sum of squares.
    pub residual: S,
    /// How much the directions that count as redundant hold here, from nothing to one. Off the
    /// closure it is about the square of how far.
    pub excess: S,
}

/// The correction; nothing for a chain that is not closed.
pub fn correction<S: Scalar>(
    context: &EvalContext<S>,
    trace: &mut Trace<S>,
) -> Option<Projection<S>> {
    let links = kinematics(context, Axes::Body, trace);
    let closing = closing(context, Axes::Body, &links)?;
    let poses = poses(context, &links);
    let apart = gap(context, &links, &closing, &poses);
    let parting = parting(&links, &closing, &poses);
    let size = |motion: Motion<S>| {
        let axes = context.chain.dimension.axes();
        let entries: Vec<S> = axes.iter().map(|&k| motion.at(k)).collect();
        dot(&entries, &entries)
    };
    let (coordinates, excess) = along(context, &links, &closing, apart.motion, trace);
    let (rates, _) = along(context, &links, &closing, parting, trace);
    Some(Projection {
        coordinates,
        rates,
        excess,
        residual: (size(apart.motion) + apart.half_turn() + size(parting)).sqrt(),
    })
}

/// Coordinates that have been moved along the rates.
pub fn moved<S: Scalar>(chain: &Chain, layout: &Layout, q: &[S], along: &[S]) -> Vec<S> {
    let one = |(index, hinge): (HingeId, &Hinge)| {
        if hinge.is_prescribed() {
            return Vec::new();
        }
        let (q, along) = (&q[layout.q[index].clone()], &along[layout.v[index].clone()]);
        let change = coordinate_rates(&hinge.kind, q, along);
        let moved: Vec<S> = q.iter().zip(change).map(|(&q, change)| q + change).collect();
        normalized(&hinge.kind, &moved)
    };
    chain.hinges.enumerate().flat_map(one).collect()
}

/// From where the closing hinge arrives to where it should: a shift and a turn.
fn gap<S: Scalar>(
    context: &EvalContext<S>,
    links: &PerLink<LinkKinematics<S>>,
    closing: &LoopHinge<S>,
    poses: &PerLink<Pose<S>>,
) -> PositionError<S> {
    let hinge = &context.chain.hinges[closing.hinge.id];
    let (_, origin, rotation) = context.place(&hinge.outboard);
    let aligned_subspace = rotation * hinge.kind.law().alignment(context.numbers);
    let from = pose_of(closing.parent, poses);
    let reached = from.position + from.to_inertial * closing.hinge.arm;
    let axes = Rotation::from_matrix(from.to_inertial * closing.hinge.to_parent.matrix());
    let to = pose_of(closing.child, poses);
    let (part_to_work, point) = match closing.child {
        None => (Mat3::identity(), Vec3::zero()),
        Some(link) => (links[link].part_to_work, links[link].point),
    };
    let wanted = to.position + to.to_inertial * (part_to_work * (origin - point));
    let turn = axes.matrix().transposed() * (to.to_inertial * (part_to_work * aligned_subspace));
    PositionError {
        motion: Motion {
            linear: axes.rotate_back(wanted - reached),
            angular: turn.rotation_vector(),
        },
        turn,
    }
}

/// How far apart the sides of a closing hinge are.
struct PositionError<S> {
    /// From where the hinge arrives to where it should, its axes.
    motion: Motion<S>,
    /// The turn of it.
    turn: Mat3<S>,
}

impl<S: Scalar> PositionError<S> {
    /// What the rotation vector does not show: half a turn has no direction, but a cosine.
    fn half_turn(&self) -> S {
        let versine = S::one() - self.turn.angle_cosine();
        versine * versine
    }
}

/// How the closing hinge's outboard side moves against what arrives there, its axes.
fn parting<S: Scalar>(
    links: &PerLink<LinkKinematics<S>>,
    closing: &LoopHinge<S>,
    poses: &PerLink<Pose<S>>,
) -> Motion<S> {
    let velocity = |link: Option<LinkId>| match link {
        None => Motion::zero(),
        Some(link) => Motion { linear: poses[link].velocity, angular: links[link].omega },
    };
    let arriving = closing.hinge.motion_from_parent(velocity(closing.parent))
        + closing.hinge.relative_velocity;
    closing.of_child(velocity(closing.child)) - arriving
}

fn pose_of<S: Scalar>(link: Option<LinkId>, poses: &PerLink<Pose<S>>) -> Pose<S> {
    link.map_or(Pose::ground(), |link| poses[link])
}

/// The motion of all hinges that moves the closing hinge by `wanted`, and how much redundant
/// directions hold.
fn along<S: Scalar>(
    context: &EvalContext<S>,
    links: &PerLink<LinkKinematics<S>>,
    closing: &LoopHinge<S>,
    wanted: Motion<S>,
    trace: &mut Trace<S>,
) -> (Vec<S>, S) {
    let problem = MotionProblem {
        links,
        dimension: context.chain.dimension,
        tree: context.tree,
        drift: links.iter().map(|_| BiasAcceleration::zero()).collect(),
        loads: links.iter().map(|_| Wrench::zero()).collect(),
        efforts: links.iter().map(|link| vec![S::zero(); link.hinge.basis.columns.len()]).collect(),
        ground: Motion::zero(),
        closing: Some(LoopConstraints {
            closing,
            reached: closing.held.iter().map(|held| wanted.power(held.wrench)).collect(),
            given: Wrench::zero(),
            linkage: context.constraint_rank(closing.held.len()),
        }),
        given: None,
        added: None,
    };
    let problem = if context.held_by_closure { problem.with_added_inertia() } else { problem };
    let (movement, _) = riccati::solve(&problem, trace);
    let layout = context.layout;
    let mut rates = movement.rates(links, layout);
    let MotionSolution { points, closure, .. } = movement;
    let arriving = closing
        .hinge
        .motion_from_parent(closing.parent.map_or(Motion::zero(), |link| points[link]));
    let own = layout.v[closing.hinge.id].clone();
    if !own.is_empty() {
        rates[own].copy_from_slice(&closing.rates(wanted - arriving));
    }
    (rates, closure.excess)
}
