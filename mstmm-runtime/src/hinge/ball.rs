//! The ball hinge: any rotation about a point.

use nalgebra::{UnitQuaternion, Vector3};

use super::orientation::{aligned, from_bryan_angles, store, to_array, to_unit_quaternion};
use crate::quaternion::to_unit_length;
use crate::{Error, Scalar};

/// Orientation and rate of a ball hinge, copied from a state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BallState<T> {
    orientation: [T; 4],
    rate: [T; 3],
}

impl<T: Scalar> BallState<T> {
    /// Puts the view together from the quaternion's w, x, y, z and the rate.
    #[inline]
    pub fn new(orientation: [T; 4], rate: [T; 3]) -> Self {
        Self { orientation, rate }
    }

    /// The rotation that turns outboard components into inboard components.
    ///
    /// With nalgebra's feature `std` its `euler_angles()` are the Bryan angles θ₁, θ₂, θ₃ of `[P,
    /// Eq. (1)]` in this order, which is also roll, pitch and yaw. They are not unique at θ₂ =
    /// ±90°.
    #[inline]
    pub fn orientation(&self) -> UnitQuaternion<T> {
        to_unit_quaternion(self.orientation)
    }

    /// The angular velocity of the outboard frame against the inboard one, in rad/s, in outboard
    /// components.
    #[inline]
    pub fn rate(&self) -> Vector3<T> {
        Vector3::from(self.rate)
    }

    /// The orientation as the state has it: w, x, y, z.
    #[doc(hidden)]
    #[inline]
    pub fn quaternion(&self) -> [T; 4] {
        self.orientation
    }

    /// What [`new`](Self::new) was given.
    #[doc(hidden)]
    #[inline]
    pub fn into_groups(self) -> ([T; 4], [T; 3]) {
        (self.orientation, self.rate)
    }
}

/// At rest, both frames aligned.
impl<T: Scalar> Default for BallState<T> {
    fn default() -> Self {
        Self::new(aligned(), [T::default(); 3])
    }
}

/// Orientation and rate of a ball hinge, to be changed in a state.
#[derive(Debug)]
pub struct BallStateMut<'a, T> {
    /// The hinge's name, for errors.
    hinge: &'static str,
    orientation: [&'a mut T; 4],
    rate: [&'a mut T; 3],
}

impl<'a, T: Scalar> BallStateMut<'a, T> {
    /// Puts the view together from the places of the quaternion's w, x, y, z and of the rate;
    /// generated code does.
    #[inline]
    pub fn new(orientation: [&'a mut T; 4], rate: [&'a mut T; 3]) -> Self {
        Self { hinge: "", orientation, rate }
    }

    /// Gives the view the name of its hinge.
    #[doc(hidden)]
    #[inline]
    pub fn named(self, hinge: &'static str) -> Self {
        Self { hinge, ..self }
    }

    /// Sets the rotation that turns outboard components into inboard components.
    ///
    /// The type says that its length is one, so the components are stored unchanged. Those of a
    /// quaternion made by `new_unchecked` are checked where the state is used, see
    /// [`Error::InvalidQuaternion`]; [`set_quaternion`](Self::set_quaternion) checks at once.
    #[inline]
    pub fn set_orientation(&mut self, orientation: UnitQuaternion<T>) -> &mut Self {
        store(&mut self.orientation, to_array(orientation));
        self
    }

    /// Sets the rotation that turns outboard components into inboard components by the components
    /// w, x, y, z of a quaternion, which is brought to unit length.
    ///
    /// # Errors
    /// [`Error::InvalidQuaternion`] if the length is not between 0.9 and 1.1, [`Error::NotFinite`] if a
    /// component is not finite. The orientation set before is kept.
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

    /// Sets the angular velocity of the outboard frame against the inboard one, in rad/s, in
    /// outboard components.
    #[inline]
    pub fn set_rate(&mut self, rate: Vector3<T>) -> &mut Self {
        store(&mut self.rate, rate.into());
        self
    }
}
