//! The full report on a chain, once its accelerations are known: pose, velocity and state vector
//! `z` at every connection point of the bodies as written.
//!
//! Poses are in the inertial frame. Other vectors stay in the axes of links, where the sweeps
//! compute them. They are rotated to inertial axes when they are read.

use super::connection_points::{ConnectionPoint, connection_points};
use super::hinge_wrenches::WrenchSum;
use super::kinematics::{HingeKinematics, LinkKinematics, Pose, link_of, poses};
use super::loads::loads;
use super::loop_hinge::{LoopHinge, loop_hinge};
use super::sweep::{Flatten, PerLink};
use super::{EvalContext, ForwardDynamics, OutboardState, SweepResult, Trace, kinematics};
use crate::ids::IdVec;
use crate::math::{Mat3, Motion, Rotation, Scalar, Vec3, Wrench};
use crate::model::{Dimension, HingeId, LinkId};

/// A vector with the axes of its components.
#[derive(Clone, Copy, Debug)]
pub struct FramedVector<S> {
    /// Rotation from these axes to inertial axes.
    pub axes: Mat3<S>,
    /// The components.
    pub vector: Vec3<S>,
}

impl<S: Scalar> FramedVector<S> {
    /// Returns the components in inertial axes.
    pub fn inertial(&self) -> Vec3<S> {
        self.axes * self.vector
    }
}

/// The state at a connection point.
#[derive(Clone, Copy, Debug)]
pub struct PointState<S> {
    /// Its position in m, inertial frame.
    pub position: Vec3<S>,
    /// Rotation from the axes of its frame to inertial axes.
    pub rotation: Mat3<S>,
    /// Its velocity in m/s.
    pub velocity: FramedVector<S>,
    /// The angular velocity `Ω` of its frame in rad/s.
    pub omega: FramedVector<S>,
    /// Its proper acceleration in m/s²: `r̈` minus gravity.
    pub proper_acceleration: FramedVector<S>,
    /// The angular acceleration `Ω̇` in rad/s².
    pub angular_acceleration: FramedVector<S>,
    /// The internal moment `m` in N m, with the signs of [P, Sect. 2.1].
    pub moment: FramedVector<S>,
    /// The internal force `q` in N.
    pub force: FramedVector<S>,
}

