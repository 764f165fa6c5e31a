//! Kinetic and potential energy.

use super::{Axes, Situation, Trace, motion};
use crate::math::{Scalar, Vec3};

/// The energy of a chain in J.
#[derive(Clone, Copy, Debug)]
pub struct Energy<S> {
    /// `Σ ½ m ṙ_Cᵀ ṙ_C + ½ Ωᵀ J_C Ω`
    pub kinetic: S,
    /// `−Σ m gᵀ r_C`: zero with every centre of mass at the inertial origin.
    pub potential: S,
}

/// The energy in the given situation.
pub fn energy<S: Scalar>(situation: &Situation<S>, trace: &mut Trace<S>) -> Energy<S> {
    let links = motion(situation, Axes::Inertial, trace);
    trace.section("Energy", "");
    let numbers = situation.numbers;
    let gravity = numbers.vector(&situation.chain.gravity);
    let mut points: Vec<(Vec3<S>, Vec3<S>)> = Vec::new();
    let mut energy = Energy { kinetic: S::zero(), potential: S::zero() };
    for (link, place) in links.iter().zip(&situation.layout.links) {
        let body = &situation.chain.bodies[place.body];
        let (position, velocity) = link.place(&points, &links);
        points.push((position, velocity));
        let velocity = velocity + link.omega.cross(link.com);
        let spin = link.attitude.transposed() * link.omega;
        let momentum = spin.dot(numbers.central_inertia(body) * spin);
        energy.kinetic =
            energy.kinetic + (link.mass * velocity.dot(velocity) + momentum) * S::number(0.5);
        energy.potential = energy.potential - gravity.dot(position + link.com) * link.mass;
    }
    energy
}
