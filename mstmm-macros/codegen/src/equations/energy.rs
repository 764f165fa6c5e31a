//! Kinetic and potential energy.

use super::closing::closing;
use super::hinge::Passives;
use super::load::{poses, spring_energy};
use super::{Axes, Situation, Trace, motion};
use crate::math::{Scalar, Vec3};
use crate::model::Source;

/// The energy of a chain in J.
#[derive(Clone, Copy, Debug)]
pub struct Energy<S> {
    /// `Σ ½ m ṙ_Cᵀ ṙ_C + ½ Ωᵀ J_C Ω`, and of rotors `Σ ½ I ṡ²`
    pub kinetic: S,
    /// `−Σ m gᵀ r_C`, zero with every centre of mass at the inertial origin, and what springs and
    /// stops hold. Gravity that is an input has no potential.
    pub potential: S,
}

/// The energy in the given situation, whose layout has every body for itself.
pub fn energy<S: Scalar>(situation: &Situation<S>, trace: &mut Trace<S>) -> Energy<S> {
    let links = motion(situation, Axes::Inertial, trace);
    trace.section("Energy", "");
    let half = S::number(0.5);
    let gravity = match &situation.chain.gravity {
        Source::Constant(values) => situation.numbers.vector(values),
        Source::Nothing | Source::Input => Vec3::zero(),
    };
    let poses = poses(situation, &links);
    let mut energy = Energy { kinetic: S::zero(), potential: spring_energy(situation, None) };
    for (index, ((link, pose), place)) in
        links.iter().zip(&poses).zip(&situation.layout.links).enumerate()
    {
        let body = &situation.chain.bodies[place.body];
        let com = link.attitude * (situation.numbers.vector(&body.com) - link.point);
        let velocity = pose.velocity + link.omega.cross(com);
        // The inertia is constant in body axes.
        let spin = link.attitude.transposed() * link.omega;
        let turning = spin.dot(situation.numbers.central_inertia(body) * spin);
        energy.kinetic = energy.kinetic + (link.mass * velocity.dot(velocity) + turning) * half;
        energy.potential = energy.potential - gravity.dot(pose.position + com) * link.mass;
        energy.potential = energy.potential + spring_energy(situation, Some((index, link, pose)));
        energy.add_passives(&link.over.passives);
        let sums = (energy.kinetic, energy.potential);
        (energy.kinetic, energy.potential) = situation.passage.outwards(index, sums);
    }
    if let Some(closing) = closing(situation, Axes::Inertial, &links) {
        energy.add_passives(&closing.over.passives);
    }
    energy
}

impl<S: Scalar> Energy<S> {
    /// Adds what a hinge holds.
    fn add_passives(&mut self, passives: &Passives<S>) {
        self.potential = self.potential + passives.energy;
        for (&inertia, &rate) in passives.rotors.iter().zip(&passives.rates) {
            self.kinetic = self.kinetic + inertia * (rate * rate) * S::number(0.5);
        }
    }
}
