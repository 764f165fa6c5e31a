//! Orientations of frames, from rotations that follow each other.

use super::{Mat3, Scalar, Vec3};

/// The orientation of a frame: a rotation matrix, and the unit quaternion that it is computed from, if there is one.
///
/// Two quaternions are multiplied by 16 products and two matrices by 27; the matrix of a quaternion takes 9.
#[derive(Clone, Copy, Debug)]
pub struct FrameOrientation<S> {
    matrix: Mat3<S>,
    /// In the order w, x, y, z.
    quaternion: Option<[S; 4]>,
}

impl<S: Scalar> FrameOrientation<S> {
    /// The orientation of axes relative to themselves.
    pub fn identity() -> Self {
        let [one, zero] = [S::one(), S::zero()];
        FrameOrientation { matrix: Mat3::identity(), quaternion: Some([one, zero, zero, zero]) }
    }

    /// Returns the orientation of the unit quaternion (w, x, y, z).
    pub fn from_quaternion(quaternion: [S; 4]) -> Self {
        FrameOrientation { matrix: Mat3::from_quaternion(quaternion), quaternion: Some(quaternion) }
    }

    /// Returns the orientation of a rotation matrix. A quaternion is known only if the matrix is the identity.
    pub fn from_matrix(matrix: Mat3<S>) -> Self {
        let across = [(0, 1), (0, 2), (1, 0), (1, 2), (2, 0), (2, 1)];
        let is_identity = across.into_iter().all(|(i, j)| matrix[i][j].vanishes())
            && (0..3).all(|i| (matrix[i][i] - S::one()).vanishes());
        let identity = FrameOrientation::identity();
        FrameOrientation { matrix, quaternion: identity.quaternion.filter(|_| is_identity) }
    }

    /// Returns the rotation matrix.
    pub fn matrix(&self) -> Mat3<S> {
        self.matrix
    }

    /// Returns the orientation, in the axes that this one refers to, of a frame with the orientation `inner` in this frame.
    pub fn then(self, inner: Self) -> Self {
        match (self.quaternion, inner.quaternion) {
            (Some(outer), Some(inner)) => FrameOrientation::from_quaternion(product(outer, inner)),
            _ => FrameOrientation { matrix: self.matrix * inner.matrix, quaternion: None },
        }
    }

    /// Returns the inverse rotation.
    pub fn inverse(self) -> Self {
        FrameOrientation {
            matrix: self.matrix.transposed(),
            quaternion: self.quaternion.map(|[w, x, y, z]| [w, -x, -y, -z]),
        }
    }
}

/// Returns the product of two quaternions (w, x, y, z).
fn product<S: Scalar>([a, x, y, z]: [S; 4], [b, i, j, k]: [S; 4]) -> [S; 4] {
    let (u, v) = (Vec3([x, y, z]), Vec3([i, j, k]));
    let [x, y, z] = (v * a + u * b + u.cross(v)).0;
    [a * b - u.dot(v), x, y, z]
}

#[cfg(test)]
mod tests {
    use super::{FrameOrientation, Mat3};

    #[test]
    fn products_of_quaternions_are_products_of_matrices() {
        let (first, second) = ([0.1_f64, 0.5, -0.7, 0.5], [0.6, 0.0, -0.8, 0.0]);
        let [outer, inner] = [first, second].map(FrameOrientation::from_quaternion);
        let matrices = Mat3::from_quaternion(first) * Mat3::from_quaternion(second);
        for (found, expected) in [
            (outer.then(inner), matrices),
            (inner.inverse().then(outer.inverse()), matrices.transposed()),
        ] {
            for (found, expected) in found.matrix().0.concat().iter().zip(expected.0.concat()) {
                // Entries up to one, and two dozen roundings.
                assert!((found - expected).abs() < 24.0 * f64::EPSILON, "{found} {expected}");
            }
        }
    }
}
