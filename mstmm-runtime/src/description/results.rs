//! Results in a workspace, for code that works with any chain.

use super::Dimension;
use crate::{Energy, LinePoint, PlanePoint, Point, Results, Scalar, SpringResult};

/// The results at a connection point of a chain in any dimension, inertial frame.
///
/// Components that a plane or line chain does not have are zero; its frames are rotated about z, or not at all. A result
/// that the chain's setting `results` omits is `None`. [`Point`] defines the signs.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PointResult<T> {
    /// Position in m from the inertial origin.
    pub position: Option<[T; 3]>,
    /// Rows of the rotation that takes components in the point's frame to inertial components.
    pub orientation: Option<[[T; 3]; 3]>,
    /// Velocity in m/s.
    pub velocity: Option<[T; 3]>,
    /// Angular velocity in rad/s.
    pub angular_velocity: Option<[T; 3]>,
    /// Acceleration in m/s².
    pub acceleration: Option<[T; 3]>,
    /// Angular acceleration in rad/s².
    pub angular_acceleration: Option<[T; 3]>,
    /// Internal moment in N·m, which acts on the inboard element.
    pub moment: Option<[T; 3]>,
    /// Internal force in N, which acts on the outboard element.
    pub force: Option<[T; 3]>,
}

/// The arrays of a workspace, for generated code.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Arrays<'a, T> {
    /// Accelerations of the rates of the state.
    pub accelerations: &'a [T],
    /// Efforts of all rates.
    pub efforts: &'a [T],
    /// The energies, if they are computed.
    pub energy: Option<Energy<T>>,
    /// The results of all springs; empty if they are not computed.
    pub springs: &'a [T],
    /// The acceleration of the inertial frame that would have the effect of gravity.
    pub base_acceleration: &'a [T],
}

/// Returns the number of stored values of a spring.
pub(super) const fn spring_len(dimension: Dimension) -> usize {
    match dimension {
        Dimension::Space => 6,
        Dimension::Plane => 5,
        Dimension::Line => 4,
    }
}

/// Returns the result of a spring from its stored values.
pub(super) fn spring<T: Scalar>(values: &[T]) -> Option<SpringResult<T, [T; 3]>> {
    let (&[length, rate, tension], components) = values.split_first_chunk()?;
    let mut force = [T::default(); 3];
    for (entry, component) in force.iter_mut().zip(components) {
        *entry = *component;
    }
    Some(SpringResult::new(length, rate, tension, force))
}

impl<T: Scalar, const POSES: bool, const VELOCITIES: bool, const Z: bool>
    From<Point<T, Results<POSES, VELOCITIES, Z>>> for PointResult<T>
{
    fn from(point: Point<T, Results<POSES, VELOCITIES, Z>>) -> Self {
        let z = point.z;
        PointResult {
            position: POSES.then_some(point.position),
            orientation: POSES.then_some(point.rotation),
            velocity: VELOCITIES.then_some(point.velocity),
            angular_velocity: VELOCITIES.then_some(point.angular_velocity),
            acceleration: Z.then(|| z.acceleration().into()),
            angular_acceleration: Z.then(|| z.angular_acceleration().into()),
            moment: Z.then(|| z.moment().into()),
            force: Z.then(|| z.force().into()),
        }
    }
}

impl<T: Scalar, const POSES: bool, const VELOCITIES: bool, const Z: bool>
    From<PlanePoint<T, Results<POSES, VELOCITIES, Z>>> for PointResult<T>
{
    fn from(point: PlanePoint<T, Results<POSES, VELOCITIES, Z>>) -> Self {
        let (zero, one) = (T::constant(0.0), T::constant(1.0));
        let flat = |[x, y]: [T; 2]| [x, y, zero];
        let about = |z: T| [zero, zero, z];
        let ([cosine, sine], z) = (point.cos_sin, point.z);
        let rows = [[cosine, -sine, zero], [sine, cosine, zero], [zero, zero, one]];
        PointResult {
            position: POSES.then_some(flat(point.position)),
            orientation: POSES.then_some(rows),
            velocity: VELOCITIES.then_some(flat(point.velocity)),
            angular_velocity: VELOCITIES.then_some(about(point.angular_velocity)),
            acceleration: Z.then(|| flat(z.acceleration().into())),
            angular_acceleration: Z.then(|| about(z.angular_acceleration())),
            moment: Z.then(|| about(z.moment())),
            force: Z.then(|| flat(z.force().into())),
        }
    }
}

impl<T: Scalar, const POSES: bool, const VELOCITIES: bool, const Z: bool>
    From<LinePoint<T, Results<POSES, VELOCITIES, Z>>> for PointResult<T>
{
    fn from(point: LinePoint<T, Results<POSES, VELOCITIES, Z>>) -> Self {
        let (zero, one) = (T::constant(0.0), T::constant(1.0));
        let along = |x: T| [x, zero, zero];
        let rows = [[one, zero, zero], [zero, one, zero], [zero, zero, one]];
        PointResult {
            position: POSES.then_some(along(point.position)),
            orientation: POSES.then_some(rows),
            velocity: VELOCITIES.then_some(along(point.velocity)),
            angular_velocity: VELOCITIES.then_some([zero; 3]),
            acceleration: Z.then(|| along(point.z.acceleration())),
            angular_acceleration: Z.then_some([zero; 3]),
            moment: Z.then_some([zero; 3]),
            force: Z.then(|| along(point.z.force())),
        }
    }
}
