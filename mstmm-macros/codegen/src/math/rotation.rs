//! Rotations. A rotation of known structure is a rotation about one coordinate axis followed by a
//! fixed rotation.

use super::{Mat3, Scalar, Sym3, Vec3};

/// A rotation from one set of axes to another.
#[derive(Clone, Copy, Debug)]
pub struct Rotation<S> {
    matrix: Mat3<S>,
    pub(super) steps: Option<(AxisRotation<S>, Mat3<S>)>,
    /// A small rotation after it, in the axes that it starts from. Terms of second order are left out.
    small: Option<Vec3<S>>,
}

/// The formula by which a symmetric tensor is rotated, for its entries in the plane of the
/// rotation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PlaneFormula {
    /// The formula with the fewest operations: four products.
    FewestOperations,
    /// A formula with more operations and a shorter longest path through them.
    ShortestPath,
}

/// A rotation about a coordinate axis.
#[derive(Clone, Copy, Debug)]
pub struct AxisRotation<S> {
    /// The axis.
    pub axis: usize,
    /// Sine of the angle.
    pub sin: S,
    /// Cosine of the angle.
    pub cos: S,
}

impl<S: Scalar> AxisRotation<S> {
    /// Returns the rotation matrix.
    pub fn matrix(&self) -> Mat3<S> {
        Mat3::axis_rotation(self.axis, (self.sin, self.cos))
    }

    /// Returns the rotation by the opposite angle.
    pub fn inverse(self) -> Self {
        AxisRotation { sin: -self.sin, ..self }
    }

    /// Returns `R A Rᵀ`. In the plane of the rotation, with `w = s (p − t) + c (q + r)`,
    ///
    /// ```text
    /// R [p q] Rᵀ = [p − s w  c w − r]
    ///   [r t]      [c w − q  t + s w]
    /// ```
    ///
    /// which costs four products, where two matrix products cost sixteen.
    pub fn rotate_tensor(&self, tensor: Mat3<S>) -> Mat3<S> {
        let AxisRotation { axis: k, sin, cos } = *self;
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        let (p, q, r, t) = (tensor[i][i], tensor[i][j], tensor[j][i], tensor[j][j]);
        let w = sin * (p - t) + cos * (q + r);
        let (sw, cw) = (sin * w, cos * w);
        let mut rotated = tensor;
        (rotated.0[i][i], rotated.0[i][j]) = (p - sw, cw - r);
        (rotated.0[j][i], rotated.0[j][j]) = (cw - q, t + sw);
        rotated.0[i][k] = cos * tensor[i][k] - sin * tensor[j][k];
        rotated.0[j][k] = sin * tensor[i][k] + cos * tensor[j][k];
        rotated.0[k][i] = cos * tensor[k][i] - sin * tensor[k][j];
        rotated.0[k][j] = sin * tensor[k][i] + cos * tensor[k][j];
        rotated
    }

    /// Returns `R A Rᵀ` of a symmetric tensor, `q = r`.
    pub(super) fn rotate_symmetric(&self, tensor: Sym3<S>) -> Sym3<S> {
        let rotated = self.rotate_tensor(tensor.full());
        Sym3::from_fn(|i, j| rotated[i][j])
    }

    /// Returns `R A Rᵀ` of a symmetric tensor with entries in the plane of the rotation:
    ///
    /// ```text
    /// R [p q] Rᵀ = [p + t − w  (1 − 2 s²) q + s c (p − t)]   w = t + s² (p − t) + 2 s c q
    ///   [q t]      [            w                        ]
    /// ```
    ///
    /// by [`PlaneFormula::ShortestPath`].
    pub(super) fn rotate_in_plane(&self, tensor: Sym3<S>) -> Sym3<S> {
        let AxisRotation { axis: k, sin, cos } = *self;
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        let (p, q, t) = (tensor.at(i, i), tensor.at(i, j), tensor.at(j, j));
        let (square, product) = (sin * sin, sin * cos);
        let w = t + square * (p - t) + (product + product) * q;
        let across = (S::one() - (square + square)) * q + product * (p - t);
        let mut rotated = tensor.full();
        (rotated.0[i][i], rotated.0[j][j]) = (p + t - w, w);
        (rotated.0[i][j], rotated.0[j][i]) = (across, across);
        Sym3::from_fn(|i, j| rotated[i][j])
    }
}

impl<S: Scalar> Rotation<S> {
    /// A rotation of unknown structure.
    pub fn from_matrix(matrix: Mat3<S>) -> Self {
        Rotation { matrix, steps: None, small: None }
    }

    /// Returns the rotation `mount · step`. Tensors are rotated in these two steps.
    pub fn from_steps(mount: Mat3<S>, step: AxisRotation<S>) -> Self {
        Rotation { matrix: mount * step.matrix(), steps: Some((step, mount)), small: None }
    }

    /// Returns the rotation `R (1 + ω̃)`: a rotation after a small one, which is given in the axes that the rotation starts
    /// from. Vectors are rotated in these two steps: with `R` known, that takes six products for the small one.
    pub fn with_small(self, small: Vec3<S>) -> Self {
        Rotation { steps: None, small: Some(small), ..self }
    }

