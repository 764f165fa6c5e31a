//! Everything that can be asked of a chain once its accelerations are known: pose, velocity and
//! the state vector `z` at every connection point, of the bodies as written.
//!
//! Poses are inertial. All else stays in the axes of links, where the sweeps have most of it: a
//! turn into inertial axes is made where a number is read.

use super::connection_points::{ConnectionPoint, spots};
use super::hinge_wrenches::WrenchSum;
use super::kinematics::{HingeKinematics, LinkKinematics, Pose, link_of, poses};
use super::loads::loads;
use super::loop_hinge::{LoopHinge, closing};
use super::sweep::{Flatten, PerLink};
use super::{EvalContext, ForwardDynamics, OutboardState, SweepResult, Trace, motion};
use crate::ids::IdVec;
use crate::math::{Mat3, Motion, Rotation, Scalar, Vec3, Wrench};
use crate::model::{Dimension, HingeId, LinkId};

/// A vector, and the axes that its components are seen in.
#[derive(Clone, Copy, Debug)]
pub struct FramedVector<S> {
    /// From those axes to inertial ones.
    pub axes: Mat3<S>,
    /// The components.
    pub vector: Vec3<S>,
}

impl<S: Scalar> FramedVector<S> {
    /// The components in inertial axes.
    pub fn inertial(&self) -> Vec3<S> {
        self.axes * self.vector
    }
}

/// A connection point.
#[derive(Clone, Copy, Debug)]
pub struct PointState<S> {
    /// Its place, inertial frame.
    pub position: Vec3<S>,
    /// Its frame's axes to inertial ones.
    pub rotation: Mat3<S>,
    /// Its velocity.
    pub velocity: FramedVector<S>,
    /// Its frame's angular velocity `Ω`.
    pub omega: FramedVector<S>,
    /// `r̈`, that of free fall the other way among it.
    pub felt: FramedVector<S>,
    /// `Ω̇`
    pub turning: FramedVector<S>,
    /// Internal moment `m`, in the signs of [P, Sect. 2.1].
    pub moment: FramedVector<S>,
    /// Internal force `q`.
    pub force: FramedVector<S>,
}

/// Everything but the accelerations themselves.
#[derive(Clone, Debug)]
pub struct Report<S> {
    /// All connection points in the order written: the first element's input, then every output.
    /// One more than there are elements.
    pub points: Vec<PointState<S>>,
    /// What a point at rest feels: to be taken from what others feel, inertial frame.
    pub at_rest: Vec3<S>,
    /// Accelerations of all hinges' rates, prescribed ones as well.
    pub accelerations: Vec<S>,
    /// What drives every rate: the efforts of motors, and what prescribed motions take.
    pub efforts: Vec<S>,
}

/// The report on a chain with every body a link, from what the sweeps know with welded bodies
/// merged.
pub fn report<S: Scalar>(
    situation: &EvalContext<S>,
    (solved, swept): (&ForwardDynamics<S>, &SweepResult<S>),
    trace: &mut Trace<S>,
) -> Report<S> {
    let links = motion(situation, swept.axes, trace);
    let poses = poses(situation, &links);
    links.iter().zip(&poses).for_each(|(link, pose)| record(&link.over.name, pose, trace));
    let felt = felt(situation, &links, swept);
    let closing = closing(situation, swept.axes, &links);
    let closed = closing.as_ref().zip(solved.reaction.as_ref()).map(|(closing, reaction)| {
        let attitude = closing.parent.map_or(Mat3::identity(), |link| links[link].attitude);
        let (_, _, rotation) = situation.place(&situation.chain.hinges[closing.over.hinge].inboard);
        (closing, reaction.wrench.turned(&Rotation::general(attitude * rotation)))
    });
    let wrenches = wrenches(situation, &links, &felt, swept, closed);
    let mut hinges: IdVec<HingeId, Option<HingeWrench<S>>> =
        situation.chain.hinges.iter().map(|_| None).collect();
    links.enumerate().for_each(|(index, link)| {
        let over = HingeWrench::over(situation, index, link, wrenches[index]);
        hinges[link.over.hinge] = Some(over);
    });
    if let Some((closing, wrench)) = closed {
        hinges[closing.over.hinge] = Some(HingeWrench::closing(closing, wrench));
    }
    let accelerations = rate_accelerations(situation, &solved.accelerations);
    let sheet =
        PointReader { situation, links: &links, poses: &poses, felt: &felt, hinges: &hinges };
    let points: Vec<PointState<S>> =
        spots(situation).iter().map(|spot| sheet.point(spot)).collect();
    trace.section("points", "Connection points", "[P, Eqs. (4), (12), (13)]");
    for (number, point) in points.iter().enumerate() {
        trace.vector(&format!("point{number}_velocity"), point.velocity.vector);
        trace.vector(&format!("point{number}_felt"), point.felt.vector);
        trace.vector(&format!("point{number}_position"), point.position);
        trace.matrix(&format!("point{number}_rotation"), point.rotation);
    }
    Report {
        points,
        at_rest: situation.ground().linear,
        efforts: efforts(situation, &hinges, &accelerations),
        accelerations,
    }
}

