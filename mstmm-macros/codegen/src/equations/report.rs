//! Everything that can be asked of a chain once its accelerations are known: pose, velocity and
//! the state vector `z` at every connection point, from the bodies as written.
//!
//! Accelerations go outwards from the ground, wrenches come back from the free end. What comes out
//! is inertial, and `r̈` is true, whatever axes and tricks the sums are made with.

use super::motion::{point_of, sides};
use super::{Axes, LinkMotion, Situation, Trace, motion};
use crate::math::{Mat3, Motion, Rotation, Scalar, Vec3, Wrench};
use crate::model::{Element, HingeId, Place};

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

/// All connection points in the order written: the first element's input, then every output.
#[derive(Clone, Debug)]
pub struct Report<S> {
    /// One more than there are elements.
    pub points: Vec<Point<S>>,
}

/// A link's point as it moves.
#[derive(Clone, Copy)]
struct Moving<S> {
    position: Vec3<S>,
    velocity: Vec3<S>,
    acceleration: Motion<S>,
    /// Exerted on the link's body by its hinge.
    wrench: Wrench<S>,
}

/// The report for given accelerations of all hinges.
pub fn report<S: Scalar>(
    situation: &Situation<S>,
    accelerations: &[S],
    trace: &mut Trace<S>,
) -> Report<S> {
    let links = motion(situation, Axes::Inertial, trace);
    let mut moving = outwards(situation, &links, accelerations, trace);
    let loads = own_loads(situation, &links, accelerations, trace);
    inwards(situation, &links, &loads, &mut moving, trace);
    let sheet = Sheet { situation, links: &links, moving: &moving };
    trace.section("Connection points", "[P, Eqs. (4), (12)]");
    Report { points: spots(situation).iter().map(|spot| sheet.point(spot)).collect() }
}

/// Where a connection point is.
struct Spot {
    place: Place,
    /// The hinge that it belongs to, if it is on the ground.
    hinge: Option<HingeId>,
}

/// All connection points, in the order written.
fn spots<S>(situation: &Situation<S>) -> Vec<Spot> {
    let mut spots = Vec::new();
    for (number, element) in situation.chain.route.iter().enumerate() {
        let (input, output, hinge) = match *element {
            Element::Hinge(index) => {
                let hinge = &situation.chain.hinges[index];
                (hinge.inboard.clone(), hinge.outboard.clone(), Some(index))
            }
            Element::Body(index) => (Place::Input(index), Place::Output(index), None),
        };
        if number == 0 {
            spots.push(Spot { place: input, hinge });
        }
        spots.push(Spot { place: output, hinge });
    }
    spots
}

/// Positions, velocities and true accelerations [P, Eqs. (12), (13), (36)].
fn outwards<S: Scalar>(
    situation: &Situation<S>,
    links: &[LinkMotion<S>],
    accelerations: &[S],
    trace: &mut Trace<S>,
) -> Vec<Moving<S>> {
    let mut moving: Vec<Moving<S>> = Vec::new();
    let mut points: Vec<(Vec3<S>, Vec3<S>)> = Vec::new();
    for (link, place) in links.iter().zip(&situation.layout.links) {
        trace.section(format!("Point of `{}`", link.name), "[P, Eqs. (12), (13), (36)]");
        let (position, velocity) = link.place(&points, links);
        let parent = link.parent.map_or(Motion::zero(), |parent| moving[parent].acceleration);
        let rates = &accelerations[situation.layout.v[place.hinge].clone()];
        let acceleration = link.carried(parent) + link.freedom.motion(rates);
        trace.motion(&format!("{}_acc", link.name), acceleration);
        points.push((position, velocity));
        moving.push(Moving { position, velocity, acceleration, wrench: Wrench::zero() });
    }
    moving
}

/// The load that every body's own motion takes, about its link's point, inertial axes: the parts of
/// [P, Eqs. (18), (19)] without its ends. Inertias are constant in body axes, so the sums are made
/// there.
fn own_loads<S: Scalar>(
    situation: &Situation<S>,
    inertial: &[LinkMotion<S>],
    accelerations: &[S],
    trace: &mut Trace<S>,
) -> Vec<Wrench<S>> {
    let links = motion(situation, Axes::Body, trace);
    let ground = situation.ground();
    let mut felt: Vec<Motion<S>> = Vec::new();
    let mut loads = Vec::new();
    for (index, link) in links.iter().enumerate() {
        trace.section(format!("Load of the body at `{}`", link.name), "[P, Eqs. (18), (19)]");
        let rates = &accelerations[situation.layout.v[situation.layout.links[index].hinge].clone()];
        let carried = link.carried(link.parent.map_or(ground, |parent| felt[parent]));
        let own = carried + link.freedom.motion(rates);
        let load = link.rigid().times(own) + link.velocity_load();
        let to_inertial = inertial[index].attitude * link.attitude.transposed();
        let load = load.turned(&Rotation::general(to_inertial));
        trace.wrench(&format!("{}_own", link.name), load);
        felt.push(own);
        loads.push(load);
    }
    loads
}

