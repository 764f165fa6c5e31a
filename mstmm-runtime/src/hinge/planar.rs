//! The planar hinge: translations along two axes of the inboard frame, and a rotation about the third axis.

use nalgebra::Vector2;

use super::orientation::store;
use crate::Scalar;

/// Position, angle and their rates of a planar hinge, read from a state.
///
/// The two axes are those that follow the normal cyclically: x and y with normal z, y and z with
/// normal x, z and x with normal y. In a plane chain they are x and y.
#[doc(alias("PlanarJoint"))]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PlanarState<T> {
    position: [T; 2],
    angle: T,
    velocity: [T; 2],
    rate: T,
}

impl<T: Scalar> PlanarState<T> {
    /// Makes the view from its values.
    #[inline]
    pub fn new(position: [T; 2], angle: T, velocity: [T; 2], rate: T) -> Self {
        Self { position, angle, velocity, rate }
    }

    /// Returns the position of the outboard origin in m, along the two inboard axes, from the
    /// inboard frame's origin.
    #[inline]
    pub fn position(&self) -> Vector2<T> {
        Vector2::from(self.position)
    }

    /// Returns the angle in rad from the inboard to the outboard frame, right-handed about the normal.
    ///
    /// It is not wrapped.
    #[inline]
    pub fn angle(&self) -> T {
        self.angle
    }

    /// Returns the rate of the position in m/s, along the two inboard axes.
    #[inline]
    pub fn velocity(&self) -> Vector2<T> {
        Vector2::from(self.velocity)
    }

    /// Returns the rate of the angle in rad/s.
    #[inline]
    pub fn rate(&self) -> T {
        self.rate
    }

    /// Returns the arguments of [`new`](Self::new).
    #[doc(hidden)]
    #[inline]
    pub fn into_groups(self) -> ([T; 2], T, [T; 2], T) {
        (self.position, self.angle, self.velocity, self.rate)
    }
}

/// Position, angle and their rates of a planar hinge, for writing to a state.
///
/// The two axes are those of [`PlanarState`].
#[derive(Debug)]
pub struct PlanarStateMut<'a, T> {
    position: [&'a mut T; 2],
    angle: &'a mut T,
    velocity: [&'a mut T; 2],
    rate: &'a mut T,
}

impl<'a, T: Scalar> PlanarStateMut<'a, T> {
    /// Makes the view from references into a state; for generated code.
    #[inline]
    pub fn new(
        position: [&'a mut T; 2],
        angle: &'a mut T,
        velocity: [&'a mut T; 2],
        rate: &'a mut T,
    ) -> Self {
        Self { position, angle, velocity, rate }
    }

    /// Sets the position of the outboard origin in m, along the two inboard axes, from the
    /// inboard frame's origin.
    #[inline]
    pub fn set_position(&mut self, position: Vector2<T>) -> &mut Self {
        store(&mut self.position, position.into());
        self
    }

    /// Sets the angle in rad, right-handed about the normal.
    #[inline]
    pub fn set_angle(&mut self, angle: T) -> &mut Self {
        *self.angle = angle;
        self
    }

    /// Sets the rate of the position in m/s, along the two inboard axes.
    #[inline]
    pub fn set_velocity(&mut self, velocity: Vector2<T>) -> &mut Self {
        store(&mut self.velocity, velocity.into());
        self
    }

    /// Sets the rate of the angle in rad/s.
    #[inline]
    pub fn set_rate(&mut self, rate: T) -> &mut Self {
        *self.rate = rate;
        self
    }
}
