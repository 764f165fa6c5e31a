//! Motion and internal force at a connection point of a line chain.

use core::fmt;
use core::marker::PhantomData;
use core::slice::from_ref;

use nalgebra::SVector;

use super::results::{AllResults, HasPoses, HasVelocities, HasZ, Results, show};
use super::rows::{Group, PointRow};
use super::slots::{PointSlots, difference, vector_at};
use crate::Scalar;

/// The state vector z at a connection point of a line chain: acceleration and internal force along x.
///
/// It has the entries of [`StateVector`](crate::StateVector) that a motion along x leaves, with the same signs: a body
/// feels +force at its input and −force at its output.
///
/// This is the vector z = [ẍ, q_x, 1] of `[P, Eq. (7)]`, where q is the force.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LineStateVector<T> {
    acceleration: T,
    force: T,
}

impl<T: Scalar> LineStateVector<T> {
    /// Makes z from its components along x: m/s² and N.
    #[inline]
    pub fn new(acceleration: T, force: T) -> Self {
        Self { acceleration, force }
    }

    /// Returns the acceleration ẍ of the point in m/s².
    ///
    /// It is the second time derivative of the position, so that of a body at rest is zero. An accelerometer measures it
    /// minus the acceleration of gravity.
    #[inline]
    pub fn acceleration(&self) -> T {
        self.acceleration
    }

    /// Returns the internal force along x in N, which acts on the outboard element.
    ///
    /// Its negative acts on the inboard element.
    #[inline]
    pub fn force(&self) -> T {
        self.force
    }

    /// Returns the three entries of z in the paper's order; the last one is 1.
    #[inline]
    pub fn to_vector(&self) -> SVector<T, 3> {
        SVector::from([self.acceleration, self.force, T::constant(1.0)])
    }
}

/// The results at a connection point of a line chain, all along x: position, velocity, acceleration, internal force.
///
/// `R` lists the results that the chain computes, which its setting `results` selects.
#[derive(Clone, Copy, PartialEq)]
pub struct LinePoint<T, R = AllResults> {
    pub(crate) position: T,
    pub(crate) velocity: T,
    pub(crate) z: LineStateVector<T>,
    results: PhantomData<R>,
}

impl<T: Scalar> LinePoint<T> {
    /// Makes a point from its position (m), velocity (m/s) and z.
    #[inline]
    pub fn new(position: T, velocity: T, z: LineStateVector<T>) -> Self {
        Self { position, velocity, z, results: PhantomData }
    }
}

impl<T: Scalar, R> LinePoint<T, R> {
    /// Returns the position x in m from the inertial origin.
    #[inline]
    pub fn position(&self) -> T
    where
        R: HasPoses,
    {
        self.position
    }

    /// Returns the velocity ẋ in m/s.
    #[inline]
    pub fn velocity(&self) -> T
    where
        R: HasVelocities,
    {
        self.velocity
    }

    /// Returns the state vector z; its documentation defines the sign of the force.
    #[inline]
    pub fn z(&self) -> &LineStateVector<T>
    where
        R: HasZ,
    {
        &self.z
    }

    /// Returns the acceleration ẍ in m/s²: the second time derivative of the position.
    #[inline]
    pub fn acceleration(&self) -> T
    where
        R: HasZ,
    {
        self.z.acceleration()
    }

    /// Returns the internal force along x in N.
    ///
    /// It acts on a body at the body's input; its negative acts at the body's output.
    #[inline]
    pub fn force(&self) -> T
    where
        R: HasZ,
    {
        self.z.force()
    }
}

/// A point at rest at the inertial origin, without force.
impl<T: Default> Default for LinePoint<T> {
    fn default() -> Self {
        Self::resting()
    }
}

impl<T: Default, R> LinePoint<T, R> {
    fn resting() -> Self {
        let z = LineStateVector::default();
        Self { position: T::default(), velocity: T::default(), z, results: PhantomData }
    }
}

impl<T, R> LinePoint<T, R> {
    /// Returns the rows of its table.
    pub(crate) fn rows(&self) -> [PointRow<'_, T>; 4] {
        [
            (Group::Pose, "position", from_ref(&self.position), "m"),
            (Group::Velocity, "velocity", from_ref(&self.velocity), "m/s"),
            (Group::Z, "acceleration", from_ref(&self.z.acceleration), "m/s^2"),
            (Group::Z, "force", from_ref(&self.z.force), "N"),
        ]
    }
}

/// Formats the results that the chain computes.
impl<T: fmt::Debug, const POSES: bool, const VELOCITIES: bool, const Z: bool> fmt::Debug
    for LinePoint<T, Results<POSES, VELOCITIES, Z>>
{
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        let fields: &[(bool, &str, &dyn fmt::Debug)] = &[
            (POSES, "position", &self.position),
            (VELOCITIES, "velocity", &self.velocity),
            (Z, "z", &self.z),
        ];
        show(to, "LinePoint", fields)
    }
}

/// For generated code.
#[doc(hidden)]
#[allow(missing_docs)]
impl<T: Scalar, R> LinePoint<T, R> {
    /// Reads a point from the values of a workspace; without slots it is the default.
    #[inline(always)]
    pub fn read(values: &[T], slots: Option<&PointSlots<0, 3>>, base_acceleration: [T; 1]) -> Self {
        let Some(&PointSlots { position, vectors, .. }) = slots else { return Self::resting() };
        let [(_, velocity), (_, proper_acceleration), (_, force)] = vectors;
        let ([velocity], [force]) = (vector_at(values, velocity), vector_at(values, force));
        let ([position], [acceleration]) = (
            vector_at(values, position),
            difference(vector_at(values, proper_acceleration), base_acceleration),
        );
        Self {
            position,
            velocity,
            z: LineStateVector::new(acceleration, force),
            results: PhantomData,
        }
    }
}
