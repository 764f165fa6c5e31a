//! Projection of a closed chain onto its loop constraints, for coordinates and for rates. Of all
//! motions that close the loop hinge, it takes the one of least kinetic energy.
//!
//! An impulse at the loop hinge causes this motion. The equations are therefore those of forward
//! dynamics without velocities, efforts and loads; `a` are changes of coordinates, or of rates.
//! Position error and velocity error belong to the loop hinge, in its axes on the inboard side.
//! Redundant constraints cannot all be fulfilled at once by a chain that is open; the sum of the
//! squares of their errors is least, with rotations as translations at an arm of the chain's size.

use super::hinge::{coordinate_rates, dot, normalized};
use super::kinematics::{BiasAcceleration, LinkKinematics, Pose, poses};
use super::loop_hinge::{LoopHinge, loop_hinge};
use super::motion_problem::{LoopConstraints, MotionProblem, MotionSolution};
use super::sweep::{Flatten, PerLink};
use super::tangent::{Direction, Tangent};
use super::{Axes, EvalContext, Trace, kinematics, riccati};
use crate::ids::LinkId;
use crate::math::{Mat3, Motion, Rotation, Scalar, Vec3, Wrench};
use crate::model::{Chain, Hinge, HingeId, InputKind, Layout};

/// The projection of a state onto the loop constraints.
#[derive(Clone, Debug)]
pub struct Projection<S> {
    /// The displacement along the rates that the coordinates need.
    pub coordinates: Vec<S>,
    /// The change of the rates.
    pub rates: Vec<S>,
    /// The norm of position error and velocity error, in m, rad, m/s and rad/s.
    pub residual: S,
    /// The same norm without units: lengths relative to the chain's size, velocities also to those of its hinges.
    pub relative: S,
    /// The largest relative pivot among the constraints that count as redundant, from zero to one.
    /// Away from the loop constraints it is about the square of the distance from them.
    pub excess: S,
}

/// Returns the projection, or `None` for a chain that is not closed.
pub fn project<S: Scalar>(context: &EvalContext<S>, trace: &mut Trace<S>) -> Option<Projection<S>> {
    let inputs = with_unit_quaternions(context);
    let context = &context.clone().with_inputs(&inputs);
    let links = kinematics(context, Axes::Body, trace);
    let loop_hinge = loop_hinge(context, Axes::Body, &links)?;
    let poses = poses(context, &links);
    let position_error = position_error(context, &links, &loop_hinge, &poses);
    let velocity_error = velocity_error(&links, &loop_hinge, &poses);
    let square = |motion: Motion<S>| {
        let axes = context.chain.dimension.axes();
        let entries: Vec<S> = axes.iter().map(|&k| motion.at(k)).collect();
        dot(&entries, &entries)
    };
    let per_length = square_size(context, &links, Some(&loop_hinge)).sqrt().recip();
    let relative = |Motion { linear, angular }: Motion<S>| {
        square(Motion { linear: linear * per_length, angular })
    };
    let speed = context.tree.total(relative(loop_hinge.hinge.relative_velocity), |link, sum| {
        sum + relative(links[link].hinge.relative_velocity)
    });
    let closing = loop_hinge.with_constraints_of_one_unit(per_length);
    let (coordinates, excess) =
        minimal_motion(context, &links, &closing, position_error.motion, trace);
    let (rates, _) = minimal_motion(context, &links, &closing, velocity_error, trace);
    let half_turn = position_error.half_turn_error();
    // Rates below one rad/s have absolute errors.
    let of_velocity = relative(velocity_error) * (S::one() + speed).recip();
    Some(Projection {
        coordinates,
        rates,
        excess,
        residual: (square(position_error.motion) + half_turn + square(velocity_error)).sqrt(),
        relative: (relative(position_error.motion) + half_turn + of_velocity).sqrt(),
    })
}

/// Returns the size of a chain in m, which lengths are compared with.
pub fn size<S: Scalar>(context: &EvalContext<S>) -> S {
    let links = kinematics(context, Axes::Body, &mut Trace::silent());
    let loop_hinge = loop_hinge(context, Axes::Body, &links);
    square_size(context, &links, loop_hinge.as_ref()).sqrt()
}

