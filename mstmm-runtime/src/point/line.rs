//! Motion and internal force at a connection point of a line chain.

use core::fmt;
use core::marker::PhantomData;

use nalgebra::SVector;

use super::results::{AllResults, HasPoses, HasVelocities, HasZ, Results, show};
use super::slots::{PointSlots, difference, vector_at};
use crate::Scalar;

/// The method's state vector `[P, Eq. (7)]`, z = [ẍ, q_x, 1] at a connection point of a line chain.
///
/// These are the entries of [`StateVector`](crate::StateVector) that motion along x leaves, with
/// the same signs: on a **body**, the force at its input end is +q and at its output end −q.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LineStateVector<T> {
    acceleration: T,
    force: T,
}

impl<T: Scalar> LineStateVector<T> {
    /// Puts z together: m/s² and N, along x.
    #[inline]
    pub fn new(acceleration: T, force: T) -> Self {
        Self { acceleration, force }
    }

    /// The acceleration ẍ of the point in m/s². It is the true one: a body at rest under gravity
    /// has none.
    #[inline]
    pub fn acceleration(&self) -> T {
        self.acceleration
    }

    /// The internal force q_x in N: +q pulls the outboard element, −q the inboard one.
    #[inline]
    pub fn force(&self) -> T {
        self.force
    }

    /// All three entries of z in the paper's order, the last one being 1.
    #[inline]
    pub fn to_vector(&self) -> SVector<T, 3> {
        SVector::from([self.acceleration, self.force, T::constant(1.0)])
    }
}

/// Everything known of a connection point of a line chain: where it is, how it moves, and what
/// passes through it, all along x. `R` says what the chain computes of
/// it: all that the methods read, unless its setting `results` leaves something out.
#[derive(Clone, Copy, PartialEq)]
pub struct LinePoint<T, R = AllResults> {
    position: T,
    velocity: T,
    z: LineStateVector<T>,
    results: PhantomData<R>,
}

impl<T: Scalar> LinePoint<T> {
    /// Puts a point together from its position (m), velocity (m/s) and z.
    #[inline]
    pub fn new(position: T, velocity: T, z: LineStateVector<T>) -> Self {
        Self { position, velocity, z, results: PhantomData }
    }
}

impl<T: Scalar, R> LinePoint<T, R> {
    /// The position x in m, from the inertial frame's origin.
    #[inline]
    pub fn position(&self) -> T
    where
        R: HasPoses,
    {
        self.position
    }

    /// The velocity ẋ in m/s.
    #[inline]
    pub fn velocity(&self) -> T
    where
        R: HasVelocities,
    {
        self.velocity
    }

    /// The method's state vector; its documentation tells the sign of the force.
    #[inline]
    pub fn z(&self) -> &LineStateVector<T>
    where
        R: HasZ,
    {
        &self.z
    }

    /// The acceleration ẍ in m/s².
    #[inline]
    pub fn acceleration(&self) -> T
    where
        R: HasZ,
    {
        self.z.acceleration()
    }

    /// The internal force q_x in N. On a body it acts as +q at the input end and −q at the output
    /// end.
    #[inline]
    pub fn force(&self) -> T
    where
        R: HasZ,
    {
        self.z.force()
    }
}

/// A point at rest at the origin, with nothing passing through it.
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

/// Shows what the chain computes.
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
