//! Everything that can be asked of a chain once its accelerations are known: pose, velocity and
//! the state vector `z` at every connection point, from the bodies as written.
//!
//! Accelerations go outwards from the ground, wrenches come back from the free end. What comes out
//! is inertial, and `r̈` is true, whatever axes and tricks the sums are made with.

use super::closing::closing;
use super::load::{Pose, point_acceleration, poses};
use super::motion::{Crossed, LinkMotion};
use super::own_load::own_loads;
use super::{Axes, Situation, Solved, Trace, hinge, motion};
use crate::math::{Mat3, Motion, Rotation, Scalar, Vec3, Wrench};
use crate::model::{Element, HingeId, Part, Place};

/// A connection point, inertial frame.
#[derive(Clone, Copy, Debug)]
pub struct Point<S> {
    /// Its place.
    pub position: Vec3<S>,
    /// Its frame's axes to inertial ones.
    pub rotation: Mat3<S>,
    /// Its velocity.
    pub velocity: Vec3<S>,
    /// Its frame's angular velocity `Ω`.
    pub omega: Vec3<S>,
    /// `r̈` and `Ω̇`.
    pub acceleration: Motion<S>,
    /// Internal force `q` and internal moment `m`, in the signs of [P, Sect. 2.1].
    pub force: Vec3<S>,
    /// See `force`.
    pub moment: Vec3<S>,
}

/// Everything but the accelerations themselves.
#[derive(Clone, Debug)]
pub struct Report<S> {
    /// All connection points in the order written: the first element's input, then every output.
    /// One more than there are elements.
    pub points: Vec<Point<S>>,
    /// Accelerations of all hinges' rates, prescribed ones as well.
    pub accelerations: Vec<S>,
    /// What drives every rate: the efforts of motors, and what prescribed motions take.
    pub efforts: Vec<S>,
}

/// A hinge and what it transmits, inertial axes.
struct Transmitting<S> {
    over: Crossed<S>,
    /// Exerted by the inboard on the outboard side, about the outboard side's origin.
    wrench: Wrench<S>,
    /// Exerted by the inboard on the outboard side, about the inboard side's origin.
    at_inboard: Wrench<S>,
    /// Exerted on the child, about its point.
    on_child: Wrench<S>,
}

/// The report for given accelerations of all hinges.
pub fn report<S: Scalar>(
    situation: &Situation<S>,
    solved: &Solved<S>,
    trace: &mut Trace<S>,
) -> Report<S> {
    let links = motion(situation, Axes::Inertial, trace);
    let poses = poses(situation, &links);
    let accelerations = rate_accelerations(situation, &solved.accelerations);
    let bodies = motion(situation, Axes::Body, trace);
    let felt = felt(situation, &bodies, &accelerations, trace);
    let points = outwards(situation, (&links, &bodies), (&felt, &accelerations), trace);
    let loads = own_loads(situation, (&links, &points), (&bodies, &felt), trace);
    let hinges = inwards(situation, &links, loads, solved, trace);
    let sheet = Sheet { situation, links: &links, poses: &poses, points: &points, hinges: &hinges };
    trace.section("Connection points", "[P, Eqs. (4), (12)]");
    Report {
        points: spots(situation).iter().map(|spot| sheet.point(spot)).collect(),
        efforts: efforts(situation, &hinges, &accelerations),
        accelerations,
    }
}

/// The accelerations of all rates, in the layout's order of all rates.
fn rate_accelerations<S: Scalar>(situation: &Situation<S>, free: &[S]) -> Vec<S> {
    let of = |hinge: HingeId| match situation.prescribed_accelerations(hinge) {
        Some(given) => given.to_vec(),
        None => free[situation.layout.v[hinge].clone()].to_vec(),
    };
    (0..situation.chain.hinges.len()).flat_map(of).collect()
}

/// Accelerations of all points in body axes, gravity among them, as the sweeps have them.
fn felt<S: Scalar>(
    situation: &Situation<S>,
    bodies: &[LinkMotion<S>],
    accelerations: &[S],
    trace: &mut Trace<S>,
) -> Vec<Motion<S>> {
    let ground = situation.ground();
    let mut felt: Vec<Motion<S>> = Vec::new();
    for (index, link) in bodies.iter().enumerate() {
        let over = &link.over;
        trace.section(format!("Acceleration felt behind `{}`", over.name), "[P, Eqs. (13), (36)]");
        let parent = link.parent.map_or(ground, |parent| felt[parent]);
        let carried = over.carried_with(parent, over.drift);
        let own = carried + own_acceleration(situation, over, accelerations);
        felt.push(situation.passage.outwards(index, own));
    }
    felt
}