    /// Returns the axis of the first step, for a rotation in two steps.
    pub fn axis(&self) -> Option<usize> {
        self.steps.map(|(step, _)| step.axis)
    }

    /// Returns the rotation matrix.
    pub fn matrix(&self) -> Mat3<S> {
        match self.small {
            Some(small) => self.matrix.followed_by_small(small),
            None => self.matrix,
        }
    }

    /// Rotates a vector.
    pub fn rotate(&self, vector: Vec3<S>) -> Vec3<S> {
        match self.small {
            Some(small) => self.matrix * (vector + small.cross(vector)),
            None => self.matrix * vector,
        }
    }

    /// Returns `R A Rᵀ` of a tensor.
    pub fn rotate_tensor(&self, tensor: Mat3<S>) -> Mat3<S> {
        match &self.steps {
            Some((step, mount)) => *mount * step.rotate_tensor(tensor) * mount.transposed(),
            None => self.matrix() * tensor * self.matrix().transposed(),
        }
    }

    /// Returns `R A Rᵀ` of a symmetric tensor.
    pub fn rotate_symmetric(&self, tensor: Sym3<S>) -> Sym3<S> {
        match &self.steps {
            Some((step, mount)) => mount.rotate_tensor(step.rotate_symmetric(tensor)),
            None => self.matrix().rotate_tensor(tensor),
        }
    }

    /// Rotates a vector by the inverse rotation.
    pub fn rotate_back(&self, vector: Vec3<S>) -> Vec3<S> {
        let rotated = self.matrix.transposed() * vector;
        match self.small {
            Some(small) => rotated + rotated.cross(small),
            None => rotated,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{AxisRotation, Mat3, Rotation, Sym3, Vec3};
    use crate::math::Dual;

    #[test]
    fn a_rotated_tensor_is_the_product_of_three_matrices() {
        let tensor = Mat3([[1.0, -2.0, 3.0], [0.5, 4.0, -1.5], [2.5, 0.25, -3.0]]);
        for axis in 0..3 {
            let (sin, cos) = 0.7_f64.sin_cos();
            let step = AxisRotation { axis, sin, cos };
            let rotation = step.matrix();
            let (fast, plain) =
                (step.rotate_tensor(tensor), rotation * tensor * rotation.transposed());
            for (a, b) in fast.0.concat().iter().zip(plain.0.concat()) {
                // Entries up to 8, a dozen roundings.
                assert!((a - b).abs() < 8.0 * 12.0 * f64::EPSILON, "{a} {b}");
            }
        }
    }

    #[test]
    fn a_small_rotation_is_a_derivative() {
        let turned = |angle: f64| {
            let (first, second) = (0.7_f64.sin_cos(), angle.sin_cos());
            Mat3::axis_rotation(0, first) * Mat3::axis_rotation(2, second)
        };
        let lifted = |vector: [f64; 3]| Vec3(vector.map(|x| Dual::new(x, 0.0)));
        let rotation = Mat3(turned(0.4).0.map(|row| lifted(row).0));
        let small = Vec3([0.0, 0.0, 1.0].map(|x| Dual::new(0.0, x)));
        let rotation = Rotation::from_matrix(rotation).with_small(small);
        let vector = Vec3([1.5, -0.3, 2.0]);
        let rate = |f: &dyn Fn(f64) -> Vec3<f64>, k: usize| {
            // Central differences: errors of the order of the cube root of the precision, squared.
            (f(0.4 + 1e-5)[k] - f(0.4 - 1e-5)[k]) / 2e-5
        };
        let forth = |angle: f64| turned(angle) * vector;
        let back = |angle: f64| turned(angle).transposed() * vector;
        for k in 0..3 {
            let dual = lifted(vector.0);
            let by_matrix = (rotation.matrix() * dual)[k];
            for (found, expected) in [
                (rotation.rotate(dual)[k], rate(&forth, k)),
                (by_matrix, rate(&forth, k)),
                (rotation.rotate_back(dual)[k], rate(&back, k)),
            ] {
                assert!((found.derivative() - expected).abs() < 1e-9, "{k}: {found:?} {expected}");
            }
            assert!((rotation.rotate(dual)[k].value() - forth(0.4)[k]).abs() < 1e-15 * 8.0);
            assert!((rotation.rotate_back(dual)[k].value() - back(0.4)[k]).abs() < 1e-15 * 8.0);
        }
    }

    #[test]
    fn both_formulas_rotate_a_tensor_in_the_plane_alike() {
        let tensor = Sym3([1.0, -4.0, 3.0, 0.0, 0.0, 2.5]);
        let (sin, cos) = 2.3_f64.sin_cos();
        for axis in 0..3 {
            // Only the entry across the plane of the rotation is left.
            let tensor = Sym3::from_fn(|i, j| {
                if i == j || (i != axis && j != axis) {
                    tensor.at(i, i) - 0.5 * tensor.at(j, j)
                } else {
                    0.0
                }
            });
            let step = AxisRotation { axis, sin, cos };
            let (one, other) = (step.rotate_in_plane(tensor), step.rotate_symmetric(tensor));
            for (a, b) in one.0.iter().zip(other.0) {
                // Entries up to 8, a dozen roundings.
                assert!((a - b).abs() < 8.0 * 12.0 * f64::EPSILON, "{a} {b}");
            }
        }
    }
}
