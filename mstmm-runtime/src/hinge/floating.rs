//! The floating hinge (free flyer), which leaves all six degrees of freedom: the "acceleration hinge" of
//! `[P, Section 3]`.

use nalgebra::{UnitQuaternion, Vector3};

use super::orientation::{aligned, from_bryan_angles, store, to_array, to_unit_quaternion};
use crate::quaternion::to_unit_length;
use crate::{Error, Scalar};

/// Position, orientation and their rates of a floating hinge, read from a state.
#[doc(alias("free flyer", "freejoint", "6-dof joint", "QuaternionFloatingJoint", "floating base"))]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FloatingState<T> {
    position: [T; 3],
    orientation: [T; 4],
    velocity: [T; 3],
    rate: [T; 3],
}

impl<T: Scalar> FloatingState<T> {
    /// Makes the view from its values; the orientation is the quaternion w, x, y, z.
    #[inline]
    pub fn new(position: [T; 3], orientation: [T; 4], velocity: [T; 3], rate: [T; 3]) -> Self {
        Self { position, orientation, velocity, rate }
    }

    /// Returns the position of the outboard origin in m, along inboard axes, from the inboard
    /// origin.
    #[inline]
    pub fn position(&self) -> Vector3<T> {
        Vector3::from(self.position)
    }

    /// Returns the rotation that takes outboard components to inboard components.
    ///
    /// With nalgebra's feature `std`, its `euler_angles()` are the Bryan angles θ₁, θ₂, θ₃ of `[P, Eq. (1)]`, which are
    /// also roll, pitch and yaw. They are not unique at θ₂ = ±90°.
    #[inline]
    pub fn orientation(&self) -> UnitQuaternion<T> {
        to_unit_quaternion(self.orientation)
    }

    /// Returns the rate of the position in m/s, along inboard axes.
    #[inline]
    pub fn velocity(&self) -> Vector3<T> {
        Vector3::from(self.velocity)
    }

    /// Returns the angular velocity of the outboard relative to the inboard frame in rad/s, in outboard components.
    #[inline]
    pub fn rate(&self) -> Vector3<T> {
        Vector3::from(self.rate)
    }

    /// Returns the orientation as a quaternion w, x, y, z.
    #[doc(hidden)]
    #[inline]
    pub fn quaternion(&self) -> [T; 4] {
        self.orientation
    }

    /// Returns the arguments of [`new`](Self::new).
    #[doc(hidden)]
    #[inline]
    pub fn into_groups(self) -> ([T; 3], [T; 4], [T; 3], [T; 3]) {
        (self.position, self.orientation, self.velocity, self.rate)
    }
}

/// At rest, with coincident frames.
impl<T: Scalar> Default for FloatingState<T> {
    fn default() -> Self {
        let zero = [T::default(); 3];
        Self::new(zero, aligned(), zero, zero)
    }
}

/// Position, orientation and their rates of a floating hinge, for writing to a state.
#[derive(Debug)]
pub struct FloatingStateMut<'a, T> {
    /// The hinge's name, for errors.
    hinge: &'static str,
    position: [&'a mut T; 3],
    orientation: [&'a mut T; 4],
    velocity: [&'a mut T; 3],
    rate: [&'a mut T; 3],
}

impl<'a, T: Scalar> FloatingStateMut<'a, T> {
    /// Makes the view from references into a state, with the quaternion w, x, y, z; for generated code.
    #[inline]
    pub fn new(
        position: [&'a mut T; 3],
        orientation: [&'a mut T; 4],
        velocity: [&'a mut T; 3],
        rate: [&'a mut T; 3],
    ) -> Self {
        Self { hinge: "", position, orientation, velocity, rate }
    }

    /// Sets the position of the outboard origin in m, along inboard axes, from the inboard
    /// origin.
    #[doc(alias("SetFreeBodyPose", "free body pose"))]
    #[inline]
    pub fn set_position(&mut self, position: Vector3<T>) -> &mut Self {
        store(&mut self.position, position.into());
        self
    }

    /// Sets the name of the hinge, for errors.
    #[doc(hidden)]
    #[inline]
    pub fn named(self, hinge: &'static str) -> Self {
        Self { hinge, ..self }
    }

    /// Sets the rotation that takes outboard components to inboard components.
    ///
    /// The type guarantees unit length, so the components are stored unchanged. A quaternion made by `new_unchecked` is
    /// checked when the state is used, see
    /// [`Error::InvalidQuaternion`]; [`set_quaternion`](Self::set_quaternion) checks at once.
    #[doc(alias("SetFreeBodyPose"))]
    #[inline]
    pub fn set_orientation(&mut self, orientation: UnitQuaternion<T>) -> &mut Self {
        store(&mut self.orientation, to_array(orientation));
        self
    }

    /// Sets the rotation that takes outboard components to inboard components by the components
    /// w, x, y, z of a quaternion, which is normalised.
    ///
    /// # Errors
    /// [`Error::InvalidQuaternion`] if the length is not between 0.9 and 1.1, [`Error::NotFinite`] if a
    /// component is not finite. The previous orientation is kept.
    #[inline]
    pub fn set_quaternion(&mut self, quaternion: [T; 4]) -> Result<&mut Self, Error> {
        store(&mut self.orientation, to_unit_length(self.hinge, quaternion)?);
        Ok(self)
    }

    /// Sets the rotation A = A_z(θ₃) A_y(θ₂) A_x(θ₁) by Bryan angles in rad, `[P, Eq. (1)]`; these
    /// are also roll, pitch and yaw.
    #[inline]
    pub fn set_bryan_angles(&mut self, angles: [T; 3]) -> &mut Self {
        store(&mut self.orientation, from_bryan_angles(angles));
        self
    }

    /// Sets the rate of the position in m/s, along inboard axes.
    #[doc(alias("SetFreeBodySpatialVelocity"))]
    #[inline]
    pub fn set_velocity(&mut self, velocity: Vector3<T>) -> &mut Self {
        store(&mut self.velocity, velocity.into());
        self
    }

    /// Sets the angular velocity of the outboard relative to the inboard frame in rad/s, in outboard components.
    #[doc(alias("SetFreeBodySpatialVelocity"))]
    #[inline]
    pub fn set_rate(&mut self, rate: Vector3<T>) -> &mut Self {
        store(&mut self.rate, rate.into());
        self
    }
}