/// True accelerations of all points [P, Eqs. (13), (36)]. Behind a hinge that turns about all axes
/// `Ω̇` takes fewer operations from that in body axes.
fn outwards<S: Scalar>(
    situation: &Situation<S>,
    (links, bodies): (&[LinkMotion<S>], &[LinkMotion<S>]),
    (felt, accelerations): (&[Motion<S>], &[S]),
    trace: &mut Trace<S>,
) -> Vec<Motion<S>> {
    let mut points: Vec<Motion<S>> = Vec::new();
    for (index, link) in links.iter().enumerate() {
        let over = &link.over;
        trace.section(format!("Point of `{}`", over.name), "[P, Eqs. (12), (13), (36)]");
        let parent = link.parent.map_or(Motion::zero(), |parent| points[parent]);
        let mut acceleration = over.carried_with(parent, over.drift)
            + own_acceleration(situation, over, accelerations);
        if over.subspace.iter().filter(|s| s.turns()).count() > 2 {
            let to_inertial = link.attitude * bodies[index].attitude.transposed();
            acceleration.angular = to_inertial * felt[index].angular;
        }
        trace.motion(&format!("{}_acc", over.name), acceleration);
        points.push(situation.passage.outwards(index, acceleration));
    }
    points
}

/// What a hinge's own accelerations make; prescribed ones are part of its drift.
fn own_acceleration<S: Scalar>(
    situation: &Situation<S>,
    over: &Crossed<S>,
    accelerations: &[S],
) -> Motion<S> {
    if situation.chain.hinges[over.hinge].is_prescribed() {
        return Motion::zero();
    }
    let own = &accelerations[situation.layout.rates[over.hinge].clone()];
    hinge::combine(over.subspace.iter(), own)
}

/// What every hinge transmits, from the free end or from the closing hinge [P, Eqs. (18), (19)];
/// where it frees whole axes of the inertial frame that is its effort and nothing else
/// [P, Eqs. (25), (57), (58)].
fn inwards<S: Scalar>(
    situation: &Situation<S>,
    links: &[LinkMotion<S>],
    mut loads: Vec<Wrench<S>>,
    solved: &Solved<S>,
    trace: &mut Trace<S>,
) -> Vec<Option<Transmitting<S>>> {
    let mut hinges: Vec<Option<Transmitting<S>>> =
        situation.chain.hinges.iter().map(|_| None).collect();
    if let (Some(closing), Some(reaction)) =
        (closing(situation, Axes::Inertial, links), &solved.reaction)
    {
        trace.section(format!("Load on `{}`", closing.over.name), "[P, Eqs. (18), (19)]");
        let attitude = closing.parent.map_or(Mat3::identity(), |link| links[link].attitude);
        let inboard = &situation.chain.hinges[closing.over.hinge].inboard;
        let (_, _, rotation) = situation.place(inboard);
        let wrench = reaction.wrench.turned(&Rotation::general(attitude * rotation));
        trace.wrench(&format!("{}_load", closing.over.name), wrench);
        if let Some(parent) = closing.parent {
            loads[parent] = loads[parent] + wrench.moved_from(closing.over.arm);
        }
        if let Some((child, on_child)) = closing.on_child(wrench) {
            loads[child] = loads[child] - on_child;
        }
        let index = closing.over.hinge;
        hinges[index] = Some(Transmitting::of(closing.over, wrench, false));
    }
    for index in (0..links.len()).rev() {
        loads[index] = situation.passage.inwards(index, loads[index]);
        let link = &links[index];
        let over = &link.over;
        trace.section(format!("Load on `{}`", over.name), "[P, Eqs. (18), (19)]");
        let wrench = over.freedom.released(loads[index], &over.efforts);
        trace.wrench(&format!("{}_load", over.name), wrench);
        if let Some(parent) = link.parent {
            loads[parent] = loads[parent] + wrench.moved_from(over.arm);
        }
        let reversed = situation.layout.links[index].reversed;
        hinges[over.hinge] = Some(Transmitting::of(over.clone(), wrench, reversed));
    }
    hinges
}

