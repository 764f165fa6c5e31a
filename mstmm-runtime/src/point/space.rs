//! Motion and internal loads at a connection point in space.

use core::fmt;
use core::marker::PhantomData;

use nalgebra::{Matrix3, Rotation3, SVector, Vector3};

use super::results::{AllResults, HasPoses, HasVelocities, HasZ, Results, show};
use super::rows::{Group, PointRow};
use super::slots::{PointSlots, difference, vector_at};
use crate::Scalar;

/// The state vector z at a connection point: acceleration, angular acceleration, internal moment, internal force.
///
/// All components are in the inertial frame. The internal force and moment are those of a cut at the point, with the
/// signs of `[P, Section 2.1]`: [`force`](Self::force) acts on the outboard element and its negative on the inboard
/// element; [`moment`](Self::moment) acts on the inboard element and its negative on the outboard element. So a body
/// feels +force and −moment at its input, −force and +moment at its output.
///
/// This is the vector z = [r̈, Ω̇, m, q, 1] of `[P, Eq. (3)]`, where m is the moment and q the force.
#[doc(alias("wrench", "constraint forces", "reaction", "contact force"))]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StateVector<T> {
    acceleration: [T; 3],
    angular_acceleration: [T; 3],
    moment: [T; 3],
    force: [T; 3],
}

impl<T: Scalar> StateVector<T> {
    /// Makes z from components in the inertial frame: m/s², rad/s², N·m and N.
    #[inline]
    pub fn new(
        acceleration: [T; 3],
        angular_acceleration: [T; 3],
        moment: [T; 3],
        force: [T; 3],
    ) -> Self {
        Self { acceleration, angular_acceleration, moment, force }
    }

    /// Returns the acceleration r̈ of the point in m/s², inertial frame.
    ///
    /// It is the second time derivative of the position, so that of a body at rest is zero. An accelerometer measures it
    /// minus the acceleration of gravity.
    #[inline]
    pub fn acceleration(&self) -> Vector3<T> {
        Vector3::from(self.acceleration)
    }

    /// Returns the angular acceleration Ω̇ of the frame at the point in rad/s², inertial frame.
    #[inline]
    pub fn angular_acceleration(&self) -> Vector3<T> {
        Vector3::from(self.angular_acceleration)
    }

    /// Returns the internal moment in N·m, inertial frame, which acts on the inboard element.
    ///
    /// Its negative acts on the outboard element.
    #[inline]
    pub fn moment(&self) -> Vector3<T> {
        Vector3::from(self.moment)
    }

    /// Returns the internal force in N, inertial frame, which acts on the outboard element.
    ///
    /// Its negative acts on the inboard element.
    #[inline]
    pub fn force(&self) -> Vector3<T> {
        Vector3::from(self.force)
    }

    /// Returns the thirteen entries of z in the paper's order; the last one is 1.
    #[inline]
    pub fn to_vector(&self) -> SVector<T, 13> {
        let ([a0, a1, a2], [w0, w1, w2]) = (self.acceleration, self.angular_acceleration);
        let ([m0, m1, m2], [q0, q1, q2]) = (self.moment, self.force);
        SVector::from([a0, a1, a2, w0, w1, w2, m0, m1, m2, q0, q1, q2, T::constant(1.0)])
    }
}

/// The results at a connection point in space: pose, velocity, acceleration, internal force and moment.
///
/// Vectors are in the inertial frame. The frame at the point is fixed in the element to which the point belongs. `R`
/// lists the results that the chain computes, which its setting `results` selects.
#[doc(alias("frame", "site", "marker", "link state"))]
#[derive(Clone, Copy, PartialEq)]
pub struct Point<T, R = AllResults> {
    pub(crate) position: [T; 3],
    pub(crate) rotation: [[T; 3]; 3],
    pub(crate) velocity: [T; 3],
    pub(crate) angular_velocity: [T; 3],
    pub(crate) z: StateVector<T>,
    results: PhantomData<R>,
}

