//! Motion and internal loads at a connection point of a plane chain.

use core::fmt;
use core::marker::PhantomData;
use core::slice::from_ref;

use nalgebra::{Matrix2, Rotation2, SVector, Vector2};

use super::results::{AllResults, HasPoses, HasVelocities, HasZ, Results, show};
use super::rows::{Group, PointRow};
use super::slots::{PointSlots, difference, vector_at};
use crate::Scalar;

/// The state vector z at a connection point of a plane chain, inertial frame.
///
/// It has the entries of [`StateVector`](crate::StateVector) that a motion in the plane x, y leaves, with the same signs:
/// a body feels +force and −moment at its input, −force and +moment at its output.
///
/// This is the vector z = [ẍ, ÿ, Ω̇_z, m_z, q_x, q_y, 1] of `[P, Eq. (6)]`, where m is the moment and q the force.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PlaneStateVector<T> {
    acceleration: [T; 2],
    angular_acceleration: T,
    moment: T,
    force: [T; 2],
}

impl<T: Scalar> PlaneStateVector<T> {
    /// Makes z from components in the inertial frame: m/s², rad/s², N·m and N.
    #[inline]
    pub fn new(acceleration: [T; 2], angular_acceleration: T, moment: T, force: [T; 2]) -> Self {
        Self { acceleration, angular_acceleration, moment, force }
    }

    /// Returns the acceleration ẍ, ÿ of the point in m/s², inertial frame.
    ///
    /// It is the second time derivative of the position, so that of a body at rest is zero. An accelerometer measures it
    /// minus the acceleration of gravity.
    #[inline]
    pub fn acceleration(&self) -> Vector2<T> {
        Vector2::from(self.acceleration)
    }

    /// Returns the angular acceleration Ω̇_z of the frame at the point in rad/s².
    #[inline]
    pub fn angular_acceleration(&self) -> T {
        self.angular_acceleration
    }

    /// Returns the internal moment about z in N·m, which acts on the inboard element.
    ///
    /// Its negative acts on the outboard element.
    #[inline]
    pub fn moment(&self) -> T {
        self.moment
    }

    /// Returns the internal force in N, inertial frame, which acts on the outboard element.
    ///
    /// Its negative acts on the inboard element.
    #[inline]
    pub fn force(&self) -> Vector2<T> {
        Vector2::from(self.force)
    }

    /// Returns the seven entries of z in the paper's order; the last one is 1.
    #[inline]
    pub fn to_vector(&self) -> SVector<T, 7> {
        let ([a0, a1], [q0, q1]) = (self.acceleration, self.force);
        let entries = [a0, a1, self.angular_acceleration, self.moment, q0, q1, T::constant(1.0)];
        SVector::from(entries)
    }
}

/// The results at a connection point of a plane chain: pose, velocity, acceleration, internal force and moment.
///
/// Vectors are in the inertial frame. The frame at the point is fixed in the element to which the point belongs. `R`
/// lists the results that the chain computes, which its setting `results` selects.
#[derive(Clone, Copy, PartialEq)]
pub struct PlanePoint<T, R = AllResults> {
    pub(crate) position: [T; 2],
    pub(crate) cos_sin: [T; 2],
    pub(crate) velocity: [T; 2],
    pub(crate) angular_velocity: T,
    pub(crate) z: PlaneStateVector<T>,
    results: PhantomData<R>,
}

impl<T: Scalar> PlanePoint<T> {
    /// Makes a point from its results.
    ///
    /// `cos_sin` are cosine and sine of the counter-clockwise angle from the inertial frame to the point's frame.
    /// Position (m) and velocity (m/s) are in the inertial frame, the angular velocity is in rad/s.
    #[inline]
    pub fn new(
        position: [T; 2],
        cos_sin: [T; 2],
        velocity: [T; 2],
        angular_velocity: T,
        z: PlaneStateVector<T>,
    ) -> Self {
        Self { position, cos_sin, velocity, angular_velocity, z, results: PhantomData }
    }
}

impl<T: Scalar, R> PlanePoint<T, R> {
    /// Returns the position r in m from the inertial origin, inertial frame.
    #[inline]
    pub fn position(&self) -> Vector2<T>
    where
        R: HasPoses,
    {
        Vector2::from(self.position)
    }

    /// Returns the rotation that takes components in the point's frame to inertial components.
    ///
    /// With nalgebra's feature `std` or `libm`, its `angle()` is the angle in rad, between −π and π.
    #[inline]
    pub fn orientation(&self) -> Rotation2<T>
    where
        R: HasPoses,
    {
        let [cosine, sine] = self.cos_sin;
        Rotation2::from_matrix_unchecked(Matrix2::new(cosine, -sine, sine, cosine))
    }

    /// Returns cosine and sine of the counter-clockwise angle from the inertial frame to the point's frame.
    #[inline]
    pub fn cos_sin(&self) -> (T, T)
    where
        R: HasPoses,
    {
        let [cosine, sine] = self.cos_sin;
        (cosine, sine)
    }

    /// Returns the velocity ṙ in m/s, inertial frame.
    #[inline]
    pub fn velocity(&self) -> Vector2<T>
    where
        R: HasVelocities,
    {
        Vector2::from(self.velocity)
    }

    /// Returns the angular velocity Ω_z of the frame at the point in rad/s.
    #[inline]
    pub fn angular_velocity(&self) -> T
    where
        R: HasVelocities,
    {
        self.angular_velocity
    }

