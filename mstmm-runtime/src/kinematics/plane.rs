//! Points in the plane.

use nalgebra::{Rotation2, SMatrix, SVector, Vector2, Vector3};

use super::columns::HasJacobian;
use super::point::{BodyMotion, PointKinematics};
use super::space::{sum, zeros};
use crate::Scalar;

/// The motion of a body in the plane, as generated code stores it.
///
/// The values are those of the body's input: position, cosine and sine of the angle, velocity, angular velocity, bias
/// acceleration and angular bias acceleration, inertial frame.
#[derive(Clone, Copy, Debug)]
pub struct PlaneMotion<'a, T>(&'a [T; 10]);

impl<'a, T> PlaneMotion<'a, T> {
    /// Makes the motion from its values.
    #[doc(hidden)]
    #[inline]
    pub fn new(values: &'a [T; 10]) -> Self {
        Self(values)
    }
}

impl<T: Scalar> BodyMotion for PlaneMotion<'_, T> {
    type Scalar = T;
    type Vector = [T; 2];
    type Rotation = [T; 2];

    #[inline]
    fn input() -> ([T; 2], [T; 2]) {
        ([T::constant(0.0); 2], [T::constant(1.0), T::constant(0.0)])
    }
}

impl<T: Scalar, const N: usize, C> PointKinematics<PlaneMotion<'_, T>, N, C> {
    /// Returns the vector from the input of the body to the point, inertial frame.
    #[inline(always)]
    fn arm(&self) -> [T; 2] {
        rotated(self.motion.cos_sin(), self.place)
    }

    #[inline(always)]
    fn position_array(&self) -> [T; 2] {
        let [x, y, ..] = *self.motion.0;
        sum([x, y], self.arm())
    }

    /// Returns the position r in m from the inertial origin.
    #[inline]
    pub fn position(&self) -> Vector2<T> {
        Vector2::from(self.position_array())
    }

    /// Returns the rotation A that takes components in the frame of the point to inertial components.
    ///
    /// The frames of an output and of a named point are those of the description. All other points have the frame of the
    /// body.
    #[inline]
    pub fn orientation(&self) -> Rotation2<T> {
        let (cosine, sine) = self.cos_sin();
        let matrix = nalgebra::Matrix2::new(cosine, -sine, sine, cosine);
        Rotation2::from_matrix_unchecked(matrix)
    }

    /// Returns cosine and sine of the counter-clockwise angle from the inertial frame to the frame of the point.
    #[inline]
    pub fn cos_sin(&self) -> (T, T) {
        let [cosine, sine] = rotated(self.motion.cos_sin(), self.rotation);
        (cosine, sine)
    }

    /// Returns the velocity ṙ in m/s.
    #[inline]
    pub fn velocity(&self) -> Vector2<T> {
        let [_, _, _, _, x, y, omega, ..] = *self.motion.0;
        Vector2::from(sum([x, y], turning(omega, self.arm())))
    }

    /// Returns the angular velocity Ω_z of the body in rad/s.
    #[inline]
    pub fn angular_velocity(&self) -> T {
        self.motion.0[6]
    }

    /// Returns the bias acceleration in m/s²: the acceleration r̈ of the point at v̇ = 0.
    ///
    /// It is J̇ v plus the accelerations that prescribed motions cause. Gravity is not part of it.
    #[doc(alias("Jdot v", "Jdot qdot", "drift", "CalcBiasTranslationalAcceleration"))]
    #[inline]
    pub fn bias_acceleration(&self) -> Vector2<T> {
        let [.., omega, x, y, alpha] = *self.motion.0;
        let arm = self.arm();
        let centripetal = arm.map(|entry| -(omega * omega * entry));
        Vector2::from(sum([x, y], sum(turning(alpha, arm), centripetal)))
    }

    /// Returns the angular bias acceleration in rad/s²: the angular acceleration Ω̇_z of the body at v̇ = 0.
    #[inline]
    pub fn angular_bias_acceleration(&self) -> T {
        self.motion.0[9]
    }
}

