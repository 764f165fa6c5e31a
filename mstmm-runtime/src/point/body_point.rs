//! Motion of points fixed in a body.

use nalgebra::{Rotation2, Rotation3, Vector2, Vector3};

use super::{
    ConnectionPoint, HasPoses, HasVelocities, HasZ, LinePoint, LineStateVector, PlanePoint,
    PlaneStateVector, Point, StateVector,
};
use crate::Scalar;

/// A point fixed in a body: its centre of mass, or a named point.
///
/// Vectors are in the inertial frame. Each method computes its value from the results at the input of the body when it
/// is called. A velocity needs the results `poses` and `velocities`; an acceleration needs `poses`, `velocities` and
/// `z`. In a line chain a velocity needs only `velocities` and an acceleration only `z`.
#[doc(alias("site", "frame", "marker"))]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BodyPoint<P: ConnectionPoint> {
    input: P,
    place: P::Vector,
    /// The axes of the frame there, in the body frame; none for those of the body.
    axes: Option<P::Axes>,
}

impl<P: ConnectionPoint> BodyPoint<P> {
    /// Makes the point at `place`, in m in the body frame, of the body with this input. Its frame has the axes of the body.
    #[inline]
    pub fn new(input: P, place: P::Vector) -> Self {
        Self { input, place, axes: None }
    }

    /// Makes the same point with a frame with these axes: the columns of the rotation matrix that takes components in the frame
    /// to components in the body frame; in the plane the first column.
    #[inline]
    pub fn turned(self, axes: P::Axes) -> Self {
        Self { axes: Some(axes), ..self }
    }
}

impl<T: Scalar, R> BodyPoint<Point<T, R>> {
    /// Returns the vector from the input to the point, inertial frame.
    #[inline]
    fn arm(&self) -> [T; 3] {
        self.input.rotation.map(|row| dot(row, self.place))
    }

    /// Returns the rows of the rotation matrix from the frame of the point to the inertial frame.
    #[inline]
    fn rotation(&self) -> [[T; 3]; 3] {
        match self.axes {
            Some(columns) => self.input.rotation.map(|row| columns.map(|axis| dot(row, axis))),
            None => self.input.rotation,
        }
    }

    /// Returns a connection point with the motion of this point, without force and moment. Results that the chain omits
    /// are arbitrary.
    #[inline]
    pub(crate) fn motion(&self) -> Point<T> {
        let Point { position, velocity, angular_velocity: omega, z, .. } = self.input;
        let arm = self.arm();
        let angular_acceleration = z.angular_acceleration().into();
        let tangential = cross(angular_acceleration, arm);
        let centripetal = cross(omega, cross(omega, arm));
        let acceleration =
            z.acceleration() + Vector3::from(tangential) + Vector3::from(centripetal);
        let none = [T::default(); 3];
        Point::new(
            (Vector3::from(position) + Vector3::from(arm)).into(),
            self.rotation(),
            (Vector3::from(velocity) + Vector3::from(cross(omega, arm))).into(),
            omega,
            StateVector::new(acceleration.into(), angular_acceleration, none, none),
        )
    }

    /// Returns the position r = r_I + A r′ in m from the inertial origin.
    #[doc(alias("site_xpos", "framepos"))]
    #[inline]
    pub fn position(&self) -> Vector3<T>
    where
        R: HasPoses,
    {
        Vector3::from(self.motion().position)
    }

    /// Returns the rotation A that takes components in the frame of the point to inertial components. A centre of mass has the
    /// axes of the body, a named point those of its `turned …`.
    #[doc(alias("site_xmat", "framequat", "framexaxis"))]
    #[inline]
    pub fn orientation(&self) -> Rotation3<T>
    where
        R: HasPoses,
    {
        self.motion().orientation()
    }

    /// Returns the velocity ṙ = ṙ_I + Ω × A r′ in m/s.
    #[doc(alias("framelinvel"))]
    #[inline]
    pub fn velocity(&self) -> Vector3<T>
    where
        R: HasPoses + HasVelocities,
    {
        Vector3::from(self.motion().velocity)
    }

    /// Returns the body's angular velocity Ω in rad/s.
    #[doc(alias("frameangvel"))]
    #[inline]
    pub fn angular_velocity(&self) -> Vector3<T>
    where
        R: HasVelocities,
    {
        self.input.angular_velocity()
    }

    /// Returns the acceleration r̈ = r̈_I + Ω̇ × A r′ + Ω × (Ω × A r′) in m/s²: the second time derivative of the position.
    #[doc(alias("framelinacc", "CalcCenterOfMassTranslationalAccelerationInWorld"))]
    #[inline]
    pub fn acceleration(&self) -> Vector3<T>
    where
        R: HasPoses + HasVelocities + HasZ,
    {
        self.motion().z.acceleration()
    }

    /// Returns the body's angular acceleration Ω̇ in rad/s².
    #[doc(alias("frameangacc"))]
    #[inline]
    pub fn angular_acceleration(&self) -> Vector3<T>
    where
        R: HasZ,
    {
        self.input.angular_acceleration()
    }
}

impl<T: Scalar, R> BodyPoint<PlanePoint<T, R>> {
    /// Returns the vector from the input to the point, inertial frame.
    #[inline]
    fn arm(&self) -> Vector2<T> {
        Vector2::from(rotated(self.input.cos_sin, self.place))
    }