impl<T: Scalar> Point<T> {
    /// Makes a point from its results.
    ///
    /// `rotation` has the rows of the matrix A that takes components in the point's frame to inertial components.
    /// Position (m), velocity (m/s) and angular velocity (rad/s) are in the inertial frame.
    #[inline]
    pub fn new(
        position: [T; 3],
        rotation: [[T; 3]; 3],
        velocity: [T; 3],
        angular_velocity: [T; 3],
        z: StateVector<T>,
    ) -> Self {
        Self { position, rotation, velocity, angular_velocity, z, results: PhantomData }
    }
}

impl<T: Scalar, R> Point<T, R> {
    /// Returns the position r in m from the inertial origin, inertial frame.
    #[doc(alias("oMf", "oMi", "xpos", "site_xpos", "framepos"))]
    #[inline]
    pub fn position(&self) -> Vector3<T>
    where
        R: HasPoses,
    {
        Vector3::from(self.position)
    }

    /// Returns the rotation A that takes components in the point's frame to inertial components.
    #[doc(alias("oMf", "oMi", "xmat", "xquat", "site_xmat", "framequat"))]
    #[inline]
    pub fn orientation(&self) -> Rotation3<T>
    where
        R: HasPoses,
    {
        let [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]] = self.rotation;
        Rotation3::from_matrix_unchecked(Matrix3::new(xx, xy, xz, yx, yy, yz, zx, zy, zz))
    }

    /// Returns the velocity ṙ in m/s, inertial frame.
    #[doc(alias("getFrameVelocity", "cvel", "framelinvel", "mj_objectVelocity"))]
    #[inline]
    pub fn velocity(&self) -> Vector3<T>
    where
        R: HasVelocities,
    {
        Vector3::from(self.velocity)
    }

    /// Returns the angular velocity Ω of the frame at the point in rad/s, inertial frame.
    #[doc(alias("cvel", "frameangvel"))]
    #[inline]
    pub fn angular_velocity(&self) -> Vector3<T>
    where
        R: HasVelocities,
    {
        Vector3::from(self.angular_velocity)
    }

    /// Returns the state vector z; its documentation defines the signs of force and moment.
    #[inline]
    pub fn z(&self) -> &StateVector<T>
    where
        R: HasZ,
    {
        &self.z
    }

    /// Returns the acceleration r̈ in m/s², inertial frame: the second time derivative of the position.
    ///
    /// The linear part of a spatial acceleration is r̈ − Ω × ṙ instead.
    #[doc(alias("getFrameClassicalAcceleration", "getFrameAcceleration", "mj_objectAcceleration"))]
    #[doc(alias("EvalBodySpatialAccelerationInWorld", "cacc", "framelinacc"))]
    #[inline]
    pub fn acceleration(&self) -> Vector3<T>
    where
        R: HasZ,
    {
        self.z.acceleration()
    }

    /// Returns the angular acceleration Ω̇ in rad/s², inertial frame.
    #[doc(alias("cacc", "frameangacc"))]
    #[inline]
    pub fn angular_acceleration(&self) -> Vector3<T>
    where
        R: HasZ,
    {
        self.z.angular_acceleration()
    }

    /// Returns the internal moment in N·m, inertial frame.
    ///
    /// It acts on a body at the body's output; its negative acts at the body's input.
    #[inline]
    pub fn moment(&self) -> Vector3<T>
    where
        R: HasZ,
    {
        self.z.moment()
    }

    /// Returns the internal force in N, inertial frame.
    ///
    /// It acts on a body at the body's input; its negative acts at the body's output.
    #[inline]
    pub fn force(&self) -> Vector3<T>
    where
        R: HasZ,
    {
        self.z.force()
    }
}

/// A point at rest at the inertial origin, with the inertial frame, without force and moment.
impl<T: Scalar> Default for Point<T> {
    fn default() -> Self {
        Self::resting()
    }
}

impl<T: Scalar, R> Point<T, R> {
    fn resting() -> Self {
        let (zero, one) = (T::default(), T::constant(1.0));
        Self {
            position: [zero; 3],
            rotation: [[one, zero, zero], [zero, one, zero], [zero, zero, one]],
            velocity: [zero; 3],
            angular_velocity: [zero; 3],
            z: StateVector::default(),
            results: PhantomData,
        }
    }
}

