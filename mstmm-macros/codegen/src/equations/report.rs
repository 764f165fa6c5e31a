//! The full report on a chain, once its accelerations are known: pose, velocity and state vector
//! `z` at every connection point of the bodies as written.
//!
//! Poses are in the inertial frame. Other vectors stay in the axes of links, where the sweeps
//! compute them. They are rotated to inertial axes when they are read.

use super::hinge_wrenches::WrenchSum;
use super::kinematics::{LinkKinematics, Pose, poses};
use super::loads::loads;
use super::loop_hinge::{LoopHinge, loop_hinge};
use super::point_reader::{HingeWrench, PointReader, PointState};
use super::sweep::{Flatten, PerLink};
use super::{EvalContext, ForwardDynamics, OutboardState, SweepResult, Trace, kinematics};
use crate::ids::{IdVec, PointId};
use crate::math::{Mat3, Motion, Rotation, Scalar, Vec3, Wrench};
use crate::model::{ConnectionPoints, HingeId, LinkId};

/// The results other than the accelerations of the free rates.
#[derive(Clone, Debug)]
pub struct Report<S> {
    /// The connection points of the chain.
    pub connection_points: ConnectionPoints,
    /// The states of all connection points.
    pub points: IdVec<PointId, PointState<S>>,
    /// The proper acceleration of a point at rest, inertial frame: to be subtracted from that of
    /// other points.
    pub base_acceleration: Vec3<S>,
    /// Accelerations of all hinges' rates, including prescribed ones.
    pub accelerations: Vec<S>,
    /// Efforts along all rates: actuator efforts, and the efforts that prescribed motions require.
    pub efforts: Vec<S>,
}

/// Returns the report. The context has a link for every body; `solved` and `swept` come from a
/// context with welded bodies merged.
pub fn report<S: Scalar>(
    context: &EvalContext<S>,
    (solved, swept): (&ForwardDynamics<S>, &SweepResult<S>),
    trace: &mut Trace<S>,
) -> Report<S> {
    let links = kinematics(context, swept.axes, trace);
    let poses = poses(context, &links);
    links.iter().zip(&poses).for_each(|(link, pose)| record(&link.hinge.name, pose, trace));
    let proper_acceleration = proper_accelerations(context, &links, swept);
    let loop_hinge = loop_hinge(context, swept.axes, &links);
    let closed = loop_hinge.as_ref().zip(solved.reaction.as_ref()).map(|(loop_hinge, reaction)| {
        let part_to_work =
            loop_hinge.parent.map_or(Mat3::identity(), |link| links[link].part_to_work);
        let (_, _, rotation) = context.frame_of(&context.chain.hinges[loop_hinge.hinge.id].inboard);
        (loop_hinge, reaction.wrench.rotated(&Rotation::from_matrix(part_to_work * rotation)))
    });
    let wrenches = wrenches(context, &links, &proper_acceleration, swept, closed);
    let mut hinges: IdVec<HingeId, Option<HingeWrench<S>>> =
        context.chain.hinges.iter().map(|_| None).collect();
    links.enumerate().for_each(|(index, link)| {
        let hinge = HingeWrench::across(context, index, link, wrenches[index]);
        hinges[link.hinge.id] = Some(hinge);
    });
    if let Some((loop_hinge, wrench)) = closed {
        hinges[loop_hinge.hinge.id] = Some(HingeWrench::loop_hinge(loop_hinge, wrench));
    }
    let accelerations = rate_accelerations(context, &solved.accelerations);
    let reader = PointReader {
        context,
        links: &links,
        poses: &poses,
        proper_acceleration: &proper_acceleration,
        hinges: &hinges,
    };
    let connection_points = context.chain.connection_points();
    let points: IdVec<PointId, PointState<S>> =
        connection_points.points.iter().map(|at| reader.point(at)).collect();
    trace.section("points", "Connection points", "[P, Eqs. (4), (12), (13)]");
    for (number, point) in points.iter().enumerate() {
        trace.vector(&format!("point{number}_velocity"), point.velocity.vector);
        trace.vector(&format!("point{number}_proper_acc"), point.proper_acceleration.vector);
        trace.vector(&format!("point{number}_position"), point.position);
        trace.matrix(&format!("point{number}_rotation"), point.rotation);
    }
    Report {
        connection_points,
        points,
        base_acceleration: context.base_acceleration().linear,
        efforts: hinge_efforts(context, &hinges, &accelerations),
        accelerations,
    }
}

fn record<S: Scalar>(name: &str, pose: &Pose<S>, trace: &mut Trace<S>) {
    trace.section(format!("{name}_pose"), format!("Pose outboard of `{name}`"), "[P, Eq. (12)]");
    trace.vector(&format!("{name}_position"), pose.position);
    trace.matrix(&format!("{name}_to_inertial"), pose.to_inertial);
    trace.section(format!("{name}_velocity"), format!("Velocity outboard of `{name}`"), "");
    trace.vector(&format!("{name}_velocity"), pose.velocity);
}