fn record<S: Scalar>(name: &str, pose: &Pose<S>, trace: &mut Trace<S>) {
    trace.section(format!("{name}_pose"), format!("Pose behind `{name}`"), "[P, Eq. (12)]");
    trace.vector(&format!("{name}_position"), pose.position);
    trace.matrix(&format!("{name}_to_inertial"), pose.to_inertial);
    trace.section(format!("{name}_velocity"), format!("Velocity behind `{name}`"), "");
    trace.vector(&format!("{name}_velocity"), pose.velocity);
}

/// The accelerations of all rates, in the layout's order of all rates.
fn rate_accelerations<S: Scalar>(situation: &EvalContext<S>, free: &[S]) -> Vec<S> {
    let of = |hinge: HingeId| match situation.prescribed_accelerations(hinge) {
        Some(given) => given.to_vec(),
        None => free[situation.layout.v[hinge].clone()].to_vec(),
    };
    situation.chain.hinges.ids().into_iter().flat_map(of).collect()
}

/// What is felt at all links' points: of bodies welded to others, by way of those.
fn felt<S: Scalar>(
    situation: &EvalContext<S>,
    links: &PerLink<LinkKinematics<S>>,
    swept: &SweepResult<S>,
) -> PerLink<Motion<S>> {
    let (all, _) = situation.tree.outward(
        ProperAcceleration(situation.ground()),
        |link, &ProperAcceleration(parent)| {
            let over = &links[link].over;
            let felt = match swept.behind[over.hinge] {
                Some(OutboardState { felt, .. }) => felt,
                None => over.carried_with(parent, over.drift),
            };
            (ProperAcceleration(felt), ())
        },
    );
    all.into_iter().map(|ProperAcceleration(felt)| felt).collect()
}

/// What is felt at a link's point. It crosses no boundary: the sweeps know it there.
#[derive(Clone, Copy)]
struct ProperAcceleration<S>(Motion<S>);

impl<S: Scalar> Flatten<S> for ProperAcceleration<S> {
    fn visit(self, _: &mut dyn FnMut(S) -> S) -> Self {
        self
    }
}

