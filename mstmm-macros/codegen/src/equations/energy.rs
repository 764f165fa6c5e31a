//! Kinetic and potential energy, as a running total over the links.
//!
//! With velocity `ṙ` of a link's point, `Ω`, mass `m`, first moment `m r_C` and inertia `J` about the
//! point in work axes, position `r` in inertial ones, strains `s` and inertias `I` of rotors:
//!
//! (1)  `T = Σ ½ m ṙᵀ ṙ + ṙᵀ (Ω × m r_C) + ½ Ωᵀ J Ω + ½ I ṡ²`
//! (2)  `V = −Σ gᵀ (m r + A m r_C) + springs and stops`

use super::base_parameters::to_base_parameters;
use super::hinge::PassiveElements;
use super::kinematics::poses;
use super::loads::spring_energy;
use super::loop_hinge::loop_hinge;
use super::sweep::Flatten;
use super::{Axes, EvalContext, Trace, kinematics};
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
///
/// Turning about the link's point, of which the sweeps have products, takes fewer operations than
/// about the centre of mass: `½ m ṙᵀ ṙ + ṙᵀ (Ω × m r_C) + ½ Ωᵀ J Ω`, of the Panda 250 of 2870 with
/// everything. Where the centre of mass rests while the body turns, the terms cancel up to
/// `(r_C / k)²`, `k` being the radius of gyration: two digits if it is a tenth of the distance.
///
/// What the turning of a pin leaves in place moves as the parent does, and has its height: given to
/// that one it has the same energy, for 301 operations of the Panda in place of 392.
pub fn energy<S: Scalar>(context: &EvalContext<S>, trace: &mut Trace<S>) -> Energy<S> {
    // First moments and inertias are constant in body axes.
    let mut links = kinematics(context, Axes::Body, trace);
    to_base_parameters(context, &mut links, trace);
    trace.section("energy", "Energy", "");
    let half = S::number(0.5);
    let gravity = match &context.chain.gravity {
        Source::Constant(values) => context.numbers.vector(values),
        Source::Nothing | Source::Input => Vec3::zero(),
    };
    let poses = poses(context, &links);
    let start = Energy { kinetic: S::zero(), potential: spring_energy(context, None) };
    let mut energy = context.tree.total(start, |index, mut energy| {
        let (link, pose) = (&links[index], &poses[index]);
        let beside = link.omega.cross(link.first_moment);
        let shifting = pose.velocity.dot(pose.velocity * (link.mass * half) + beside);
        let turning = link.inertia.quadratic_form(link.omega);
        energy.kinetic = energy.kinetic + shifting + turning * half;
        let first_moment = pose.position * link.mass + pose.to_inertial * link.first_moment;
        energy.potential = energy.potential - gravity.dot(first_moment);
        energy.potential = energy.potential + spring_energy(context, Some((index, link, pose)));
        energy.add_passives(&link.hinge.passives);
        energy
    });
    if let Some(loop_hinge) = loop_hinge(context, Axes::Body, &links) {
        energy.add_passives(&loop_hinge.hinge.passives);
    }
    energy
}

impl<S: Scalar> Flatten<S> for Energy<S> {
    fn visit(self, replace: &mut dyn FnMut(S) -> S) -> Self {
        let kinetic = replace(self.kinetic);
        Energy { kinetic, potential: replace(self.potential) }
    }
}

impl<S: Scalar> Energy<S> {
    /// Adds what a hinge holds.
    fn add_passives(&mut self, passives: &PassiveElements<S>) {
        self.potential = self.potential + passives.energy;
        for (&inertia, &rate) in passives.rotor_inertias.iter().zip(&passives.strain_rates) {
            self.kinetic = self.kinetic + inertia * (rate * rate) * S::number(0.5);
        }
    }
}
