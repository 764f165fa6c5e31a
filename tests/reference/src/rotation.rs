//! Rotations, and the small vector types the crate computes with.

use nalgebra::{Matrix3, Quaternion, Rotation3, Unit, UnitQuaternion, Vector3};

pub(crate) type Vec3 = Vector3<f64>;
pub(crate) type Mat3 = Matrix3<f64>;

/// Returns `Az(yaw) * Ay(pitch) * Ax(roll)`.
pub(crate) fn from_rpy_degrees(rpy: &[f64; 3]) -> Mat3 {
    let (cx, sx) = cos_sin_degrees(rpy[0]);
    let (cy, sy) = cos_sin_degrees(rpy[1]);
    let (cz, sz) = cos_sin_degrees(rpy[2]);
    let about_x = Mat3::new(1.0, 0.0, 0.0, 0.0, cx, -sx, 0.0, sx, cx);
    let about_y = Mat3::new(cy, 0.0, sy, 0.0, 1.0, 0.0, -sy, 0.0, cy);
    let about_z = Mat3::new(cz, -sz, 0.0, sz, cz, 0.0, 0.0, 0.0, 1.0);
    about_z * about_y * about_x
}

/// Returns the cosine and sine of an angle in degrees, exact for multiples of 90°, which have no
/// exact value in radians.
fn cos_sin_degrees(angle: f64) -> (f64, f64) {
    let quarters = (angle / 90.0).rem_euclid(4.0);
    if quarters == 0.0 {
        (1.0, 0.0)
    } else if quarters == 1.0 {
        (0.0, 1.0)
    } else if quarters == 2.0 {
        (-1.0, 0.0)
    } else if quarters == 3.0 {
        (0.0, -1.0)
    } else {
        let (sin, cos) = angle.to_radians().sin_cos();
        (cos, sin)
    }
}

/// Returns the rotation by `angle` about the unit vector `axis`.
pub(crate) fn about_axis(axis: &Vec3, angle: f64) -> Mat3 {
    Rotation3::from_axis_angle(&Unit::new_unchecked(*axis), angle).into_inner()
}

/// Returns the rotation of a quaternion (w, x, y, z) of any length except zero.
pub(crate) fn from_quaternion(wxyz: &[f64]) -> Mat3 {
    let quaternion = Quaternion::new(wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
    UnitQuaternion::from_quaternion(quaternion).to_rotation_matrix().into_inner()
}

/// Returns the rotation of a rotation vector.
pub(crate) fn from_vector(vector: &Vec3) -> Mat3 {
    Rotation3::from_scaled_axis(*vector).into_inner()
}

/// Returns the rotation vector of a rotation, of length π at most.
pub(crate) fn to_vector(rotation: &Mat3) -> Vec3 {
    let identity = [1.0, 0.0, 0.0, 0.0];
    vector_between(&identity, &to_quaternion(rotation, &identity))
}

/// Returns the rotation vector, of length π at most, from the orientation `from` to the orientation
/// `to`, both quaternions (w, x, y, z) of any length except zero. It has the same components in both
/// rotated frames.
pub(crate) fn vector_between(from: &[f64], to: &[f64]) -> Vec3 {
    let quaternion = |wxyz: &[f64]| Quaternion::new(wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
    let turn = quaternion(from).conjugate() * quaternion(to);
    let (cosine, sines) =
        if turn.w < 0.0 { (-turn.w, -turn.imag()) } else { (turn.w, turn.imag()) };
    let sine = sines.norm();
    if sine == 0.0 { Vec3::zeros() } else { sines * (2.0 * sine.atan2(cosine) / sine) }
}

/// Returns the quaternion (w, x, y, z) of a rotation; of the two signs, the one nearer to `near`.
pub(crate) fn to_quaternion(rotation: &Mat3, near: &[f64]) -> [f64; 4] {
    let unit = UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(*rotation));
    let found = [unit.w, unit.i, unit.j, unit.k];
    let along: f64 = found.iter().zip(near).map(|(a, b)| a * b).sum();
    if along < 0.0 { found.map(|component| -component) } else { found }
}

/// Returns the matrix of `a × …`.
pub(crate) fn cross_matrix(a: &Vec3) -> Mat3 {
    a.cross_matrix()
}

/// Returns the sine of the angle times the axis: the rotation vector of a small rotation.
pub(crate) fn sine_vector(rotation: &Mat3) -> Vec3 {
    0.5 * Vec3::new(
        rotation[(2, 1)] - rotation[(1, 2)],
        rotation[(0, 2)] - rotation[(2, 0)],
        rotation[(1, 0)] - rotation[(0, 1)],
    )
}

/// Returns the angle in (−π, π] of a rotation about a known unit axis.
pub(crate) fn angle_about(axis: &Vec3, rotation: &Mat3) -> f64 {
    let sine = axis.dot(&sine_vector(rotation));
    let cosine = 0.5 * (rotation.trace() - 1.0);
    sine.atan2(cosine)
}

/// Returns a matrix as an array of its rows.
pub(crate) fn rows(matrix: &Mat3) -> [[f64; 3]; 3] {
    std::array::from_fn(|row| std::array::from_fn(|column| matrix[(row, column)]))
}
