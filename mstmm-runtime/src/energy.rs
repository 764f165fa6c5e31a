//! The energy of a chain.

use crate::Scalar;

/// Kinetic and potential energy in J.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Energy<T> {
    /// Kinetic energy in J of all bodies and of the rotors in hinges.
    #[doc(alias(
        "computeKineticEnergy",
        "CalcKineticEnergy",
        "EvalKineticEnergy",
        "kineticEnergy",
        "e_kinetic",
        "mj_energyVel"
    ))]
    pub kinetic: T,
    /// Potential energy in J of gravity, springs and limits. It is zero if all centres of mass are at the inertial origin
    /// and all springs are at rest.
    #[doc(alias("computePotentialEnergy", "CalcPotentialEnergy", "EvalPotentialEnergy"))]
    #[doc(alias("potential energy", "potentialEnergy", "mj_energyPos", "e_potential"))]
    pub potential: T,
}

impl<T: Scalar> Energy<T> {
    /// Returns the sum of kinetic and potential energy.
    #[doc(alias("mechanical energy", "mechanicalEnergy", "computeMechanicalEnergy"))]
    #[inline]
    pub fn total(&self) -> T {
        self.kinetic + self.potential
    }
}