impl<T, R> Point<T, R> {
    /// Returns the rows of its table.
    pub(crate) fn rows(&self) -> [PointRow<'_, T>; 10] {
        let (z, [first, second, third]) = (&self.z, &self.rotation);
        [
            (Group::Pose, "position", &self.position, "m"),
            (Group::Pose, "orientation", first, ""),
            (Group::Pose, "", second, ""),
            (Group::Pose, "", third, ""),
            (Group::Velocity, "velocity", &self.velocity, "m/s"),
            (Group::Velocity, "angular velocity", &self.angular_velocity, "rad/s"),
            (Group::Z, "acceleration", &z.acceleration, "m/s^2"),
            (Group::Z, "angular acceleration", &z.angular_acceleration, "rad/s^2"),
            (Group::Z, "force", &z.force, "N"),
            (Group::Z, "moment", &z.moment, "N*m"),
        ]
    }
}

/// Formats the results that the chain computes.
impl<T: fmt::Debug, const POSES: bool, const VELOCITIES: bool, const Z: bool> fmt::Debug
    for Point<T, Results<POSES, VELOCITIES, Z>>
{
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        let fields: &[(bool, &str, &dyn fmt::Debug)] = &[
            (POSES, "position", &self.position),
            (POSES, "rotation", &self.rotation),
            (VELOCITIES, "velocity", &self.velocity),
            (VELOCITIES, "angular_velocity", &self.angular_velocity),
            (Z, "z", &self.z),
        ];
        show(to, "Point", fields)
    }
}

/// For generated code.
#[doc(hidden)]
#[allow(missing_docs)]
impl<T: Scalar, R> Point<T, R> {
    /// Reads a point from the values of a workspace; without slots it is the default.
    #[inline(always)]
    pub fn read(values: &[T], slots: Option<&PointSlots<3, 6>>, base_acceleration: [T; 3]) -> Self {
        let Some(&PointSlots { position, orientation, vectors }) = slots else {
            return Self::resting();
        };
        let [velocity, angular_velocity, proper_acceleration, angular_acceleration, moment, force] =
            vectors;
        let z = StateVector::new(
            difference(to_inertial(values, proper_acceleration), base_acceleration),
            to_inertial(values, angular_acceleration),
            to_inertial(values, moment),
            to_inertial(values, force),
        );
        let [[xx, yx, zx], [xy, yy, zy], [xz, yz, zz]] = match columns(values, orientation) {
            Some(columns) => columns,
            None => {
                let (zero, one) = (T::constant(0.0), T::constant(1.0));
                [[one, zero, zero], [zero, one, zero], [zero, zero, one]]
            }
        };
        let rotation = [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]];
        Self {
            position: vector_at(values, position),
            rotation,
            velocity: to_inertial(values, velocity),
            angular_velocity: to_inertial(values, angular_velocity),
            z,
            results: PhantomData,
        }
    }
}

/// Returns a vector in inertial components, from its slot and the slots of its axes.
#[inline(always)]
fn to_inertial<T: Scalar>(values: &[T], (axes, vector): ([u32; 3], u32)) -> [T; 3] {
    let vector = vector_at(values, vector);
    match columns(values, axes) {
        Some(columns) => rotated(columns, vector),
        None => vector,
    }
}

/// Returns the columns of a rotation matrix, or `None` for the identity.
#[inline(always)]
fn columns<T: Scalar>(values: &[T], [x, y, z]: [u32; 3]) -> Option<[[T; 3]; 3]> {
    if let (0, 0, 0) = (x, y, z) {
        return None;
    }
    Some([vector_at(values, x), vector_at(values, y), vector_at(values, z)])
}

/// Returns the product of the matrix with these columns and a vector.
#[inline(always)]
fn rotated<T: Scalar>([x, y, z]: [[T; 3]; 3], [a, b, c]: [T; 3]) -> [T; 3] {
    let ([xx, yx, zx], [xy, yy, zy], [xz, yz, zz]) = (x, y, z);
    [
        xx.mul_add(a, xy.mul_add(b, xz * c)),
        yx.mul_add(a, yy.mul_add(b, yz * c)),
        zx.mul_add(a, zy.mul_add(b, zz * c)),
    ]
}
