//! The elastic hinge of `[P, Appendix A.1]`: six degrees of freedom with springs and dampers along its coordinates.

use nalgebra::Vector3;

use super::orientation::store;
use crate::Scalar;

/// Displacement, angles and their rates of an elastic hinge, read from a state.
///
/// The intermediate frame is the inboard frame rotated by θ₃ about its z axis. The displacement and the springs are along
/// the axes of the intermediate frame. θ₃ is θ_r in the paper and may exceed 360°; θ₁ and θ₂ are small, with |θ₂| less
/// than 90°.
#[doc(alias("bushing", "LinearBushingRollPitchYaw", "beam joint"))]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ElasticState<T> {
    displacement: [T; 3],
    angles: [T; 3],
    velocity: [T; 3],
    rate: [T; 3],
}

impl<T: Scalar> ElasticState<T> {
    /// Makes the view from Δ, the angles θ₁, θ₂, θ₃, the velocity along inboard axes and
    /// the angular velocity in outboard components.
    #[inline]
    pub fn new(displacement: [T; 3], angles: [T; 3], velocity: [T; 3], rate: [T; 3]) -> Self {
        Self { displacement, angles, velocity, rate }
    }

    /// Returns the displacement Δ in m of the outboard origin from the inboard origin, in
    /// components of the intermediate frame. Along inboard axes it is A_z(θ₃) Δ.
    #[inline]
    pub fn displacement(&self) -> Vector3<T> {
        Vector3::from(self.displacement)
    }

    /// Returns the angles θ₁, θ₂ and θ₃ = θ_r in rad: A_z(θ₃) A_y(θ₂) A_x(θ₁) takes outboard components
    /// to inboard components, `[P, Eq. (1)]`. They are not wrapped.
    #[inline]
    pub fn angles(&self) -> Vector3<T> {
        Vector3::from(self.angles)
    }

    /// Returns the velocity in m/s of the outboard origin relative to the inboard frame, along inboard
    /// axes. It is not the rate of the displacement, whose axes rotate.
    #[inline]
    pub fn velocity(&self) -> Vector3<T> {
        Vector3::from(self.velocity)
    }

    /// Returns the angular velocity of the outboard relative to the inboard frame in rad/s, in outboard components. These are not the rates of the angles.
    #[inline]
    pub fn rate(&self) -> Vector3<T> {
        Vector3::from(self.rate)
    }

    /// Returns the arguments of [`new`](Self::new).
    #[doc(hidden)]
    #[inline]
    pub fn into_groups(self) -> ([T; 3], [T; 3], [T; 3], [T; 3]) {
        (self.displacement, self.angles, self.velocity, self.rate)
    }
}

/// Displacement, angles and their rates of an elastic hinge, for writing to a state.
///
/// The intermediate frame is that of [`ElasticState`].
#[derive(Debug)]
pub struct ElasticStateMut<'a, T> {
    displacement: [&'a mut T; 3],
    angles: [&'a mut T; 3],
    velocity: [&'a mut T; 3],
    rate: [&'a mut T; 3],
}

impl<'a, T: Scalar> ElasticStateMut<'a, T> {
    /// Makes the view from references into a state; for generated code.
    #[inline]
    pub fn new(
        displacement: [&'a mut T; 3],
        angles: [&'a mut T; 3],
        velocity: [&'a mut T; 3],
        rate: [&'a mut T; 3],
    ) -> Self {
        Self { displacement, angles, velocity, rate }
    }

    /// Sets the displacement Δ in m of the outboard origin from the inboard origin,
    /// in components of the intermediate frame.
    #[inline]
    pub fn set_displacement(&mut self, displacement: Vector3<T>) -> &mut Self {
        store(&mut self.displacement, displacement.into());
        self
    }

    /// Sets the angles θ₁, θ₂ and θ₃ = θ_r in rad of A_z(θ₃) A_y(θ₂) A_x(θ₁), `[P, Eq. (1)]`.
    #[inline]
    pub fn set_angles(&mut self, angles: Vector3<T>) -> &mut Self {
        store(&mut self.angles, angles.into());
        self
    }

    /// Sets the velocity in m/s of the outboard origin relative to the inboard frame, along
    /// inboard axes.
    #[inline]
    pub fn set_velocity(&mut self, velocity: Vector3<T>) -> &mut Self {
        store(&mut self.velocity, velocity.into());
        self
    }

    /// Sets the angular velocity of the outboard relative to the inboard frame in rad/s, in outboard components.
    #[inline]
    pub fn set_rate(&mut self, rate: Vector3<T>) -> &mut Self {
        store(&mut self.rate, rate.into());
        self
    }
}