impl<S: Scalar> Transmitting<S> {
    /// From the wrench on the child about its point.
    fn of(over: Crossed<S>, on_child: Wrench<S>, reversed: bool) -> Self {
        let at_parent = on_child.moved_from(over.offset);
        let (wrench, at_inboard) = if reversed {
            (at_parent.reversed(), on_child.reversed())
        } else {
            (on_child, at_parent)
        };
        Transmitting { over, wrench, at_inboard, on_child }
    }
}

/// What drives every rate: of a prescribed motion `Sᵀ F` and what its rotors take, less what acts
/// along it of itself.
fn efforts<S: Scalar>(
    situation: &Situation<S>,
    hinges: &[Option<Transmitting<S>>],
    accelerations: &[S],
) -> Vec<S> {
    let of = |(index, transmitting): (HingeId, &Option<Transmitting<S>>)| {
        let (true, Some(Transmitting { over, on_child, .. })) =
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
    hinges.iter().enumerate().flat_map(of).collect()
}

/// Where a connection point is.
struct Spot {
    place: Place,
    /// The hinge there, if there is one, and whether its outboard side is meant.
    hinge: Option<(HingeId, bool)>,
}

/// All connection points, in the order written; those of repeated parts once.
fn spots<S>(situation: &Situation<S>) -> Vec<Spot> {
    let chain = situation.chain;
    let mut spots: Vec<Spot> = Vec::new();
    let add = |spots: &mut Vec<Spot>, number: usize, spot: Spot| match spots.get_mut(number) {
        // A body's end, and now the hinge at it; or a hinge's side, and now the body that it is on.
        Some(known) if known.hinge.is_none() => *known = spot,
        Some(_) => {}
        None => spots.push(spot),
    };
    // On a seam what passes is what the seam's weld passes on.
    let side = |hinge: HingeId, place: &Place, outboard: bool| {
        let weld = chain.seam(place).and_then(|seam| chain.weld_of(seam));
        weld.map_or(Spot { place: place.clone(), hinge: Some((hinge, outboard)) }, |weld| Spot {
            place: chain.hinges[weld].inboard.clone(),
            hinge: Some((weld, false)),
        })
    };
    for (number, element) in chain.route.iter().enumerate() {
        let (input, output) = match *element {
            Element::Hinge(index) => {
                let hinge = &chain.hinges[index];
                (side(index, &hinge.inboard, false), side(index, &hinge.outboard, true))
            }
            Element::Body(index) => {
                let output = Place::Output(index);
                let last = chain.hinges.iter().position(|hinge| {
                    hinge.inboard == output && chain.seam(&hinge.outboard).is_some()
                });
                (
                    Spot { place: Place::Input(index), hinge: None },
                    Spot { place: output, hinge: last.map(|weld| (weld, false)) },
                )
            }
        };
        add(&mut spots, number, input);
        add(&mut spots, number + 1, output);
    }
    spots
}

/// What the connection points are read off.
struct Sheet<'a, S> {
    situation: &'a Situation<'a, S>,
    links: &'a [LinkMotion<S>],
    poses: &'a [Pose<S>],
    points: &'a [Motion<S>],
    hinges: &'a [Option<Transmitting<S>>],
}

impl<S: Scalar> Sheet<'_, S> {
    fn point(&self, spot: &Spot) -> Point<S> {
        let (part, origin, rotation) = self.situation.place(&spot.place);
        let transmitted = self.transmitted(spot);
        let (force, moment) = (transmitted.force, -transmitted.moment);
        let Part::Link(index) = part else {
            return Point {
                position: origin,
                rotation,
                velocity: Vec3::zero(),
                omega: Vec3::zero(),
                acceleration: Motion::zero(),
                force,
                moment,
            };
        };
        let (link, pose) = (&self.links[index], &self.poses[index]);
        let arm = link.attitude * (origin - link.point);
        Point {
            position: pose.position + arm,
            rotation: link.attitude * rotation,
            velocity: pose.velocity + link.omega.cross(arm),
            omega: link.omega,
            acceleration: point_acceleration(self.points[index], link.omega, arm),
            force,
            moment,
        }
    }

    /// `q` and `−m` at a place: on a body, `+q` and `−m` at its input, `−q` and `+m` at its output.
    fn transmitted(&self, spot: &Spot) -> Wrench<S> {
        let at = |(index, outboard): (HingeId, bool)| {
            let hinge = self.hinges[index].as_ref()?;
            Some(if outboard { hinge.wrench } else { hinge.at_inboard })
        };
        spot.hinge.and_then(at).unwrap_or(Wrench::zero())
    }
}