/// What every link's hinge exerts on it about its point [P, Eqs. (18), (19)]: of welds between
/// bodies, what everything behind them takes.
fn wrenches<S: Scalar>(
    situation: &EvalContext<S>,
    links: &PerLink<LinkKinematics<S>>,
    felt: &PerLink<Motion<S>>,
    swept: &SweepResult<S>,
    closed: Option<(&LoopHinge<S>, Wrench<S>)>,
) -> PerLink<Wrench<S>> {
    let known =
        |link: &LinkKinematics<S>| swept.behind[link.over.hinge].map(|behind| behind.wrench);
    let outer = if links.iter().all(|link| known(link).is_some()) {
        PerLink::new()
    } else {
        loads(situation, links)
    };
    let own = |(index, link): (LinkId, &LinkKinematics<S>)| match known(link) {
        Some(_) => WrenchSum(None),
        None => {
            let own = link.rigid().times(felt[index]) + link.velocity_load() - outer[index];
            WrenchSum(Some(own))
        }
    };
    let mut all: PerLink<WrenchSum<S>> = links.enumerate().map(own).collect();
    if let Some((closing, wrench)) = closed {
        if let Some(parent) = closing.parent {
            all[parent].add(|| wrench.moved_from(closing.over.arm));
        }
        let outboard = wrench.turned_back(&closing.over.to_parent);
        if let Some((child, on_child)) = closing.on_child(outboard) {
            all[child].add(|| on_child.reversed());
        }
    }
    let step = |link: LinkId, WrenchSum(sum): WrenchSum<S>, parent: &mut WrenchSum<S>| {
        let Some(wrench) = sum.or_else(|| known(&links[link])) else {
            bug!("the wrench in a hinge is neither a sum nor known")
        };
        parent.add(|| links[link].over.returned(wrench));
        wrench
    };
    situation.tree.inward(all, WrenchSum(None), step).0
}

/// A hinge and what it transmits.
struct HingeWrench<S> {
    over: HingeKinematics<S>,
    /// The link in whose work axes it is; none if those are inertial.
    axes: Option<LinkId>,
    /// Exerted by the inboard on the outboard side, about the outboard side's origin.
    wrench: Wrench<S>,
    /// Exerted by the inboard on the outboard side, about the inboard side's origin.
    at_inboard: Wrench<S>,
    /// Exerted on the child, about its point, in the hinge's work axes.
    on_child: Wrench<S>,
    /// The link behind it, where both its sides are one point that moves with that as well.
    meets: Option<LinkId>,
}

impl<S: Scalar> HingeWrench<S> {
    /// Over a link's hinge. On a seam the axes in front are known, those behind are another time's.
    fn over(
        situation: &EvalContext<S>,
        index: LinkId,
        link: &LinkKinematics<S>,
        on_child: Wrench<S>,
    ) -> Self {
        let (place, over) = (&situation.layout.links[index], link.over.clone());
        let (axes, at_child, offset) = match place.seam {
            Some(_) => (link.parent, on_child.turned(&over.to_parent), over.offset),
            None => (Some(index), on_child, over.to_parent.back(over.offset)),
        };
        let at_parent = at_child.moved_from(offset);
        let (wrench, at_inboard) = if place.reversed {
            (at_parent.reversed(), at_child.reversed())
        } else {
            (at_child, at_parent)
        };
        let meets = (place.seam.is_none() && over.keeps_the_point()).then_some(index);
        HingeWrench { over, axes, wrench, at_inboard, on_child, meets }
    }

    /// Over the hinge that closes the chain: the wrench on its outboard side, in its parent's axes.
    fn closing(closing: &LoopHinge<S>, wrench: Wrench<S>) -> Self {
        let over = closing.over.clone();
        let at_inboard = wrench.moved_from(over.offset);
        let on_child = wrench.turned_back(&over.to_parent);
        HingeWrench { over, axes: closing.parent, wrench, at_inboard, on_child, meets: None }
    }
}

/// What drives every rate: of a prescribed motion `Sᵀ F` and what its rotors take, less what acts
/// along it of itself.
fn efforts<S: Scalar>(
    situation: &EvalContext<S>,
    hinges: &IdVec<HingeId, Option<HingeWrench<S>>>,
    accelerations: &[S],
) -> Vec<S> {
    let of = |(index, transmitting): (HingeId, &Option<HingeWrench<S>>)| {
        let (true, Some(HingeWrench { over, on_child, .. })) =
            (situation.chain.hinges[index].is_prescribed(), transmitting)
        else {
            return situation.motor(index);
        };
        let own = &accelerations[situation.layout.rates[index].clone()];
        let rotors = over.passives.rotor_loads(own);
        let taken = over.subspace.iter().map(|s| s.power(*on_child));
        let less = rotors.iter().zip(&over.passives.efforts);
        taken.zip(less).map(|(taken, (&rotor, &passive))| taken + rotor - passive).collect()
    };
    hinges.enumerate().flat_map(of).collect()
}

