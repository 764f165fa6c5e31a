//! Motion and internal loads at a connection point in space.

use core::fmt;
use core::marker::PhantomData;

use nalgebra::{Matrix3, Rotation3, SVector, Vector3};

use super::results::{AllResults, HasPoses, HasVelocities, HasZ, Results, show};
use super::slots::{PointSlots, difference, vector_at};
use crate::Scalar;

/// The method's state vector z = [r̈, Ω̇, m, q, 1] at a connection point, in the inertial frame.
///
/// It holds acceleration and angular acceleration of the point and the internal moment and force
/// that pass through it. The signs are those of `[P, Section 2.1]`: on a **body**, the force at its
/// input end is +q and at its output end −q; the torque at its input end is −m and at its output
/// end +m. So what the inboard element receives at the point is the force −q and the torque +m, and
/// the outboard element the force +q and the torque −m.
///
/// In the paper's words, `[P, Eq. (3)]`; here the internal force is called `force` and the moment
/// `moment`, since q are coordinates.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StateVector<T> {
    acceleration: [T; 3],
    angular_acceleration: [T; 3],
    moment: [T; 3],
    force: [T; 3],
}

impl<T: Scalar> StateVector<T> {
    /// Puts z together from components in the inertial frame: m/s², rad/s², N·m and N.
    #[inline]
    pub fn new(
        acceleration: [T; 3],
        angular_acceleration: [T; 3],
        moment: [T; 3],
        force: [T; 3],
    ) -> Self {
        Self { acceleration, angular_acceleration, moment, force }
    }

    /// The acceleration r̈ of the point in m/s², inertial frame. It is the true one: a body at rest
    /// under gravity has none.
    #[inline]
    pub fn acceleration(&self) -> Vector3<T> {
        Vector3::from(self.acceleration)
    }

    /// The angular acceleration Ω̇ of the frame at the point in rad/s², inertial frame.
    #[inline]
    pub fn angular_acceleration(&self) -> Vector3<T> {
        Vector3::from(self.angular_acceleration)
    }

    /// The internal moment m in N·m, inertial frame: −m turns the outboard element, +m the inboard
    /// one.
    #[inline]
    pub fn moment(&self) -> Vector3<T> {
        Vector3::from(self.moment)
    }

    /// The internal force q in N, inertial frame: +q pulls the outboard element, −q the inboard
    /// one.
    #[inline]
    pub fn force(&self) -> Vector3<T> {
        Vector3::from(self.force)
    }

    /// All thirteen entries of z in the paper's order, the last one being 1.
    #[inline]
    pub fn to_vector(&self) -> SVector<T, 13> {
        let ([a0, a1, a2], [w0, w1, w2]) = (self.acceleration, self.angular_acceleration);
        let ([m0, m1, m2], [q0, q1, q2]) = (self.moment, self.force);
        SVector::from([a0, a1, a2, w0, w1, w2, m0, m1, m2, q0, q1, q2, T::constant(1.0)])
    }
}

/// Everything known of a connection point: where it is, how it moves, and what passes through it.
///
/// Vectors are in the inertial frame. The orientation is that of the frame at the point, which
/// turns with the element the point belongs to. `R` says what the chain computes of it: all that the
/// methods read, unless its setting `results` leaves something out.
#[derive(Clone, Copy, PartialEq)]
pub struct Point<T, R = AllResults> {
    position: [T; 3],
    pub(super) rotation: [[T; 3]; 3],
    velocity: [T; 3],
    pub(super) angular_velocity: [T; 3],
    pub(super) z: StateVector<T>,
    results: PhantomData<R>,
}

impl<T: Scalar> Point<T> {
    /// Puts a point together.
    ///
    /// `rotation` holds the rows of the matrix A that turns components in the point's frame into
    /// inertial ones. Position (m), velocity (m/s) and angular velocity (rad/s) are in the inertial
    /// frame.
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
    /// The position r in m, from the inertial frame's origin, in inertial components.
    #[inline]
    pub fn position(&self) -> Vector3<T>
    where
        R: HasPoses,
    {
        Vector3::from(self.position)
    }

    /// The rotation A that turns components in the point's frame into inertial components.
    #[inline]
    pub fn orientation(&self) -> Rotation3<T>
    where
        R: HasPoses,
    {
        let [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]] = self.rotation;
        Rotation3::from_matrix_unchecked(Matrix3::new(xx, xy, xz, yx, yy, yz, zx, zy, zz))
    }

    /// The velocity ṙ in m/s, inertial frame.
    #[inline]
    pub fn velocity(&self) -> Vector3<T>
    where
        R: HasVelocities,
    {
        Vector3::from(self.velocity)
    }

    /// The angular velocity Ω of the frame at the point in rad/s, inertial frame.
    #[inline]
    pub fn angular_velocity(&self) -> Vector3<T>
    where
        R: HasVelocities,
    {
        Vector3::from(self.angular_velocity)
    }

    /// The method's state vector; its documentation tells the signs of force and moment.
    #[inline]
    pub fn z(&self) -> &StateVector<T>
    where
        R: HasZ,
    {
        &self.z
    }

    /// The acceleration r̈ in m/s², inertial frame.
    #[inline]
    pub fn acceleration(&self) -> Vector3<T>
    where
        R: HasZ,
    {
        self.z.acceleration()
    }

    /// The angular acceleration Ω̇ in rad/s², inertial frame.
    #[inline]
    pub fn angular_acceleration(&self) -> Vector3<T>
    where
        R: HasZ,
    {
        self.z.angular_acceleration()
    }

    /// The internal moment m in N·m, inertial frame. On a body it acts as −m at the input end and
    /// +m at the output end.
    #[inline]
    pub fn moment(&self) -> Vector3<T>
    where
        R: HasZ,
    {
        self.z.moment()
    }

    /// The internal force q in N, inertial frame. On a body it acts as +q at the input end and −q
    /// at the output end.
    #[inline]
    pub fn force(&self) -> Vector3<T>
    where
        R: HasZ,
    {
        self.z.force()
    }
}

/// A point at rest at the origin, its frame the inertial one, with nothing passing through it.
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

/// Shows what the chain computes.
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

/// A vector in inertial axes, from its place and those of the axes that it is seen in.
#[inline(always)]
fn to_inertial<T: Scalar>(values: &[T], (axes, vector): ([u32; 3], u32)) -> [T; 3] {
    let vector = vector_at(values, vector);
    match columns(values, axes) {
        Some(columns) => rotated(columns, vector),
        None => vector,
    }
}

/// The columns of a matrix; nothing of the identity.
#[inline(always)]
fn columns<T: Scalar>(values: &[T], [x, y, z]: [u32; 3]) -> Option<[[T; 3]; 3]> {
    if let (0, 0, 0) = (x, y, z) {
        return None;
    }
    Some([vector_at(values, x), vector_at(values, y), vector_at(values, z)])
}

/// A vector in the axes that the matrix with these columns leads to.
#[inline(always)]
fn rotated<T: Scalar>([x, y, z]: [[T; 3]; 3], [a, b, c]: [T; 3]) -> [T; 3] {
    let ([xx, yx, zx], [xy, yy, zy], [xz, yz, zz]) = (x, y, z);
    [
        xx.mul_add(a, xy.mul_add(b, xz * c)),
        yx.mul_add(a, yy.mul_add(b, yz * c)),
        zx.mul_add(a, zy.mul_add(b, zz * c)),
    ]
}
