//! The ball (spherical) hinge: any rotation about a point.

use nalgebra::{UnitQuaternion, Vector3};

use super::orientation::{aligned, from_bryan_angles, store, to_array, to_unit_quaternion};
use crate::quaternion::to_unit_length;
use crate::{Error, Scalar};

/// Orientation and rate of a ball hinge, read from a state.
#[doc(alias("spherical", "BallRpyJoint", "spherical joint"))]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BallState<T> {
    orientation: [T; 4],
    rate: [T; 3],
}

impl<T: Scalar> BallState<T> {
    /// Makes the view from the quaternion's w, x, y, z and the rate.
    #[inline]
    pub fn new(orientation: [T; 4], rate: [T; 3]) -> Self {
        Self { orientation, rate }
    }

    /// Returns the rotation that takes outboard components to inboard components.
    ///
    /// With nalgebra's feature `std`, its `euler_angles()` are the Bryan angles θ₁, θ₂, θ₃ of `[P, Eq. (1)]`, which are
    /// also roll, pitch and yaw. They are not unique at θ₂ = ±90°.
    #[doc(alias("ballquat"))]
    #[inline]
    pub fn orientation(&self) -> UnitQuaternion<T> {
        to_unit_quaternion(self.orientation)
    }

    /// Returns the angular velocity of the outboard relative to the inboard frame in rad/s, in outboard components.
    #[doc(alias("ballangvel"))]
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
    pub fn into_groups(self) -> ([T; 4], [T; 3]) {
        (self.orientation, self.rate)
    }
}

/// At rest, with both frames aligned.
impl<T: Scalar> Default for BallState<T> {
    fn default() -> Self {
        Self::new(aligned(), [T::default(); 3])
    }
}

/// Orientation and rate of a ball hinge, for writing to a state.
#[derive(Debug)]
pub struct BallStateMut<'a, T> {
    /// The hinge's name, for errors.
    hinge: &'static str,
    orientation: [&'a mut T; 4],
    rate: [&'a mut T; 3],
}

impl<'a, T: Scalar> BallStateMut<'a, T> {
    /// Makes the view from references to the quaternion's w, x, y, z and of the rate; for generated code.
    #[inline]
    pub fn new(orientation: [&'a mut T; 4], rate: [&'a mut T; 3]) -> Self {
        Self { hinge: "", orientation, rate }
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

    /// Sets the angular velocity of the outboard relative to the inboard frame in rad/s, in outboard components.
    #[inline]
    pub fn set_rate(&mut self, rate: Vector3<T>) -> &mut Self {
        store(&mut self.rate, rate.into());
        self
    }
}