/// Returns the accelerations of all rates, in the layout's order of all rates.
fn rate_accelerations<S: Scalar>(context: &EvalContext<S>, free: &[S]) -> Vec<S> {
    let accelerations = |hinge: HingeId| match context.prescribed_accelerations(hinge) {
        Some(given) => given.to_vec(),
        None => free[context.layout.v[hinge].clone()].to_vec(),
    };
    context.chain.hinges.ids().into_iter().flat_map(accelerations).collect()
}

/// Returns the proper accelerations of all links' points. For a body that was merged into another
/// they follow from the other body.
fn proper_accelerations<S: Scalar>(
    context: &EvalContext<S>,
    links: &PerLink<LinkKinematics<S>>,
    swept: &SweepResult<S>,
) -> PerLink<Motion<S>> {
    let (accelerations, _) = context.tree.outward(
        ProperAcceleration(context.base_acceleration()),
        |link, &ProperAcceleration(parent)| {
            let hinge = &links[link].hinge;
            let proper_acceleration = match swept.outboard[hinge.id] {
                Some(OutboardState { proper_acceleration, .. }) => proper_acceleration,
                None => hinge.acceleration_from_parent(parent, hinge.bias_acceleration),
            };
            (ProperAcceleration(proper_acceleration), ())
        },
    );
    accelerations
        .into_iter()
        .map(|ProperAcceleration(proper_acceleration)| proper_acceleration)
        .collect()
}

/// The proper acceleration of a link's point. It crosses no boundary, since the sweeps compute it
/// on both sides.
#[derive(Clone, Copy)]
struct ProperAcceleration<S>(Motion<S>);

impl<S: Scalar> Flatten<S> for ProperAcceleration<S> {
    fn visit(self, _: &mut dyn FnMut(S) -> S) -> Self {
        self
    }
}

/// Returns the wrench that every link's hinge exerts on the link, about its point [P, Eqs. (18),
/// (19)]. In a weld between merged bodies it is the sum over everything outboard of it.
fn wrenches<S: Scalar>(
    context: &EvalContext<S>,
    links: &PerLink<LinkKinematics<S>>,
    proper_acceleration: &PerLink<Motion<S>>,
    swept: &SweepResult<S>,
    closed: Option<(&LoopHinge<S>, Wrench<S>)>,
) -> PerLink<Wrench<S>> {
    let known =
        |link: &LinkKinematics<S>| swept.outboard[link.hinge.id].map(|outboard| outboard.wrench);
    let external = if links.iter().all(|link| known(link).is_some()) {
        PerLink::new()
    } else {
        loads(context, links)
    };
    let own_sum = |(index, link): (LinkId, &LinkKinematics<S>)| match known(link) {
        Some(_) => WrenchSum(None),
        None => {
            let wrench = link.spatial_inertia().times(proper_acceleration[index])
                + link.velocity_wrench()
                - external[index];
            WrenchSum(Some(wrench))
        }
    };
    let mut sums: PerLink<WrenchSum<S>> = links.enumerate().map(own_sum).collect();
    if let Some((loop_hinge, wrench)) = closed {
        if let Some(parent) = loop_hinge.parent {
            sums[parent].add(|| wrench.shifted_from(loop_hinge.hinge.arm));
        }
        let outboard = wrench.rotated_back(&loop_hinge.hinge.to_parent);
        if let Some((child, on_child)) = loop_hinge.wrench_on_child(outboard) {
            sums[child].add(|| on_child.reversed());
        }
    }
    let step = |link: LinkId, WrenchSum(sum): WrenchSum<S>, parent: &mut WrenchSum<S>| {
        let Some(wrench) = sum.or_else(|| known(&links[link])) else {
            bug!("the wrench in a hinge is neither a sum nor known")
        };
        parent.add(|| links[link].hinge.wrench_to_parent(wrench));
        wrench
    };
    context.tree.inward(sums, WrenchSum(None), step).0
}

/// Returns the efforts along all rates. For a prescribed motion and for given accelerations the effort is `Sᵀ F`, plus the
/// effort of rotors, minus the efforts of passive elements.
fn hinge_efforts<S: Scalar>(
    context: &EvalContext<S>,
    hinges: &IdVec<HingeId, Option<HingeWrench<S>>>,
    accelerations: &[S],
) -> Vec<S> {
    let efforts = |(index, hinge_wrench): (HingeId, &Option<HingeWrench<S>>)| {
        let is_known =
            context.chain.hinges[index].is_prescribed() || context.accelerations.is_some();
        let (true, Some(HingeWrench { hinge, on_child, .. })) = (is_known, hinge_wrench) else {
            return context.actuator_efforts(index);
        };
        let accelerations = &accelerations[context.layout.rates[index].clone()];
        let rotors = hinge.passives.rotor_efforts(accelerations);
        let required = hinge.subspace.iter().map(|s| s.power(*on_child));
        let less = rotors.iter().zip(&hinge.passives.efforts);
        required
            .zip(less)
            .map(|(required, (&rotor, &passive))| required + rotor - passive)
            .collect()
    };
    hinges.enumerate().flat_map(efforts).collect()
}