/// What the connection points are read off.
struct PointReader<'a, S> {
    situation: &'a EvalContext<'a, S>,
    links: &'a PerLink<LinkKinematics<S>>,
    poses: &'a PerLink<Pose<S>>,
    felt: &'a PerLink<Motion<S>>,
    hinges: &'a IdVec<HingeId, Option<HingeWrench<S>>>,
}

impl<S: Scalar> PointReader<'_, S> {
    fn point(&self, spot: &ConnectionPoint) -> PointState<S> {
        let (part, origin, rotation) = self.situation.place(&spot.place);
        let (force, moment) = self.transmitted(spot);
        let Some(index) = link_of(part) else {
            let none = self.seen(None, Vec3::zero());
            return PointState {
                position: origin,
                rotation,
                velocity: none,
                omega: none,
                felt: self.seen(None, self.situation.ground().linear),
                turning: none,
                moment,
                force,
            };
        };
        let (link, pose) = (&self.links[index], &self.poses[index]);
        let arm = link.attitude * (origin - link.point);
        let (velocity, felt) = self.moving(spot, index, arm);
        PointState {
            position: pose.position + pose.to_inertial * arm,
            rotation: pose.to_inertial * (link.attitude * rotation),
            velocity,
            omega: self.seen(Some(index), link.omega),
            felt,
            turning: self.seen(Some(index), self.felt[index].angular),
            moment,
            force,
        }
    }

    /// Velocity and acceleration of a place on a link: where another link's point is there too,
    /// that one's, which are known.
    fn moving(
        &self,
        spot: &ConnectionPoint,
        index: LinkId,
        arm: Vec3<S>,
    ) -> (FramedVector<S>, FramedVector<S>) {
        let meets = spot.hinge.and_then(|(hinge, _)| self.hinges[hinge].as_ref()?.meets);
        if let Some(other) = meets {
            let (velocity, felt) = (self.poses[other].velocity, self.felt[other].linear);
            return (self.seen(Some(other), velocity), self.seen(Some(other), felt));
        }
        let (link, pose) = (&self.links[index], &self.poses[index]);
        let velocity = pose.velocity + link.omega.cross(arm);
        let felt =
            self.felt[index].carried_to(arm).linear + arm.centripetal_by_products(link.omega);
        (self.seen(Some(index), velocity), self.seen(Some(index), felt))
    }

    /// `q` and `m` at a place: on a body, `+q` and `−m` at its input, `−q` and `+m` at its output.
    fn transmitted(&self, spot: &ConnectionPoint) -> (FramedVector<S>, FramedVector<S>) {
        let at = |(index, outboard): (HingeId, bool)| {
            let Some(hinge) = &self.hinges[index] else { bug!("a hinge transmits nothing") };
            (hinge.axes, if outboard { hinge.wrench } else { hinge.at_inboard })
        };
        let at_free_end = (None, Wrench::zero());
        let (axes, wrench) = spot.hinge.map_or(at_free_end, at);
        (self.seen(axes, wrench.force), self.seen(axes, -wrench.moment))
    }

    /// A vector in the work axes of a link, or in inertial ones. In a plane and along a line it
    /// comes in the axes of the link's frame: work axes may lie across.
    fn seen(&self, link: Option<LinkId>, vector: Vec3<S>) -> FramedVector<S> {
        let Some(index) = link else { return FramedVector { axes: Mat3::identity(), vector } };
        let (axes, attitude) = (self.poses[index].to_inertial, self.links[index].attitude);
        match self.situation.chain.dimension {
            Dimension::Space => FramedVector { axes, vector },
            Dimension::Plane | Dimension::Line => {
                FramedVector { axes: axes * attitude, vector: attitude.transposed() * vector }
            }
        }
    }
}