/// Returns the square of the size of a chain: of all arms, and of the radius of gyration of all masses about the points of
/// their links. Without inertias, where a chain of sliders may have no arms either, one metre is added.
fn square_size<S: Scalar>(
    context: &EvalContext<S>,
    links: &PerLink<LinkKinematics<S>>,
    loop_hinge: Option<&LoopHinge<S>>,
) -> S {
    let nothing = Sizes { arms: S::zero(), mass: S::zero(), inertia: S::zero() };
    let all = context.tree.total(nothing, |index, sum| {
        let link = &links[index];
        Sizes {
            arms: sum.arms + link.hinge.arm.dot(link.hinge.arm),
            mass: sum.mass + link.mass,
            inertia: sum.inertia + link.inertia.trace(),
        }
    });
    let closing = loop_hinge.map_or(Vec3::zero(), |loop_hinge| loop_hinge.hinge.arm);
    let own = match all.inertia.vanishes() {
        true => S::one(),
        false => all.inertia * all.mass.recip(),
    };
    all.arms + closing.dot(closing) + own
}

/// Sums over links.
#[derive(Clone, Copy)]
struct Sizes<S> {
    /// Of the squares of the arms.
    arms: S,
    /// Of the masses.
    mass: S,
    /// Of the traces of the inertias.
    inertia: S,
}

impl<S: Scalar> Flatten<S> for Sizes<S> {
    fn visit(self, replace: &mut dyn FnMut(S) -> S) -> Self {
        Sizes { arms: replace(self.arms), mass: replace(self.mass), inertia: replace(self.inertia) }
    }
}

/// Returns the inputs with quaternions of prescribed motions normalised. A matrix of a quaternion of another length is no
/// rotation, so that the loop hinge could not be closed.
fn with_unit_quaternions<S: Scalar>(context: &EvalContext<S>) -> Vec<S> {
    let mut inputs = context.inputs.to_vec();
    for (id, hinge) in context.chain.hinges.enumerate().filter(|(_, hinge)| hinge.is_prescribed()) {
        let unit = normalized(&hinge.kind, context.coordinates(id));
        let first = context.layout.input(InputKind::Motion(id)).start;
        inputs[first..first + unit.len()].copy_from_slice(&unit);
    }
    inputs
}

/// Returns the velocity across the open loop hinge at rates `x`, linear and angular, in the axes of its outboard
/// frame: the product of the constraint Jacobian `G` of a closed chain with a vector. Rates that keep the
/// chain closed have `G x = 0`, if moving ends and prescribed motions rest.
pub fn closure_jacobian_times<S: Scalar>(context: &EvalContext<S>, x: &[S]) -> Option<Motion<S>> {
    let direction = Direction {
        coordinates: Vec::new(),
        rates: x.to_vec(),
        accelerations: Vec::new(),
        inputs: Vec::new(),
        parameters: Vec::new(),
    };
    let tangent = Tangent::new(context, &direction);
    let along = tangent.context(context);
    let links = kinematics(&along, Axes::Body, &mut Trace::silent());
    let loop_hinge = loop_hinge(&along, Axes::Body, &links)?;
    let error = velocity_error(&links, &loop_hinge, &poses(&along, &links));
    let alignment = along.chain.hinges[loop_hinge.hinge.id].kind.law().alignment(along.values);
    let to_outboard = alignment * loop_hinge.hinge.child_to_work.matrix().transposed();
    let [linear, angular] = [error.linear, error.angular].map(|vector| {
        let outboard = to_outboard * vector;
        Vec3(outboard.0.map(|entry| -entry.derivative()))
    });
    Some(Motion { linear, angular })
}

/// Returns coordinates displaced along the rates, with quaternions normalised.
pub fn displace<S: Scalar>(chain: &Chain, layout: &Layout, q: &[S], rates: &[S]) -> Vec<S> {
    let displaced = |(index, hinge): (HingeId, &Hinge)| {
        if hinge.is_prescribed() {
            return Vec::new();
        }
        let (q, rates) = (&q[layout.q[index].clone()], &rates[layout.v[index].clone()]);
        let change = coordinate_rates(&hinge.kind, q, rates);
        let moved: Vec<S> = q.iter().zip(change).map(|(&q, change)| q + change).collect();
        normalized(&hinge.kind, &moved)
    };
    chain.hinges.enumerate().flat_map(displaced).collect()
}