    /// Returns the state vector z; its documentation defines the signs of force and moment.
    #[inline]
    pub fn z(&self) -> &PlaneStateVector<T>
    where
        R: HasZ,
    {
        &self.z
    }

    /// Returns the acceleration ẍ, ÿ in m/s², inertial frame: the second time derivative of the position.
    #[inline]
    pub fn acceleration(&self) -> Vector2<T>
    where
        R: HasZ,
    {
        self.z.acceleration()
    }

    /// Returns the angular acceleration Ω̇_z in rad/s².
    #[inline]
    pub fn angular_acceleration(&self) -> T
    where
        R: HasZ,
    {
        self.z.angular_acceleration()
    }

    /// Returns the internal moment about z in N·m.
    ///
    /// It acts on a body at the body's output; its negative acts at the body's input.
    #[inline]
    pub fn moment(&self) -> T
    where
        R: HasZ,
    {
        self.z.moment()
    }

    /// Returns the internal force in N, inertial frame.
    ///
    /// It acts on a body at the body's input; its negative acts at the body's output.
    #[inline]
    pub fn force(&self) -> Vector2<T>
    where
        R: HasZ,
    {
        self.z.force()
    }
}

/// A point at rest at the inertial origin, with the inertial frame, without force and moment.
impl<T: Scalar> Default for PlanePoint<T> {
    fn default() -> Self {
        Self::resting()
    }
}

impl<T: Scalar, R> PlanePoint<T, R> {
    fn resting() -> Self {
        let zero = T::default();
        Self {
            position: [zero; 2],
            cos_sin: [T::constant(1.0), zero],
            velocity: [zero; 2],
            angular_velocity: zero,
            z: PlaneStateVector::default(),
            results: PhantomData,
        }
    }
}

impl<T, R> PlanePoint<T, R> {
    /// Returns the rows of its table.
    pub(crate) fn rows(&self) -> [PointRow<'_, T>; 8] {
        let z = &self.z;
        [
            (Group::Pose, "position", &self.position, "m"),
            (Group::Pose, "cosine and sine", &self.cos_sin, ""),
            (Group::Velocity, "velocity", &self.velocity, "m/s"),
            (Group::Velocity, "angular velocity", from_ref(&self.angular_velocity), "rad/s"),
            (Group::Z, "acceleration", &z.acceleration, "m/s^2"),
            (Group::Z, "angular acceleration", from_ref(&z.angular_acceleration), "rad/s^2"),
            (Group::Z, "force", &z.force, "N"),
            (Group::Z, "moment", from_ref(&z.moment), "N*m"),
        ]
    }
}

/// Formats the results that the chain computes.
impl<T: fmt::Debug, const POSES: bool, const VELOCITIES: bool, const Z: bool> fmt::Debug
    for PlanePoint<T, Results<POSES, VELOCITIES, Z>>
{
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        let fields: &[(bool, &str, &dyn fmt::Debug)] = &[
            (POSES, "position", &self.position),
            (POSES, "cos_sin", &self.cos_sin),
            (VELOCITIES, "velocity", &self.velocity),
            (VELOCITIES, "angular_velocity", &self.angular_velocity),
            (Z, "z", &self.z),
        ];
        show(to, "PlanePoint", fields)
    }
}

/// For generated code.
#[doc(hidden)]
#[allow(missing_docs)]
impl<T: Scalar, R> PlanePoint<T, R> {
    /// Reads a point from the values of a workspace; without slots it is the default.
    #[inline(always)]
    pub fn read(values: &[T], slots: Option<&PointSlots<1, 6>>, base_acceleration: [T; 2]) -> Self {
        let Some(&PointSlots { position, orientation, vectors }) = slots else {
            return Self::resting();
        };
        let [
            velocity,
            (_, angular_velocity),
            proper_acceleration,
            (_, angular_acceleration),
            (_, moment),
            force,
        ] = vectors;
        let ([angular_velocity], [angular_acceleration], [moment]) = (
            vector_at(values, angular_velocity),
            vector_at(values, angular_acceleration),
            vector_at(values, moment),
        );
        let acceleration = difference(to_inertial(values, proper_acceleration), base_acceleration);
        let z = PlaneStateVector::new(
            acceleration,
            angular_acceleration,
            moment,
            to_inertial(values, force),
        );
        let cos_sin = match cos_sin(values, orientation) {
            Some(cos_sin) => cos_sin,
            None => [T::constant(1.0), T::constant(0.0)],
        };
        Self {
            position: vector_at(values, position),
            cos_sin,
            velocity: to_inertial(values, velocity),
            angular_velocity,
            z,
            results: PhantomData,
        }
    }
}

/// Returns a vector in inertial components, from its slot and the slot of its axes.
#[inline(always)]
fn to_inertial<T: Scalar>(values: &[T], (axes, vector): ([u32; 1], u32)) -> [T; 2] {
    let vector = vector_at(values, vector);
    match cos_sin(values, axes) {
        Some(cos_sin) => rotated(cos_sin, vector),
        None => vector,
    }
}

/// Returns cosine and sine of an angle, or `None` for zero.
#[inline(always)]
fn cos_sin<T: Scalar>(values: &[T], [slot]: [u32; 1]) -> Option<[T; 2]> {
    if slot == 0 { None } else { Some(vector_at(values, slot)) }
}

/// Returns a vector rotated by an angle.
#[inline(always)]
fn rotated<T: Scalar>([cosine, sine]: [T; 2], [x, y]: [T; 2]) -> [T; 2] {
    [cosine.mul_add(x, -(sine * y)), sine.mul_add(x, cosine * y)]
}
