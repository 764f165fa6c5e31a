//! The universal hinge: two turns one after the other, about an axis fixed in the inboard element
//! and about one fixed in the outboard element.

use nalgebra::Vector2;

use super::orientation::store;
use crate::Scalar;

/// Angles and rates of a universal hinge, copied from a state.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct UniversalState<T> {
    angles: [T; 2],
    rates: [T; 2],
}

impl<T: Scalar> UniversalState<T> {
    /// Puts the view together from α, β and their rates.
    #[inline]
    pub fn new(angles: [T; 2], rates: [T; 2]) -> Self {
        Self { angles, rates }
    }

    /// The angles α and β in rad: the outboard frame is turned against the inboard one by Rot(a, α)
    /// Rot(b, β), with axis a fixed in the inboard and axis b in the outboard element. They are not
    /// wrapped.
    #[inline]
    pub fn angles(&self) -> Vector2<T> {
        Vector2::from(self.angles)
    }

    /// The rates of α and β in rad/s.
    #[inline]
    pub fn rates(&self) -> Vector2<T> {
        Vector2::from(self.rates)
    }

    /// What [`new`](Self::new) was given.
    #[doc(hidden)]
    #[inline]
    pub fn into_groups(self) -> ([T; 2], [T; 2]) {
        (self.angles, self.rates)
    }
}

/// Angles and rates of a universal hinge, to be changed in a state.
#[derive(Debug)]
pub struct UniversalStateMut<'a, T> {
    angles: [&'a mut T; 2],
    rates: [&'a mut T; 2],
}

impl<'a, T: Scalar> UniversalStateMut<'a, T> {
    /// Puts the view together from the places of α, β and of their rates; generated code does.
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
