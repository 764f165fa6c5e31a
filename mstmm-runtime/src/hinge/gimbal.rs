//! The gimbal: a rotation about an axis fixed in the inboard element, then one about an axis that the first rotation
//! moves, then one about an axis fixed in the outboard element.

use nalgebra::Vector3;

use super::orientation::store;
use crate::Scalar;

/// Angles and rates of a gimbal, read from a state.
#[doc(alias("JointModelSphericalZYX", "Euler angles", "rpy"))]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct GimbalState<T> {
    angles: [T; 3],
    rates: [T; 3],
}

impl<T: Scalar> GimbalState<T> {
    /// Makes the view from α, β, γ and their rates.
    #[inline]
    pub fn new(angles: [T; 3], rates: [T; 3]) -> Self {
        Self { angles, rates }
    }

    /// Returns the angles α, β and γ in rad, which are not wrapped.
    ///
    /// The rotation from the inboard to the outboard frame is Rot(a, α) Rot(b, β) Rot(c, γ), with axis a fixed in the
    /// inboard and axis c in the outboard element. The first rotation moves axis b.
    #[inline]
    pub fn angles(&self) -> Vector3<T> {
        Vector3::from(self.angles)
    }

    /// Returns the rates of α, β and γ in rad/s.
    #[inline]
    pub fn rates(&self) -> Vector3<T> {
        Vector3::from(self.rates)
    }

    /// Returns the arguments of [`new`](Self::new).
    #[doc(hidden)]
    #[inline]
    pub fn into_groups(self) -> ([T; 3], [T; 3]) {
        (self.angles, self.rates)
    }
}

/// Angles and rates of a gimbal, for writing to a state.
#[derive(Debug)]
pub struct GimbalStateMut<'a, T> {
    angles: [&'a mut T; 3],
    rates: [&'a mut T; 3],
}

impl<'a, T: Scalar> GimbalStateMut<'a, T> {
    /// Makes the view from references to α, β, γ and of their rates; for generated code.
    #[inline]
    pub fn new(angles: [&'a mut T; 3], rates: [&'a mut T; 3]) -> Self {
        Self { angles, rates }
    }

    /// Sets the angles α, β and γ in rad of Rot(a, α) Rot(b, β) Rot(c, γ), with axis a fixed in the inboard and
    /// axis c in the outboard element.
    #[inline]
    pub fn set_angles(&mut self, angles: Vector3<T>) -> &mut Self {
        store(&mut self.angles, angles.into());
        self
    }

    /// Sets the rates of α, β and γ in rad/s.
    #[inline]
    pub fn set_rates(&mut self, rates: Vector3<T>) -> &mut Self {
        store(&mut self.rates, rates.into());
        self
    }
}
