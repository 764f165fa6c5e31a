//! The motion of a point in any dimension, for code that works with any chain.

use super::columns::HasJacobian;
use super::line::LineMotion;
use super::plane::PlaneMotion;
use super::point::PointKinematics;
use super::space::SpaceMotion;
use crate::Scalar;

/// The motion of a frame on a body at `v̇ = 0`, inertial frame.
///
/// Components that a plane or line chain does not have are zero; its frames are rotated about z, or not at all.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrameMotion<T> {
    /// Position in m from the inertial origin.
    pub position: [T; 3],
    /// Rows of the rotation that takes components in the frame to inertial components.
    pub orientation: [[T; 3]; 3],
    /// Velocity in m/s.
    pub velocity: [T; 3],
    /// Angular velocity in rad/s.
    pub angular_velocity: [T; 3],
    /// Bias acceleration in m/s²: the acceleration at `v̇ = 0`.
    pub bias_acceleration: [T; 3],
    /// Angular bias acceleration in rad/s².
    pub angular_bias_acceleration: [T; 3],
}

impl<T: Scalar, const N: usize, C> From<PointKinematics<SpaceMotion<'_, T>, N, C>>
    for FrameMotion<T>
{
    fn from(point: PointKinematics<SpaceMotion<'_, T>, N, C>) -> Self {
        let orientation = point.orientation();
        let row = |row: usize| [0, 1, 2].map(|column| orientation[(row, column)]);
        FrameMotion {
            position: point.position().into(),
            orientation: [row(0), row(1), row(2)],
            velocity: point.velocity().into(),
            angular_velocity: point.angular_velocity().into(),
            bias_acceleration: point.bias_acceleration().into(),
            angular_bias_acceleration: point.angular_bias_acceleration().into(),
        }
    }
}

impl<T: Scalar, const N: usize, C> From<PointKinematics<PlaneMotion<'_, T>, N, C>>
    for FrameMotion<T>
{
    fn from(point: PointKinematics<PlaneMotion<'_, T>, N, C>) -> Self {
        let (zero, one) = (T::constant(0.0), T::constant(1.0));
        let flat = |[x, y]: [T; 2]| [x, y, zero];
        let about = |z: T| [zero, zero, z];
        let (cosine, sine) = point.cos_sin();
        FrameMotion {
            position: flat(point.position().into()),
            orientation: [[cosine, -sine, zero], [sine, cosine, zero], [zero, zero, one]],
            velocity: flat(point.velocity().into()),
            angular_velocity: about(point.angular_velocity()),
            bias_acceleration: flat(point.bias_acceleration().into()),
            angular_bias_acceleration: about(point.angular_bias_acceleration()),
        }
    }
}

impl<T: Scalar, const N: usize, C> From<PointKinematics<LineMotion<'_, T>, N, C>>
    for FrameMotion<T>
{
    fn from(point: PointKinematics<LineMotion<'_, T>, N, C>) -> Self {
        let (zero, one) = (T::constant(0.0), T::constant(1.0));
        let along = |x: T| [x, zero, zero];
        FrameMotion {
            position: along(point.position()),
            orientation: [[one, zero, zero], [zero, one, zero], [zero, zero, one]],
            velocity: along(point.velocity()),
            angular_velocity: [zero; 3],
            bias_acceleration: along(point.bias_acceleration()),
            angular_bias_acceleration: [zero; 3],
        }
    }
}

/// A point that writes its Jacobian to a slice, for generated code.
pub trait JacobianSlice<T> {
    /// Writes the Jacobian, column by column; `None` if the length of the slice is another.
    fn write_jacobian(&self, to: &mut [T]) -> Option<()>;
}

/// Implements the trait for the points of each dimension.
macro_rules! jacobians {
    ($($motion:ident)*) => { $(
        impl<T: Scalar, const N: usize, C: HasJacobian<T>> JacobianSlice<T>
            for PointKinematics<$motion<'_, T>, N, C>
        {
            fn write_jacobian(&self, to: &mut [T]) -> Option<()> {
                let matrix = self.jacobian();
                (to.len() == matrix.len()).then(|| to.copy_from_slice(matrix.as_slice()))
            }
        }
    )* };
}

jacobians! { SpaceMotion PlaneMotion LineMotion }