    /// Returns cosine and sine of the angle from the inertial frame to the frame of the point.
    #[inline]
    fn direction(&self) -> [T; 2] {
        match self.axes {
            Some([axis]) => rotated(self.input.cos_sin, axis),
            None => self.input.cos_sin,
        }
    }

    /// Returns a connection point with the motion of this point, without force and moment. Results that the chain omits
    /// are arbitrary.
    #[inline]
    pub(crate) fn motion(&self) -> PlanePoint<T> {
        let PlanePoint { position, velocity, angular_velocity: omega, z, .. } = self.input;
        let (arm, angular_acceleration) = (self.arm(), z.angular_acceleration());
        let tangential = across(arm) * angular_acceleration;
        let acceleration = z.acceleration() + tangential - arm * (omega * omega);
        let none = T::default();
        PlanePoint::new(
            (Vector2::from(position) + arm).into(),
            self.direction(),
            (Vector2::from(velocity) + across(arm) * omega).into(),
            omega,
            PlaneStateVector::new(acceleration.into(), angular_acceleration, none, [none; 2]),
        )
    }

    /// Returns the position r = r_I + A r′ in m from the inertial origin.
    #[inline]
    pub fn position(&self) -> Vector2<T>
    where
        R: HasPoses,
    {
        Vector2::from(self.motion().position)
    }

    /// Returns the rotation A that takes components in the frame of the point to inertial components. A centre of mass has the
    /// axes of the body, a named point those of its `turned …`.
    #[inline]
    pub fn orientation(&self) -> Rotation2<T>
    where
        R: HasPoses,
    {
        self.motion().orientation()
    }

    /// Returns cosine and sine of the counter-clockwise angle from the inertial frame to the frame of the point.
    #[inline]
    pub fn cos_sin(&self) -> (T, T)
    where
        R: HasPoses,
    {
        self.motion().cos_sin()
    }

    /// Returns the velocity ṙ = ṙ_I + Ω × A r′ in m/s.
    #[inline]
    pub fn velocity(&self) -> Vector2<T>
    where
        R: HasPoses + HasVelocities,
    {
        Vector2::from(self.motion().velocity)
    }

    /// Returns the body's angular velocity Ω_z in rad/s.
    #[inline]
    pub fn angular_velocity(&self) -> T
    where
        R: HasVelocities,
    {
        self.input.angular_velocity()
    }

    /// Returns the acceleration r̈ = r̈_I + Ω̇ × A r′ − Ω² A r′ in m/s²: the second time derivative of the position.
    #[inline]
    pub fn acceleration(&self) -> Vector2<T>
    where
        R: HasPoses + HasVelocities + HasZ,
    {
        self.motion().z.acceleration()
    }

    /// Returns the body's angular acceleration Ω̇_z in rad/s².
    #[inline]
    pub fn angular_acceleration(&self) -> T
    where
        R: HasZ,
    {
        self.input.angular_acceleration()
    }
}

impl<T: Scalar, R> BodyPoint<LinePoint<T, R>> {
    /// Returns a connection point with the motion of this point, without force. Results that the chain omits are
    /// arbitrary.
    #[inline]
    pub(crate) fn motion(&self) -> LinePoint<T> {
        let ([place], LinePoint { position, velocity, z, .. }) = (self.place, &self.input);
        let z = LineStateVector::new(z.acceleration(), T::default());
        LinePoint::new(*position + place, *velocity, z)
    }

    /// Returns the position x in m, from the inertial frame's origin.
    #[inline]
    pub fn position(&self) -> T
    where
        R: HasPoses,
    {
        self.motion().position
    }

    /// Returns the velocity ẋ in m/s, that of all points of the body.
    #[inline]
    pub fn velocity(&self) -> T
    where
        R: HasVelocities,
    {
        self.input.velocity()
    }

    /// Returns the acceleration ẍ in m/s², that of all points of the body.
    #[inline]
    pub fn acceleration(&self) -> T
    where
        R: HasZ,
    {
        self.input.acceleration()
    }
}

/// Returns the scalar product.
#[inline]
fn dot<T: Scalar>([a, b, c]: [T; 3], [x, y, z]: [T; 3]) -> T {
    a.mul_add(x, b.mul_add(y, c * z))
}

/// Returns a vector rotated by an angle with this cosine and sine.
#[inline]
fn rotated<T: Scalar>([cosine, sine]: [T; 2], [x, y]: [T; 2]) -> [T; 2] {
    [cosine.mul_add(x, -(sine * y)), sine.mul_add(x, cosine * y)]
}

/// Returns the cross product.
#[inline]
fn cross<T: Scalar>([a, b, c]: [T; 3], [x, y, z]: [T; 3]) -> [T; 3] {
    [b.mul_add(z, -(c * y)), c.mul_add(x, -(a * z)), a.mul_add(y, -(b * x))]
}

/// Returns the cross product of the unit vector along z and a vector in the plane.
#[inline]
fn across<T: Scalar>(vector: Vector2<T>) -> Vector2<T> {
    let [x, y] = vector.into();
    Vector2::new(-y, x)
}
