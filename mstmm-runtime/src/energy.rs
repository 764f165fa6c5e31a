//! The energy of a chain.

use crate::Scalar;

/// Kinetic and potential energy in J.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Energy<T> {
    /// Of all bodies, from the velocities of their centres of mass and their angular velocities.
    pub kinetic: T,
    /// Of gravity; zero with every centre of mass at the inertial origin.
    pub potential: T,
}

impl<T: Scalar> Energy<T> {
    /// The sum of both.
    #[inline]
    pub fn total(&self) -> T {
        self.kinetic + self.potential
    }
}
