//! What the bodies' own motion takes, and what acts on them from outside: the parts of
//! [P, Eqs. (18), (19)] without the ends.

use super::load::{loads, point_acceleration};
use super::motion::{LinkMotion, sides};
use super::{Situation, Trace};
use crate::math::{Mat3, Motion, Rotation, Scalar, Vec3, Wrench};
use crate::model::{Body, Link, Place};

/// The load that every body's own motion takes, less what acts on it from outside, about its link's
/// point, inertial axes: from the links and the true accelerations of their points in those, and
/// from the same in body axes, gravity among the accelerations.
///
/// Inertias are constant in body axes, so their part is made there. What takes more operations
/// there, or is known in inertial axes already, is made in these.
pub(super) fn own_loads<S: Scalar>(
    situation: &Situation<S>,
    (inertial, points): (&[LinkMotion<S>], &[Motion<S>]),
    (bodies, felt): (&[LinkMotion<S>], &[Motion<S>]),
    trace: &mut Trace<S>,
) -> Vec<Wrench<S>> {
    let outer = loads(situation, bodies);
    let ground = situation.ground();
    let mut all = Vec::new();
    for (index, (link, &own)) in bodies.iter().zip(felt).enumerate() {
        let name = &link.over.name;
        trace.section(format!("Load of the body at `{name}`"), "[P, Eqs. (18), (19)]");
        let here = Here {
            link: &inertial[index],
            to_inertial: inertial[index].attitude * link.attitude.transposed(),
            point: points[index],
            ground: ground.linear,
        };
        let load = match here.shifting(situation, &situation.layout.links[index], link) {
            Some(shifting) => {
                let turning = link.turning_load(own.angular);
                let there = Wrench { force: Vec3::zero(), moment: turning } - outer[index];
                shifting + here.turned(there)
            }
            None => here.turned(link.rigid().times(own) + link.velocity_load() - outer[index]),
        };
        trace.wrench(&format!("{name}_own"), load);
        all.push(load);
    }
    all
}

/// A body in inertial axes.
struct Here<'a, S> {
    link: &'a LinkMotion<S>,
    /// From its work axes.
    to_inertial: Mat3<S>,
    /// What its point does.
    point: Motion<S>,
    /// The ground's acceleration, that of free fall the other way.
    ground: Vec3<S>,
}

impl<S: Scalar> Here<'_, S> {
    fn turned(&self, load: Wrench<S>) -> Wrench<S> {
        load.turned(&Rotation::general(self.to_inertial))
    }

    /// The part of the load that is no couple in body axes: `m r̈_C` at the point and
    /// `m r_C × r̈` about it; none where it takes fewer operations in body axes.
    fn shifting(
        &self,
        situation: &Situation<S>,
        place: &Link,
        own: &LinkMotion<S>,
    ) -> Option<Wrench<S>> {
        let Here { link, point, ground, .. } = self;
        let felt = point.linear + *ground;
        let (mass, omega) = (link.mass, link.omega);
        if let Some(share) = share_of_output(situation, place) {
            let arm = arm_of_output(situation, place, link);
            let output = point_acceleration(*point, omega, arm).linear + *ground;
            let share = mass * S::number(share);
            let force = felt * (mass - share) + output * share;
            return Some(Wrench { force, moment: arm.cross(felt * share) });
        }
        let moment = link.moment;
        let entries = own.moment.0.iter().filter(|entry| !entry.vanishes());
        let shifted = || point.angular.cross(moment) + moment.centripetal(omega);
        (entries.count() > 1)
            .then(|| Wrench { force: felt * mass + shifted(), moment: moment.cross(felt) })
    }
}

/// Where the centre of mass lies on an axis of the body through input, where the link's point is,
/// and output, not far from both, its distance from the input as a part of the output's: it moves by
/// that share with the output.
pub(super) fn share_of_output<S: Scalar>(situation: &Situation<S>, link: &Link) -> Option<f64> {
    let (_, to) = sides(situation.chain, link);
    let Body { com, output, .. } = &situation.chain.bodies[link.body];
    if *to != Place::Input(link.body) {
        return None;
    }
    let axis = (0..3).find(|&axis| !output.position[axis].is_zero())?;
    let others = (0..3).filter(|&other| other != axis);
    let alone = others.clone().all(|k| com[k].is_zero() && output.position[k].is_zero());
    let share = com[axis].known()? / output.position[axis].known()?;
    // Farther out, large multiples of what both ends do would cancel; so rounding grows threefold.
    (alone && (-1.0..=2.0).contains(&share)).then_some(share)
}

/// From a link's point to its body's output, work axes.
pub(super) fn arm_of_output<S: Scalar>(
    situation: &Situation<S>,
    place: &Link,
    link: &LinkMotion<S>,
) -> Vec3<S> {
    let (_, origin, _) = situation.place(&Place::Output(place.body));
    link.attitude * (origin - link.point)
}