/// The results other than the accelerations of the free rates.
#[derive(Clone, Debug)]
pub struct Report<S> {
    /// All connection points in route order: the input of the first element, then the outputs of
    /// all elements. There is one point more than elements.
    pub points: Vec<PointState<S>>,
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
    let points: Vec<PointState<S>> =
        connection_points(context).iter().map(|at| reader.point(at)).collect();
    trace.section("points", "Connection points", "[P, Eqs. (4), (12), (13)]");
    for (number, point) in points.iter().enumerate() {
        trace.vector(&format!("point{number}_velocity"), point.velocity.vector);
        trace.vector(&format!("point{number}_proper_acc"), point.proper_acceleration.vector);
        trace.vector(&format!("point{number}_position"), point.position);
        trace.matrix(&format!("point{number}_rotation"), point.rotation);
    }
    Report {
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

/// A hinge with the wrench in it.
struct HingeWrench<S> {
    hinge: HingeKinematics<S>,
    /// The link whose work axes the first two wrenches are in; `None` for inertial axes.
    axes: Option<LinkId>,
    /// Exerted by the inboard side on the outboard side, about the origin of the outboard side.
    at_outboard: Wrench<S>,
    /// Exerted by the inboard side on the outboard side, about the origin of the inboard side.
    at_inboard: Wrench<S>,
    /// Exerted on the child, about its point, in the hinge's work axes.
    on_child: Wrench<S>,
    /// The outboard link, if both sides of the hinge are one point that is also the link's point.
    concentric_link: Option<LinkId>,
}

impl<S: Scalar> HingeWrench<S> {
    /// Returns the wrench in a link's hinge. At the boundary of a repeated part, the axes inboard
    /// of the hinge are used, since those outboard of it belong to another repetition.
    fn across(
        context: &EvalContext<S>,
        index: LinkId,
        link: &LinkKinematics<S>,
        on_child: Wrench<S>,
    ) -> Self {
        let (layout, hinge) = (&context.layout.links[index], link.hinge.clone());
        let (axes, at_child, offset) = match layout.boundary {
            Some(_) => (link.parent, on_child.rotated(&hinge.to_parent), hinge.offset),
            None => (Some(index), on_child, hinge.to_parent.rotate_back(hinge.offset)),
        };
        let at_parent = at_child.shifted_from(offset);
        let (at_outboard, at_inboard) = if layout.reversed {
            (at_parent.reversed(), at_child.reversed())
        } else {
            (at_child, at_parent)
        };
        let concentric_link = (layout.boundary.is_none() && hinge.is_concentric()).then_some(index);
        HingeWrench { hinge, axes, at_outboard, at_inboard, on_child, concentric_link }
    }

    /// Returns the wrench in the loop hinge, from the wrench on its outboard side in its parent's
    /// axes.
    fn loop_hinge(loop_hinge: &LoopHinge<S>, wrench: Wrench<S>) -> Self {
        let hinge = loop_hinge.hinge.clone();
        let at_inboard = wrench.shifted_from(hinge.offset);
        let on_child = wrench.rotated_back(&hinge.to_parent);
        HingeWrench {
            hinge,
            axes: loop_hinge.parent,
            at_outboard: wrench,
            at_inboard,
            on_child,
            concentric_link: None,
        }
    }
}

/// Returns the efforts along all rates. For a prescribed motion the effort is `Sᵀ F`, plus the
/// effort of rotors, minus the efforts of passive elements.
fn hinge_efforts<S: Scalar>(
    context: &EvalContext<S>,
    hinges: &IdVec<HingeId, Option<HingeWrench<S>>>,
    accelerations: &[S],
) -> Vec<S> {
    let efforts = |(index, hinge_wrench): (HingeId, &Option<HingeWrench<S>>)| {
        let (true, Some(HingeWrench { hinge, on_child, .. })) =
            (context.chain.hinges[index].is_prescribed(), hinge_wrench)
        else {
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

/// The data that the states of connection points are read from.
struct PointReader<'a, S> {
    context: &'a EvalContext<'a, S>,
    links: &'a PerLink<LinkKinematics<S>>,
    poses: &'a PerLink<Pose<S>>,
    proper_acceleration: &'a PerLink<Motion<S>>,
    hinges: &'a IdVec<HingeId, Option<HingeWrench<S>>>,
}

impl<S: Scalar> PointReader<'_, S> {
    fn point(&self, at: &ConnectionPoint) -> PointState<S> {
        let (part, origin, rotation) = self.context.frame_of(&at.attachment);
        let (force, moment) = self.force_and_moment(at);
        let Some(index) = link_of(part) else {
            let none = self.framed(None, Vec3::zero());
            return PointState {
                position: origin,
                rotation,
                velocity: none,
                omega: none,
                proper_acceleration: self.framed(None, self.context.base_acceleration().linear),
                angular_acceleration: none,
                moment,
                force,
            };
        };
        let (link, pose) = (&self.links[index], &self.poses[index]);
        let arm = link.part_to_work * (origin - link.point);
        let (velocity, proper_acceleration) = self.velocity_and_acceleration(at, index, arm);
        PointState {
            position: pose.position + pose.to_inertial * arm,
            rotation: pose.to_inertial * (link.part_to_work * rotation),
            velocity,
            omega: self.framed(Some(index), link.omega),
            proper_acceleration,
            angular_acceleration: self.framed(Some(index), self.proper_acceleration[index].angular),
            moment,
            force,
        }
    }

    /// Returns velocity and proper acceleration of a point on a link. If the point of another link
    /// coincides with it, the known values of that link are returned.
    fn velocity_and_acceleration(
        &self,
        at: &ConnectionPoint,
        index: LinkId,
        arm: Vec3<S>,
    ) -> (FramedVector<S>, FramedVector<S>) {
        let concentric_link =
            at.hinge.and_then(|(hinge, _)| self.hinges[hinge].as_ref()?.concentric_link);
        if let Some(other) = concentric_link {
            let (velocity, proper_acceleration) =
                (self.poses[other].velocity, self.proper_acceleration[other].linear);
            return (
                self.framed(Some(other), velocity),
                self.framed(Some(other), proper_acceleration),
            );
        }
        let (link, pose) = (&self.links[index], &self.poses[index]);
        let velocity = pose.velocity + link.omega.cross(arm);
        let proper_acceleration = self.proper_acceleration[index].shifted_to(arm).linear
            + arm.centripetal_by_products(link.omega);
        (self.framed(Some(index), velocity), self.framed(Some(index), proper_acceleration))
    }

    /// Returns `q` and `m` at a point: on a body `+q` and `−m` at its input, `−q` and `+m` at its
    /// output.
    fn force_and_moment(&self, at: &ConnectionPoint) -> (FramedVector<S>, FramedVector<S>) {
        let through = |(index, outboard): (HingeId, bool)| {
            let Some(hinge) = &self.hinges[index] else { bug!("a hinge transmits nothing") };
            (hinge.axes, if outboard { hinge.at_outboard } else { hinge.at_inboard })
        };
        let at_free_end = (None, Wrench::zero());
        let (axes, wrench) = at.hinge.map_or(at_free_end, through);
        (self.framed(axes, wrench.force), self.framed(axes, -wrench.moment))
    }

    /// Returns a vector in the work axes of a link or in inertial axes. In a plane or on a line it
    /// is in the axes of the part's frame, since work axes may be perpendicular to these.
    fn framed(&self, link: Option<LinkId>, vector: Vec3<S>) -> FramedVector<S> {
        let Some(index) = link else { return FramedVector { axes: Mat3::identity(), vector } };
        let (axes, part_to_work) = (self.poses[index].to_inertial, self.links[index].part_to_work);
        match self.context.chain.dimension {
            Dimension::Space => FramedVector { axes, vector },
            Dimension::Plane | Dimension::Line => FramedVector {
                axes: axes * part_to_work,
                vector: part_to_work.transposed() * vector,
            },
        }
    }
}
