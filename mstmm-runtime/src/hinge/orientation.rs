//! Conversions between the quaternions of a state, nalgebra's quaternions and the paper's Bryan angles.

use nalgebra::{Quaternion, Unit, UnitQuaternion, Vector4};

use crate::Scalar;

/// Returns the quaternion w, x, y, z of the identity.
#[inline]
pub(super) fn aligned<T: Scalar>() -> [T; 4] {
    let zero = T::default();
    [T::constant(1.0), zero, zero, zero]
}

/// Returns the quaternion with the components w, x, y, z, whose length is assumed to be one.
#[inline]
pub(super) fn to_unit_quaternion<T: Scalar>([w, x, y, z]: [T; 4]) -> UnitQuaternion<T> {
    Unit::new_unchecked(Quaternion { coords: Vector4::new(x, y, z, w) })
}

/// Returns the components of a quaternion in the order w, x, y, z.
#[inline]
pub(super) fn to_array<T: Scalar>(orientation: UnitQuaternion<T>) -> [T; 4] {
    let [[x, y, z, w]] = orientation.into_inner().coords.data.0;
    [w, x, y, z]
}

/// Returns the quaternion of A = A_z(θ₃) A_y(θ₂) A_x(θ₁), `[P, Eq. (1)]`: the product of the three
/// quaternions of half angles.
#[inline]
pub(super) fn from_bryan_angles<T: Scalar>(angles: [T; 3]) -> [T; 4] {
    let half = T::constant(0.5);
    let ([s1, s2, s3], [c1, c2, c3]) = T::sin_cos(angles.map(|angle| angle * half));
    [
        c1 * c2 * c3 + s1 * s2 * s3,
        s1 * c2 * c3 - c1 * s2 * s3,
        c1 * s2 * c3 + s1 * c2 * s3,
        c1 * c2 * s3 - s1 * s2 * c3,
    ]
}

/// Writes each value to its reference.
#[inline]
pub(super) fn store<T, const N: usize>(places: &mut [&mut T; N], values: [T; N]) {
    for (place, value) in places.iter_mut().zip(values) {
        **place = value;
    }
}
