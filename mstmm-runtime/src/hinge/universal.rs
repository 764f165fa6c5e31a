//! The universal hinge: a rotation about an axis fixed in the inboard element, then one about an axis fixed in the
//! outboard element.

use nalgebra::Vector2;

use super::orientation::store;
use crate::Scalar;

/// Angles and rates of a universal hinge, read from a state.
#[doc(alias("UniversalJoint", "cardan", "Hooke joint"))]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct UniversalState<T> {
    angles: [T; 2],
    rates: [T; 2],
}

impl<T: Scalar> UniversalState<T> {
    /// Makes the view from α, β and their rates.
    #[inline]
    pub fn new(angles: [T; 2], rates: [T; 2]) -> Self {
        Self { angles, rates }
    }

    /// Returns the angles α and β in rad, which are not wrapped.
    ///
    /// The rotation from the inboard to the outboard frame is Rot(a, α) Rot(b, β), with axis a fixed in the inboard and
    /// axis b in the outboard element.
    #[inline]
    pub fn angles(&self) -> Vector2<T> {
        Vector2::from(self.angles)
    }

    /// Returns the rates of α and β in rad/s.
    #[inline]
    pub fn rates(&self) -> Vector2<T> {
        Vector2::from(self.rates)
    }

    /// Returns the arguments of [`new`](Self::new).
    #[doc(hidden)]
    #[inline]
    pub fn into_groups(self) -> ([T; 2], [T; 2]) {
        (self.angles, self.rates)
    }
}

/// Angles and rates of a universal hinge, for writing to a state.
#[derive(Debug)]
pub struct UniversalStateMut<'a, T> {
    angles: [&'a mut T; 2],
    rates: [&'a mut T; 2],
}

impl<'a, T: Scalar> UniversalStateMut<'a, T> {
    /// Makes the view from references to α, β and of their rates; for generated code.
    #[inline]
    pub fn new(angles: [&'a mut T; 2], rates: [&'a mut T; 2]) -> Self {
        Self { angles, rates }
    }

    /// Sets the angles α and β in rad of Rot(a, α) Rot(b, β), with axis a fixed in the inboard and
    /// axis b in the outboard element.
    #[inline]
    pub fn set_angles(&mut self, angles: Vector2<T>) -> &mut Self {
        store(&mut self.angles, angles.into());
        self
    }

    /// Sets the rates of α and β in rad/s.
    #[inline]
    pub fn set_rates(&mut self, rates: Vector2<T>) -> &mut Self {
        store(&mut self.rates, rates.into());
        self
    }
}
