//! Points in space.

use nalgebra::{Matrix3, Rotation3, SMatrix, SVector, Vector3, Vector6};

use super::columns::HasJacobian;
use super::point::{BodyMotion, PointKinematics};
use crate::Scalar;

/// The motion of a body in space, as generated code stores it.
///
/// The values are those of the body's input: position, rows of the rotation matrix, velocity, angular velocity, bias
/// acceleration and angular bias acceleration, inertial frame.
#[derive(Clone, Copy, Debug)]
pub struct SpaceMotion<'a, T>(&'a [T; 24]);

impl<'a, T> SpaceMotion<'a, T> {
    /// Makes the motion from its values.
    #[doc(hidden)]
    #[inline]
    pub fn new(values: &'a [T; 24]) -> Self {
        Self(values)
    }
}

impl<T: Scalar> BodyMotion for SpaceMotion<'_, T> {
    type Scalar = T;
    type Vector = [T; 3];
    type Rotation = [[T; 3]; 3];

    #[inline]
    fn input() -> ([T; 3], [[T; 3]; 3]) {
        let (zero, one) = (T::constant(0.0), T::constant(1.0));
        ([zero; 3], [[one, zero, zero], [zero, one, zero], [zero, zero, one]])
    }
}

impl<T: Scalar> SpaceMotion<'_, T> {
    #[inline(always)]
    fn vector<const FIRST: usize>(&self) -> [T; 3] {
        const { assert!(FIRST + 3 <= 24) };
        [self.0[FIRST], self.0[FIRST + 1], self.0[FIRST + 2]]
    }

    #[inline(always)]
    fn rotation(&self) -> [[T; 3]; 3] {
        [self.vector::<3>(), self.vector::<6>(), self.vector::<9>()]
    }

    #[inline(always)]
    fn omega(&self) -> [T; 3] {
        self.vector::<15>()
    }
}

impl<T: Scalar, const N: usize, C> PointKinematics<SpaceMotion<'_, T>, N, C> {
    /// Returns the vector from the input of the body to the point, inertial frame.
    #[inline(always)]
    fn arm(&self) -> [T; 3] {
        let [x, y, z] = self.place;
        self.motion.rotation().map(|[a, b, c]| a.mul_add(x, b.mul_add(y, c * z)))
    }

    #[inline(always)]
    fn position_array(&self) -> [T; 3] {
        sum(self.motion.vector::<0>(), self.arm())
    }

    /// Returns the position r in m from the inertial origin.
    #[doc(alias("framePlacement", "CalcPointsPositions", "site_xpos", "xpos"))]
    #[doc(alias("CalcPoseInWorld", "EvalBodyPoseInWorld"))]
    #[doc(alias("oMf", "oMi", "framepos", "mj_local2Global"))]
    #[inline]
    pub fn position(&self) -> Vector3<T> {
        Vector3::from(self.position_array())
    }

    /// Returns the rotation A that takes components in the frame of the point to inertial components.
    ///
    /// The frames of an output and of a named point are those of the description. All other points have the frame of the
    /// body.
    #[doc(alias("site_xmat", "xmat"))]
    #[doc(alias("oMf", "oMi", "xquat", "framequat", "framexaxis"))]
    #[doc(alias("CalcRelativeTransform", "CalcRelativeRotationMatrix"))]
    #[inline]
    pub fn orientation(&self) -> Rotation3<T> {
        let turned = self.rotation;
        let row = |[a, b, c]: [T; 3]| {
            [0, 1, 2]
                .map(|k: usize| a.mul_add(turned[0][k], b.mul_add(turned[1][k], c * turned[2][k])))
        };
        let [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]] = self.motion.rotation().map(row);
        Rotation3::from_matrix_unchecked(Matrix3::new(xx, xy, xz, yx, yy, yz, zx, zy, zz))
    }

    /// Returns the velocity ṙ in m/s.
    #[doc(alias("getFrameVelocity", "CalcSpatialVelocity", "mj_objectVelocity"))]
    #[doc(alias("EvalBodySpatialVelocityInWorld", "cvel", "framelinvel"))]
    #[inline]
    pub fn velocity(&self) -> Vector3<T> {
        let relative = cross(self.motion.omega(), self.arm());
        Vector3::from(sum(self.motion.vector::<12>(), relative))
    }

    /// Returns the angular velocity Ω of the body in rad/s.
    #[doc(alias("CalcSpatialVelocity", "cvel", "frameangvel"))]
    #[inline]
    pub fn angular_velocity(&self) -> Vector3<T> {
        Vector3::from(self.motion.omega())
    }

    /// Returns the bias acceleration in m/s²: the acceleration r̈ of the point at v̇ = 0.
    ///
    /// It is J̇ v plus the accelerations that prescribed motions cause. Gravity is not part of it.
    #[doc(alias(
        "Jdot v",
        "Jdot qdot",
        "drift",
        "CalcBiasSpatialAcceleration",
        "getFrameClassicalAcceleration",
        "mj_jacDot"
    ))]
    #[inline]
    pub fn bias_acceleration(&self) -> Vector3<T> {
        let (arm, omega) = (self.arm(), self.motion.omega());
        let tangential = cross(self.motion.vector::<21>(), arm);
        let centripetal = cross(omega, cross(omega, arm));
        Vector3::from(sum(self.motion.vector::<18>(), sum(tangential, centripetal)))
    }

    /// Returns the angular bias acceleration in rad/s²: the angular acceleration Ω̇ of the body at v̇ = 0.
    #[inline]
    pub fn angular_bias_acceleration(&self) -> Vector3<T> {
        Vector3::from(self.motion.vector::<21>())
    }
}