/// Returns the displacement from the inboard side of the loop hinge to its outboard side.
fn position_error<S: Scalar>(
    context: &EvalContext<S>,
    links: &PerLink<LinkKinematics<S>>,
    loop_hinge: &LoopHinge<S>,
    poses: &PerLink<Pose<S>>,
) -> PositionError<S> {
    let hinge = &context.chain.hinges[loop_hinge.hinge.id];
    let (_, origin, rotation) = context.frame_of(&hinge.outboard);
    let aligned_subspace = rotation * hinge.kind.law().alignment(context.values);
    let from = pose_of(loop_hinge.parent, poses);
    let reached = from.position + from.to_inertial * loop_hinge.hinge.arm;
    let axes = Rotation::from_matrix(from.to_inertial * loop_hinge.hinge.to_parent.matrix());
    let to = pose_of(loop_hinge.child, poses);
    let (part_to_work, point) = match loop_hinge.child {
        None => (Mat3::identity(), Vec3::zero()),
        Some(link) => (links[link].part_to_work, links[link].point),
    };
    let wanted = to.position + to.to_inertial * (part_to_work * (origin - point));
    let rotation_error =
        axes.matrix().transposed() * (to.to_inertial * (part_to_work * aligned_subspace));
    PositionError {
        motion: Motion {
            linear: axes.rotate_back(wanted - reached),
            angular: rotation_error.rotation_vector(),
        },
        rotation: rotation_error,
    }
}

/// The position error of the loop hinge.
struct PositionError<S> {
    /// Translation and rotation vector from the inboard to the outboard side, in the hinge's
    /// inboard axes.
    motion: Motion<S>,
    /// The rotation matrix of the same rotation.
    rotation: Mat3<S>,
}

impl<S: Scalar> PositionError<S> {
    /// Returns the error that the rotation vector does not show: a rotation by half a turn has no
    /// unique axis, but its cosine is known.
    fn half_turn_error(&self) -> S {
        let versine = S::one() - self.rotation.angle_cosine();
        versine * versine
    }
}

/// Returns the velocity of the outboard side of the loop hinge relative to its inboard side, in its
/// axes.
fn velocity_error<S: Scalar>(
    links: &PerLink<LinkKinematics<S>>,
    loop_hinge: &LoopHinge<S>,
    poses: &PerLink<Pose<S>>,
) -> Motion<S> {
    let velocity = |link: Option<LinkId>| match link {
        None => Motion::zero(),
        Some(link) => Motion { linear: poses[link].velocity, angular: links[link].omega },
    };
    let arriving = loop_hinge.hinge.motion_from_parent(velocity(loop_hinge.parent))
        + loop_hinge.hinge.relative_velocity;
    loop_hinge.motion_from_child(velocity(loop_hinge.child)) - arriving
}

fn pose_of<S: Scalar>(link: Option<LinkId>, poses: &PerLink<Pose<S>>) -> Pose<S> {
    link.map_or(Pose::ground(), |link| poses[link])
}

/// Returns the motion of all hinges that moves the loop hinge by `wanted`, and the excess of the
/// redundant constraints.
fn minimal_motion<S: Scalar>(
    context: &EvalContext<S>,
    links: &PerLink<LinkKinematics<S>>,
    loop_hinge: &LoopHinge<S>,
    wanted: Motion<S>,
    trace: &mut Trace<S>,
) -> (Vec<S>, S) {
    let problem = MotionProblem {
        links,
        dimension: context.chain.dimension,
        tree: context.tree,
        bias_accelerations: links.iter().map(|_| BiasAcceleration::zero()).collect(),
        bias_forces: links.iter().map(|_| Wrench::zero()).collect(),
        efforts: links.iter().map(|link| vec![S::zero(); link.hinge.basis.columns.len()]).collect(),
        base_acceleration: Motion::zero(),
        loop_constraints: Some(LoopConstraints {
            loop_hinge,
            targets: loop_hinge
                .constraints
                .iter()
                .map(|constraint| wanted.power(constraint.wrench))
                .collect(),
            applied: Wrench::zero(),
            rank: context.constraint_rank(loop_hinge.constraints.len()),
        }),
        original_inertias: None,
        added_inertia: None,
    };
    let problem = if context.held_by_closure { problem.with_added_inertia() } else { problem };
    let (solution, _) = riccati::solve(&problem, trace);
    let layout = context.layout;
    let mut rates = solution.rates(links, layout);
    let MotionSolution { link_accelerations, constraint_forces, .. } = solution;
    let arriving = loop_hinge.hinge.motion_from_parent(
        loop_hinge.parent.map_or(Motion::zero(), |link| link_accelerations[link]),
    );
    let range = layout.v[loop_hinge.hinge.id].clone();
    if !range.is_empty() {
        rates[range].copy_from_slice(&loop_hinge.rates(wanted - arriving));
    }
    (rates, constraint_forces.excess)
}
