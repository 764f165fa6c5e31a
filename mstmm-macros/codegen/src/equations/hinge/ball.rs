//! Ball (spherical joint): rotates about all axes [P, Sect. 3.2].
//!
//! Coordinates: the unit quaternion (w, x, y, z) that rotates outboard components into inboard
//! components. Rates: the angular velocity of the outboard frame relative to the inboard frame,
//! outboard axes, in rad/s.

use super::law::{HingeLaw, identity_alignment};
use super::{HingeGeometry, StrainMap, SubspaceColumn};
use crate::equations::SymbolValues;
use crate::math::{FrameOrientation, Mat3, Scalar, Vec3};

/// A ball and socket.
#[derive(Clone, Copy, Debug)]
pub struct Ball;

impl<S: Scalar> HingeLaw<S> for Ball {
    /// A rotation by the quaternion, free about all axes. The moment vanishes, as [P, Eq. (25)]
    /// states for the next hinge.
    fn geometry(&self, _: &SymbolValues<S>, q: &[S]) -> HingeGeometry<S> {
        HingeGeometry {
            rotation: FrameOrientation::from_quaternion([q[0], q[1], q[2], q[3]]),
            columns: rotations(),
            ..HingeGeometry::fixed()
        }
    }

    fn alignment(&self, _: &SymbolValues<S>) -> Mat3<S> {
        identity_alignment()
    }

    /// `½ (w, x, y, z) ∘ (0, ω)`
    fn coordinate_rates(&self, q: &[S], v: &[S]) -> Vec<S> {
        let (w, r) = (q[0], Vec3([q[1], q[2], q[3]]));
        let half = Vec3([v[0], v[1], v[2]]) * S::number(0.5);
        let vector = half * w + r.cross(half);
        let mut rates = vec![-r.dot(half)];
        rates.extend(vector.0);
        rates
    }

    /// The quaternion divided by its norm.
    fn normalized(&self, q: &[S]) -> Vec<S> {
        let square = q.iter().fold(S::zero(), |sum, &x| sum + x * x);
        let scale = square.sqrt().recip();
        q.iter().map(|&x| x * scale).collect()
    }

    fn strains(&self, _: &[S]) -> StrainMap<S> {
        StrainMap::identity(3)
    }
}

/// Returns the rotations about the three outboard axes.
pub fn rotations<S: Scalar>() -> Vec<SubspaceColumn<S>> {
    (0..3).map(|k| SubspaceColumn::rotation(Vec3::unit(k)).outboard()).collect()
}

/// Returns the rotation vector from the quaternion `rest` to `q`, outboard axes: the shorter of the
/// two possible ones.
pub fn rotation_vector<S: Scalar>(rest: &[S], q: &[S]) -> Vec3<S> {
    let (w0, r0) = (rest[0], Vec3([rest[1], rest[2], rest[3]]));
    let (w1, r1) = (q[0], Vec3([q[1], q[2], q[3]]));
    let cos = w0 * w1 + r0.dot(r1);
    let sin = r1 * w0 - r0 * w1 - r0.cross(r1);
    // Angle and sine vanish together.
    let length = sin.dot(sin).divisible_root();
    let half = length.atan2(cos.abs());
    sin * (S::number(2.0).copysign(cos) * half * length.recip())
}

#[cfg(test)]
mod tests {
    use super::rotation_vector;

    fn rotated(angle: f64) -> [f64; 4] {
        let (sin, cos) = (0.5 * angle).sin_cos();
        [cos, 0.6 * sin, 0.0, -0.8 * sin]
    }

    #[test]
    fn rotation_vectors_are_angle_times_axis() {
        for angle in [0.0, 1e-20, 1e-9, 0.3, 2.0, 3.1] {
            for rest in [0.0, 0.7, -2.0] {
                for sign in [1.0, -1.0] {
                    let q = rotated(rest + angle).map(|x| sign * x);
                    let found = rotation_vector(&rotated(rest), &q).0;
                    for (found, axis) in found.into_iter().zip([0.6, 0.0, -0.8]) {
                        // Products of unit quaternions round a dozen times.
                        assert!((found - angle * axis).abs() < 2e-15, "{found} at {angle}");
                    }
                }
            }
        }
    }
}
