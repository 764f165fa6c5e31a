//! The elastic hinge of a plane chain: three degrees of freedom with springs and dampers along its coordinates.

use nalgebra::Vector2;

use super::orientation::store;
use crate::Scalar;

/// Displacement, angle and their rates of a plane elastic hinge, read from a state.
///
/// The displacement is along the outboard axes, which are the inboard axes rotated by the angle.
#[doc(alias("bushing"))]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PlaneElasticState<T> {
    displacement: [T; 2],
    angle: T,
    velocity: [T; 2],
    rate: T,
}

impl<T: Scalar> PlaneElasticState<T> {
    /// Makes the view from Δ, the angle, the velocity along inboard axes and the angle's
    /// rate.
    #[inline]
    pub fn new(displacement: [T; 2], angle: T, velocity: [T; 2], rate: T) -> Self {
        Self { displacement, angle, velocity, rate }
    }

    /// Returns the displacement Δ in m of the outboard origin from the inboard origin, in
    /// outboard components. Along inboard axes it is A_z(θ) Δ.
    #[inline]
    pub fn displacement(&self) -> Vector2<T> {
        Vector2::from(self.displacement)
    }

    /// Returns the counter-clockwise angle θ in rad from the inboard to the outboard frame, not wrapped.
    #[inline]
    pub fn angle(&self) -> T {
        self.angle
    }

    /// Returns the velocity in m/s of the outboard origin relative to the inboard frame, along inboard
    /// axes. It is not the rate of the displacement, whose axes rotate.
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
        (self.displacement, self.angle, self.velocity, self.rate)
    }
}

/// Displacement, angle and their rates of a plane elastic hinge, for writing to a state.
#[derive(Debug)]
pub struct PlaneElasticStateMut<'a, T> {
    displacement: [&'a mut T; 2],
    angle: &'a mut T,
    velocity: [&'a mut T; 2],
    rate: &'a mut T,
}

impl<'a, T: Scalar> PlaneElasticStateMut<'a, T> {
    /// Makes the view from references into a state; for generated code.
    #[inline]
    pub fn new(
        displacement: [&'a mut T; 2],
        angle: &'a mut T,
        velocity: [&'a mut T; 2],
        rate: &'a mut T,
    ) -> Self {
        Self { displacement, angle, velocity, rate }
    }

    /// Sets the displacement Δ in m of the outboard origin from the inboard origin,
    /// in outboard components.
    #[inline]
    pub fn set_displacement(&mut self, displacement: Vector2<T>) -> &mut Self {
        store(&mut self.displacement, displacement.into());
        self
    }

    /// Sets the angle in rad, counter-clockwise.
    #[inline]
    pub fn set_angle(&mut self, angle: T) -> &mut Self {
        *self.angle = angle;
        self
    }

    /// Sets the velocity in m/s of the outboard origin relative to the inboard frame, along
    /// inboard axes.
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
