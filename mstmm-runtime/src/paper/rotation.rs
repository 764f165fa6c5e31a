//! The rotation matrix of three angles, and the angular velocity and acceleration that their rates
//! make `[P, Section 2.1]`.

use nalgebra::{Matrix3, Vector3};

use super::algebra::{Times, entry};
use crate::Scalar;

/// A = A_z(θ₃) A_y(θ₂) A_x(θ₁), which takes components in the frame K of a point to inertial components
/// `[P, Eq. (1)]`; θ in rad.
pub fn rotation_matrix<T: Scalar>(angles: &Vector3<T>) -> Matrix3<T> {
    let ([s1, s2, s3], [c1, c2, c3]) = T::sin_cos((*angles).into());
    Matrix3::new(
        c2 * c3,
        s1 * s2 * c3 - c1 * s3,
        c1 * s2 * c3 + s1 * s3,
        c2 * s3,
        s1 * s2 * s3 + c1 * c3,
        c1 * s2 * s3 - s1 * c3,
        -s2,
        s1 * c2,
        c1 * c2,
    )
}

/// The angles θ in rad whose rotation matrix `[P, Eq. (1)]` is A, with θ₂ within ±90°. At ±90°
/// itself only θ₁ ∓ θ₃ matters, and any split of it comes out.
pub fn angles<T: Scalar>(rotation: &Matrix3<T>) -> Vector3<T> {
    let a = |row: usize, column: usize| entry(rotation, (row, column));
    let cosine = (a(0, 0) * a(0, 0) + a(1, 0) * a(1, 0)).sqrt();
    Vector3::new(a(2, 1).atan2(a(2, 2)), (-a(2, 0)).atan2(cosine), a(1, 0).atan2(a(0, 0)))
}

/// H: the angular velocity in components of the frame itself is ω = H θ̇ `[P, Section 2.1]`.
pub fn rate_matrix<T: Scalar>(angles: &Vector3<T>) -> Matrix3<T> {
    let ([s1, s2, _], [c1, c2, _]) = T::sin_cos((*angles).into());
    let (o, one) = (T::default(), T::constant(1.0));
    Matrix3::new(one, o, -s2, o, c1, s1 * c2, o, -s1, c1 * c2)
}

/// Ḣ for the rates θ̇ in rad/s `[P, Section 2.1]`.
pub fn rate_matrix_rate<T: Scalar>(angles: &Vector3<T>, rates: &Vector3<T>) -> Matrix3<T> {
    let ([s1, s2, _], [c1, c2, _]) = T::sin_cos((*angles).into());
    let ([v1, v2, _], o) = ((*rates).into(), T::default());
    Matrix3::new(
        o,
        o,
        -(c2 * v2),
        o,
        -(s1 * v1),
        c1 * c2 * v1 - s1 * s2 * v2,
        o,
        -(c1 * v1),
        -(s1 * c2 * v1) - c1 * s2 * v2,
    )
}

/// Ω = A H θ̇ in rad/s, inertial frame `[P, Section 2.1]`.
pub fn angular_velocity<T: Scalar>(angles: &Vector3<T>, rates: &Vector3<T>) -> Vector3<T> {
    rotation_matrix(angles).times(&rate_matrix(angles)).times(rates)
}

/// θ̈ = H⁻¹ Aᵀ Ω̇ − H⁻¹ Ḣ θ̇ in rad/s² for Ω̇ in the inertial frame `[P, Section 2.1]`; the text below it
/// has ż for Ω̇.
///
/// H is singular at θ₂ = ±90°, and the result not finite or without meaning.
pub fn angle_accelerations<T: Scalar>(
    angles: &Vector3<T>,
    rates: &Vector3<T>,
    angular_acceleration: &Vector3<T>,
) -> Vector3<T> {
    let ([s1, s2, _], [c1, c2, _]) = T::sin_cos((*angles).into());
    let (o, one, secant) = (T::default(), T::constant(1.0), c2.recip());
    let tangent = s2 * secant;
    let inverse =
        Matrix3::new(one, s1 * tangent, c1 * tangent, o, c1, -s1, o, s1 * secant, c1 * secant);
    let own = rotation_matrix(angles).transpose().times(angular_acceleration);
    inverse.times(&(own - rate_matrix_rate(angles, rates).times(rates)))
}