impl<T: Scalar, const N: usize, C> PointKinematics<SpaceMotion<'_, T>, N, C> {
    /// Returns the Jacobian: rows ṙ, then Ω, both in the inertial frame; one column for each free rate.
    #[doc(alias(
        "getFrameJacobian",
        "computeFrameJacobian",
        "computeJointJacobian",
        "getJointJacobian",
        "CalcJacobianSpatialVelocity",
        "mj_jac",
        "mj_jacBody",
        "mj_jacSite",
        "geometric Jacobian"
    ))]
    #[inline]
    pub fn jacobian(&self) -> SMatrix<T, 6, N>
    where
        C: HasJacobian<T>,
    {
        let mut matrix = zeros();
        self.jacobian_into(&mut matrix);
        matrix
    }

    /// Writes the [Jacobian](Self::jacobian).
    #[inline]
    pub fn jacobian_into(&self, matrix: &mut SMatrix<T, 6, N>)
    where
        C: HasJacobian<T>,
    {
        let [x, y, z] = self.position_array();
        self.columns.rate_columns().fill(matrix, |[vx, vy, vz, wx, wy, wz]| {
            [
                wz.mul_neg_add(y, wy.mul_add(z, vx)),
                wx.mul_neg_add(z, wz.mul_add(x, vy)),
                wy.mul_neg_add(x, wx.mul_add(y, vz)),
                wx,
                wy,
                wz,
            ]
        });
    }

    /// Returns J x, the velocity ṙ, then the angular velocity Ω, that the rates x cause; without the matrix.
    #[doc(alias("mj_mulJacVec", "Jacobian-vector product"))]
    #[inline]
    pub fn jacobian_times(&self, rates: &SVector<T, N>) -> Vector6<T>
    where
        C: HasJacobian<T>,
    {
        let [vx, vy, vz, wx, wy, wz] = self.columns.rate_columns().times(rates);
        let [x, y, z] = sum([vx, vy, vz], cross([wx, wy, wz], self.position_array()));
        Vector6::from([x, y, z, wx, wy, wz])
    }

    /// Returns Jᵀ times a force in N at the point and a moment in N·m, inertial frame: the efforts along all rates
    /// that have the same power. Without the matrix.
    #[doc(alias("mj_applyFT", "external force", "static forces"))]
    #[doc(alias("mj_mulJacTVec", "CalcGeneralizedForces", "Jacobian transpose"))]
    #[inline]
    pub fn jacobian_transpose_times(&self, force: Vector3<T>, moment: Vector3<T>) -> SVector<T, N>
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
        force: Vector3<T>,
        moment: Vector3<T>,
        efforts: &mut SVector<T, N>,
    ) where
        C: HasJacobian<T>,
    {
        let force: [T; 3] = force.into();
        let [mx, my, mz] = sum(moment.into(), cross(self.position_array(), force));
        let [fx, fy, fz] = force;
        self.columns.rate_columns().transpose_times([fx, fy, fz, mx, my, mz], efforts);
    }

    /// Returns the acceleration r̈ in m/s² for given accelerations v̇ of the free rates: J v̇ plus the bias
    /// acceleration.
    ///
    /// The linear part of a spatial acceleration is r̈ − Ω × ṙ instead.
    #[doc(alias("getFrameClassicalAcceleration", "getFrameAcceleration", "mj_objectAcceleration"))]
    #[doc(alias("CalcSpatialAccelerationsFromVdot"))]
    #[doc(alias("EvalBodySpatialAccelerationInWorld", "cacc", "framelinacc"))]
    #[inline]
    pub fn acceleration(&self, accelerations: &SVector<T, N>) -> Vector3<T>
    where
        C: HasJacobian<T>,
    {
        let [x, y, z, ..]: [T; 6] = self.jacobian_times(accelerations).into();
        Vector3::from(sum([x, y, z], self.bias_acceleration().into()))
    }

    /// Returns the angular acceleration Ω̇ in rad/s² for given accelerations v̇ of the free rates.
    #[doc(alias("cacc", "frameangacc"))]
    #[inline]
    pub fn angular_acceleration(&self, accelerations: &SVector<T, N>) -> Vector3<T>
    where
        C: HasJacobian<T>,
    {
        let [.., x, y, z]: [T; 6] = self.columns.rate_columns().times(accelerations);
        Vector3::from(sum([x, y, z], self.motion.vector::<21>()))
    }
}

/// Returns a matrix of zeros.
#[inline(always)]
pub(super) fn zeros<T: Scalar, const R: usize, const C: usize>() -> SMatrix<T, R, C> {
    SMatrix::from_array_storage(nalgebra::ArrayStorage([[T::constant(0.0); R]; C]))
}

#[inline(always)]
pub(super) fn sum<T: Scalar, const K: usize>(mut a: [T; K], b: [T; K]) -> [T; K] {
    for (entry, other) in a.iter_mut().zip(b) {
        *entry += other;
    }
    a
}

/// Returns the cross product.
#[inline(always)]
fn cross<T: Scalar>([a, b, c]: [T; 3], [x, y, z]: [T; 3]) -> [T; 3] {
    [b.mul_add(z, -(c * y)), c.mul_add(x, -(a * z)), a.mul_add(y, -(b * x))]
}