impl<T: Scalar, const N: usize, C> PointKinematics<PlaneMotion<'_, T>, N, C> {
    /// Returns the Jacobian: rows ẋ, ẏ and Ω_z in the inertial frame; one column for each free rate.
    #[doc(alias("getFrameJacobian", "computeFrameJacobian", "geometric Jacobian"))]
    #[inline]
    pub fn jacobian(&self) -> SMatrix<T, 3, N>
    where
        C: HasJacobian<T>,
    {
        let mut matrix = zeros();
        self.jacobian_into(&mut matrix);
        matrix
    }

    /// Writes the [Jacobian](Self::jacobian).
    #[inline]
    pub fn jacobian_into(&self, matrix: &mut SMatrix<T, 3, N>)
    where
        C: HasJacobian<T>,
    {
        let [x, y] = self.position_array();
        self.columns.rate_columns().fill(matrix, |[vx, vy, omega]| {
            [omega.mul_neg_add(y, vx), omega.mul_add(x, vy), omega]
        });
    }

    /// Returns J x, the velocity ẋ, ẏ, then the angular velocity Ω_z, that the rates x cause; without the matrix.
    #[inline]
    pub fn jacobian_times(&self, rates: &SVector<T, N>) -> Vector3<T>
    where
        C: HasJacobian<T>,
    {
        let [vx, vy, omega] = self.columns.rate_columns().times(rates);
        let [x, y] = sum([vx, vy], turning(omega, self.position_array()));
        Vector3::from([x, y, omega])
    }

    /// Returns Jᵀ times a force in N at the point, inertial frame, and a moment in N·m: the efforts along all rates
    /// that have the same power. Without the matrix.
    #[doc(alias("mj_applyFT", "external force", "static forces"))]
    #[inline]
    pub fn jacobian_transpose_times(&self, force: Vector2<T>, moment: T) -> SVector<T, N>
    where
        C: HasJacobian<T>,
    {
        let mut efforts = zeros();
        self.jacobian_transpose_times_into(force, moment, &mut efforts);
        efforts
    }

    /// Writes the product that [`jacobian_transpose_times`](Self::jacobian_transpose_times) returns.
    #[inline]
    pub fn jacobian_transpose_times_into(
        &self,
        force: Vector2<T>,
        moment: T,
        efforts: &mut SVector<T, N>,
    ) where
        C: HasJacobian<T>,
    {
        let ([x, y], [fx, fy]) = (self.position_array(), force.into());
        let about_origin = y.mul_neg_add(fx, x.mul_add(fy, moment));
        self.columns.rate_columns().transpose_times([fx, fy, about_origin], efforts);
    }

    /// Returns the acceleration r̈ in m/s² for given accelerations v̇ of the free rates: J v̇ plus the bias
    /// acceleration.
    #[inline]
    pub fn acceleration(&self, accelerations: &SVector<T, N>) -> Vector2<T>
    where
        C: HasJacobian<T>,
    {
        let [x, y, _]: [T; 3] = self.jacobian_times(accelerations).into();
        Vector2::from(sum([x, y], self.bias_acceleration().into()))
    }

    /// Returns the angular acceleration Ω̇_z in rad/s² for given accelerations v̇ of the free rates.
    #[inline]
    pub fn angular_acceleration(&self, accelerations: &SVector<T, N>) -> T
    where
        C: HasJacobian<T>,
    {
        let [_, _, angular]: [T; 3] = self.columns.rate_columns().times(accelerations);
        angular + self.motion.0[9]
    }
}

impl<T: Scalar> PlaneMotion<'_, T> {
    #[inline(always)]
    fn cos_sin(&self) -> [T; 2] {
        [self.0[2], self.0[3]]
    }
}

/// Returns a vector rotated by an angle with this cosine and sine.
#[inline(always)]
fn rotated<T: Scalar>([cosine, sine]: [T; 2], [x, y]: [T; 2]) -> [T; 2] {
    [cosine.mul_add(x, -(sine * y)), sine.mul_add(x, cosine * y)]
}

/// Returns the velocity at `arm` of a rotation about the origin.
#[inline(always)]
fn turning<T: Scalar>(omega: T, [x, y]: [T; 2]) -> [T; 2] {
    [-(omega * y), omega * x]
}
