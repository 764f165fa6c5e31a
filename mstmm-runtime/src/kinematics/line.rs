//! Points on a line.

use nalgebra::{SMatrix, SVector};

use super::columns::HasJacobian;
use super::point::{BodyMotion, PointKinematics};
use super::space::zeros;
use crate::Scalar;

/// The motion of a body along a line, as generated code stores it: position, velocity and bias acceleration of its input.
#[derive(Clone, Copy, Debug)]
pub struct LineMotion<'a, T>(&'a [T; 3]);

impl<'a, T> LineMotion<'a, T> {
    /// Makes the motion from its values.
    #[doc(hidden)]
    #[inline]
    pub fn new(values: &'a [T; 3]) -> Self {
        Self(values)
    }
}

impl<T: Scalar> BodyMotion for LineMotion<'_, T> {
    type Scalar = T;
    type Vector = [T; 1];
    type Rotation = ();

    #[inline]
    fn input() -> ([T; 1], ()) {
        ([T::constant(0.0)], ())
    }
}

impl<T: Scalar, const N: usize, C> PointKinematics<LineMotion<'_, T>, N, C> {
    /// Returns the position x in m from the inertial origin.
    #[inline]
    pub fn position(&self) -> T {
        let [place] = self.place;
        self.motion.0[0] + place
    }

    /// Returns the velocity ẋ in m/s, that of all points of the body.
    #[inline]
    pub fn velocity(&self) -> T {
        self.motion.0[1]
    }

    /// Returns the bias acceleration in m/s²: the acceleration ẍ at v̇ = 0, which prescribed motions cause.
    #[inline]
    pub fn bias_acceleration(&self) -> T {
        self.motion.0[2]
    }
}

impl<T: Scalar, const N: usize, C> PointKinematics<LineMotion<'_, T>, N, C> {
    /// Returns the Jacobian: one row ẋ, one column for each free rate.
    #[inline]
    pub fn jacobian(&self) -> SMatrix<T, 1, N>
    where
        C: HasJacobian<T>,
    {
        let mut matrix = zeros();
        self.jacobian_into(&mut matrix);
        matrix
    }

    /// Writes the [Jacobian](Self::jacobian).
    #[inline]
    pub fn jacobian_into(&self, matrix: &mut SMatrix<T, 1, N>)
    where
        C: HasJacobian<T>,
    {
        self.columns.rate_columns().fill(matrix, |column| column);
    }

    /// Returns J x, the velocity ẋ that the rates x cause; without the matrix.
    #[inline]
    pub fn jacobian_times(&self, rates: &SVector<T, N>) -> T
    where
        C: HasJacobian<T>,
    {
        let [velocity] = self.columns.rate_columns().times(rates);
        velocity
    }

    /// Returns Jᵀ times a force in N: the efforts along all rates that have the same power. Without the matrix.
    #[doc(alias("external force", "static forces"))]
    #[inline]
    pub fn jacobian_transpose_times(&self, force: T) -> SVector<T, N>
    where
        C: HasJacobian<T>,
    {
        let mut efforts = zeros();
        self.jacobian_transpose_times_into(force, &mut efforts);
        efforts
    }

    /// Writes the product that [`jacobian_transpose_times`](Self::jacobian_transpose_times) returns.
    #[inline]
    pub fn jacobian_transpose_times_into(&self, force: T, efforts: &mut SVector<T, N>)
    where
        C: HasJacobian<T>,
    {
        self.columns.rate_columns().transpose_times([force], efforts);
    }

    /// Returns the acceleration ẍ in m/s² for given accelerations v̇ of the free rates: J v̇ plus the bias
    /// acceleration.
    #[inline]
    pub fn acceleration(&self, accelerations: &SVector<T, N>) -> T
    where
        C: HasJacobian<T>,
    {
        self.jacobian_times(accelerations) + self.bias_acceleration()
    }
}