/// What every hinge exerts, from the free end [P, Eqs. (18), (19)]; where it frees whole axes of
/// the inertial frame that is its effort and nothing else [P, Eqs. (25), (57), (58)].
fn inwards<S: Scalar>(
    situation: &Situation<S>,
    links: &[LinkMotion<S>],
    loads: &[Wrench<S>],
    moving: &mut [Moving<S>],
    trace: &mut Trace<S>,
) {
    let Situation { chain, layout, numbers, inputs, .. } = *situation;
    let efforts = numbers.efforts(chain, layout, inputs);
    for index in (0..links.len()).rev() {
        let link = &links[index];
        trace.section(format!("Load on `{}`", link.name), "[P, Eqs. (18), (19)]");
        let efforts = &efforts[layout.v[layout.links[index].hinge].clone()];
        moving[index].wrench = link.freedom.released(moving[index].wrench + loads[index], efforts);
        trace.wrench(&format!("{}_load", link.name), moving[index].wrench);
        if let Some(parent) = link.parent {
            moving[parent].wrench =
                moving[parent].wrench + moving[index].wrench.moved_from(link.arm);
        }
    }
}

impl<S: Scalar> LinkMotion<S> {
    /// Position and velocity of the point, for links in inertial axes; `points` holds those of all
    /// links before.
    pub(super) fn place(
        &self,
        points: &[(Vec3<S>, Vec3<S>)],
        links: &[LinkMotion<S>],
    ) -> (Vec3<S>, Vec3<S>) {
        match self.parent {
            None => (self.arm, self.relative.linear),
            Some(parent) => {
                let (position, velocity) = points[parent];
                let turning = links[parent].omega.cross(self.arm);
                (position + self.arm, velocity + turning + self.relative.linear)
            }
        }
    }
}

/// What the connection points are read off.
struct Sheet<'a, S> {
    situation: &'a Situation<'a, S>,
    links: &'a [LinkMotion<S>],
    moving: &'a [Moving<S>],
}

impl<S: Scalar> Sheet<'_, S> {
    fn point(&self, spot: &Spot) -> Point<S> {
        let Situation { chain, layout, numbers, .. } = *self.situation;
        let (origin, rotation) = numbers.place(chain, &spot.place);
        let (force, moment) = self.transmitted(spot);
        let Some(index) = layout.links.iter().position(|link| Some(link.body) == spot.place.body())
        else {
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
        let (link, moving) = (&self.links[index], &self.moving[index]);
        let arm = link.attitude * (origin - point_of(self.situation, index));
        let acceleration = moving.acceleration.carried_to(arm);
        Point {
            position: moving.position + arm,
            rotation: link.attitude * rotation,
            velocity: moving.velocity + link.omega.cross(arm),
            omega: link.omega,
            acceleration: Motion {
                linear: acceleration.linear + arm.centripetal(link.omega),
                angular: acceleration.angular,
            },
            force,
            moment,
        }
    }

    /// `q` and `m` at a place: on a body, `+q` and `−m` at its input, `−q` and `+m` at its output.
    fn transmitted(&self, spot: &Spot) -> (Vec3<S>, Vec3<S>) {
        let Situation { chain, layout, .. } = *self.situation;
        let mut through = Wrench::zero();
        for (index, link) in layout.links.iter().enumerate() {
            let wrench = self.moving[index].wrench;
            // Exerted by the inboard on the outboard side, about the child's point.
            let outwards = if link.reversed { wrench.reversed() } else { wrench };
            let (parents, childs) = sides(chain, link);
            if spot.is(childs, link.hinge) {
                through = through + outwards;
            } else if spot.is(parents, link.hinge) {
                through = through + outwards.moved_from(self.links[index].offset);
            }
        }
        (through.force, -through.moment)
    }
}

impl Spot {
    /// Whether it is on this side of this hinge.
    fn is(&self, side: &Place, hinge: HingeId) -> bool {
        match (&self.place, side) {
            (Place::Input(a), Place::Input(b)) | (Place::Output(a), Place::Output(b)) => a == b,
            (Place::Ground(_), Place::Ground(_)) => self.hinge == Some(hinge),
            _ => false,
        }
    }
}
