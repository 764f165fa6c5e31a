//! The energy of a chain.

use crate::Scalar;

/// Kinetic and potential energy in J.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Energy<T> {
    /// Of all bodies, from the velocities of their centres of mass and their angular velocities,
    /// and of the rotors in hinges.
    pub kinetic: T,
    /// Of gravity, springs and limits; zero with every centre of mass at the inertial origin and
    /// every spring at rest.
    pub potential: T,
}

impl<T: Scalar> Energy<T> {
    /// The sum of both.
    #[inline]
    pub fn total(&self) -> T {
        self.kinetic + self.potential
    }
}
