//! Motion and internal loads at a connection point of a plane chain.

use core::fmt;
use core::marker::PhantomData;

use nalgebra::{Matrix2, Rotation2, SVector, Vector2};

use super::results::{AllResults, HasPoses, HasVelocities, HasZ, Results, show};
use super::slots::{PointSlots, difference, vector_at};
use crate::Scalar;

/// The method's state vector `[P, Eq. (6)]`, z = [ẍ, ÿ, Ω̇_z, m_z, q_x, q_y, 1] at a connection point of a plane
/// chain, in the inertial frame.
///
/// These are the entries of [`StateVector`](crate::StateVector) that motion in the plane x, y
/// leaves, with the same signs: on a **body**, the force at its input end is +q and at its output
/// end −q; the torque about z at its input end is −m and at its output end +m.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PlaneStateVector<T> {
    acceleration: [T; 2],
    angular_acceleration: T,
    moment: T,
    force: [T; 2],
}

impl<T: Scalar> PlaneStateVector<T> {
    /// Puts z together from components in the inertial frame: m/s², rad/s², N·m and N.
    #[inline]
    pub fn new(acceleration: [T; 2], angular_acceleration: T, moment: T, force: [T; 2]) -> Self {
        Self { acceleration, angular_acceleration, moment, force }
    }

    /// The acceleration ẍ, ÿ of the point in m/s², inertial frame. It is the true one: a body at
    /// rest under gravity has none.
    #[inline]
    pub fn acceleration(&self) -> Vector2<T> {
        Vector2::from(self.acceleration)
    }

    /// The angular acceleration Ω̇_z of the frame at the point in rad/s².
    #[inline]
    pub fn angular_acceleration(&self) -> T {
        self.angular_acceleration
    }

    /// The internal moment m_z in N·m: −m turns the outboard element, +m the inboard one.
    #[inline]
    pub fn moment(&self) -> T {
        self.moment
    }

    /// The internal force q in N, inertial frame: +q pulls the outboard element, −q the inboard
    /// one.
    #[inline]
    pub fn force(&self) -> Vector2<T> {
        Vector2::from(self.force)
    }

    /// All seven entries of z in the paper's order, the last one being 1.
    #[inline]
    pub fn to_vector(&self) -> SVector<T, 7> {
        let ([a0, a1], [q0, q1]) = (self.acceleration, self.force);
        let entries = [a0, a1, self.angular_acceleration, self.moment, q0, q1, T::constant(1.0)];
        SVector::from(entries)
    }
}

/// Everything known of a connection point of a plane chain: where it is, how it moves, and what
/// passes through it.
///
/// Vectors are in the inertial frame. The orientation is that of the frame at the point, which
/// turns with the element the point belongs to. `R` says what the chain computes of it: all that the
/// methods read, unless its setting `results` leaves something out.
#[derive(Clone, Copy, PartialEq)]
pub struct PlanePoint<T, R = AllResults> {
    position: [T; 2],
    pub(super) cos_sin: [T; 2],
    velocity: [T; 2],
    pub(super) angular_velocity: T,
    pub(super) z: PlaneStateVector<T>,
    results: PhantomData<R>,
}

impl<T: Scalar> PlanePoint<T> {
    /// Puts a point together.
    ///
    /// `cos_sin` are cosine and sine of the angle by which the point's frame is turned against the
    /// inertial one, counter-clockwise. Position (m) and velocity (m/s) are in the inertial frame,
    /// the angular velocity is in rad/s.
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
    /// The position r in m, from the inertial frame's origin, in inertial components.
    #[inline]
    pub fn position(&self) -> Vector2<T>
    where
        R: HasPoses,
    {
        Vector2::from(self.position)
    }

    /// The rotation that turns components in the point's frame into inertial components.
    ///
    /// With nalgebra's feature `std` or `libm` its `angle()` is the angle in rad, between −π and π.
    #[inline]
    pub fn orientation(&self) -> Rotation2<T>
    where
        R: HasPoses,
    {
        let [cosine, sine] = self.cos_sin;
        Rotation2::from_matrix_unchecked(Matrix2::new(cosine, -sine, sine, cosine))
    }

    /// Cosine and sine of the angle by which the point's frame is turned against the inertial one,
    /// counter-clockwise.
    #[inline]
    pub fn cos_sin(&self) -> (T, T)
    where
        R: HasPoses,
    {
        let [cosine, sine] = self.cos_sin;
        (cosine, sine)
    }

    /// The velocity ṙ in m/s, inertial frame.
    #[inline]
    pub fn velocity(&self) -> Vector2<T>
    where
        R: HasVelocities,
    {
        Vector2::from(self.velocity)
    }

    /// The angular velocity Ω_z of the frame at the point in rad/s.
    #[inline]
    pub fn angular_velocity(&self) -> T
    where
        R: HasVelocities,
    {
        self.angular_velocity
    }

    /// The method's state vector; its documentation tells the signs of force and moment.
    #[inline]
    pub fn z(&self) -> &PlaneStateVector<T>
    where
        R: HasZ,
    {
        &self.z
    }

    /// The acceleration ẍ, ÿ in m/s², inertial frame.
    #[inline]
    pub fn acceleration(&self) -> Vector2<T>
    where
        R: HasZ,
    {
        self.z.acceleration()
    }

    /// The angular acceleration Ω̇_z in rad/s².
    #[inline]
    pub fn angular_acceleration(&self) -> T
    where
        R: HasZ,
    {
        self.z.angular_acceleration()
    }

    /// The internal moment m_z in N·m. On a body it acts as −m at the input end and +m at the
    /// output end.
    #[inline]
    pub fn moment(&self) -> T
    where
        R: HasZ,
    {
        self.z.moment()
    }

    /// The internal force q in N, inertial frame. On a body it acts as +q at the input end and −q
    /// at the output end.
    #[inline]
    pub fn force(&self) -> Vector2<T>
    where
        R: HasZ,
    {
        self.z.force()
    }
}

/// A point at rest at the origin, its frame the inertial one, with nothing passing through it.
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

/// Shows what the chain computes.
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

/// A vector in inertial axes, from its place and that of the axes that it is seen in.
#[inline(always)]
fn to_inertial<T: Scalar>(values: &[T], (axes, vector): ([u32; 1], u32)) -> [T; 2] {
    let vector = vector_at(values, vector);
    match cos_sin(values, axes) {
        Some(cos_sin) => rotated(cos_sin, vector),
        None => vector,
    }
}

/// Cosine and sine of an angle; nothing of zero.
#[inline(always)]
fn cos_sin<T: Scalar>(values: &[T], [slot]: [u32; 1]) -> Option<[T; 2]> {
    if slot == 0 { None } else { Some(vector_at(values, slot)) }
}

/// A vector turned by an angle.
#[inline(always)]
fn rotated<T: Scalar>([cosine, sine]: [T; 2], [x, y]: [T; 2]) -> [T; 2] {
    [cosine.mul_add(x, -(sine * y)), sine.mul_add(x, cosine * y)]
}
