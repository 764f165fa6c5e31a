//! Matrices with three rows and columns. Symmetric matrices store six entries, so rounding cannot
//! make them asymmetric.

use super::{Scalar, Vec3};
use std::ops::{Add, Index, Mul, Neg, Sub};

/// A matrix by rows. As a rotation it maps components in one frame to components in another frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mat3<S>(pub [[S; 3]; 3]);

impl<S: Scalar> Mat3<S> {
    /// The matrix with `entry(row, column)`.
    pub fn from_fn(entry: impl Fn(usize, usize) -> S) -> Self {
        let row = |i| Vec3::from_fn(|j| entry(i, j)).0;
        Mat3([row(0), row(1), row(2)])
    }

    /// Returns `R (1 + ω̃)`: the rotation `R` after a small one, which is given in the axes that `R` starts from.
    pub fn followed_by_small(&self, small: Vec3<S>) -> Self {
        Mat3(self.0.map(|row| (Vec3(row) + Vec3(row).cross(small)).0))
    }

    /// The identity.
    pub fn identity() -> Self {
        Sym3::diagonal([S::one(); 3]).full()
    }

    /// The zero matrix.
    pub fn zero() -> Self {
        Mat3([[S::zero(); 3]; 3])
    }

    /// Returns the transpose; for a rotation, its inverse.
    pub fn transposed(self) -> Self {
        Mat3::from_fn(|i, j| self[j][i])
    }

    /// Returns row `i`.
    pub fn row(self, i: usize) -> Vec3<S> {
        Vec3(self[i])
    }

    /// Returns column `j`.
    pub fn column(self, j: usize) -> Vec3<S> {
        Vec3([self[0][j], self[1][j], self[2][j]])
    }

    /// Returns the rotation about axis `k` by an angle with the given sine and cosine.
    pub fn axis_rotation(k: usize, (sin, cos): (S, S)) -> Self {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        Mat3::from_fn(|row, column| match (row, column) {
            (r, c) if r == k && c == k => S::one(),
            (r, c) if (r == i && c == i) || (r == j && c == j) => cos,
            (r, c) if r == j && c == i => sin,
            (r, c) if r == i && c == j => -sin,
            _ => S::zero(),
        })
    }

    /// Returns the rotation matrix of the unit quaternion (w, x, y, z).
    pub fn from_quaternion([w, x, y, z]: [S; 4]) -> Self {
        let (x2, y2, z2) = (x + x, y + y, z + z);
        let (wx, wy, wz) = (w * x2, w * y2, w * z2);
        let (xx, xy, xz) = (x * x2, x * y2, x * z2);
        let (yy, yz, zz) = (y * y2, y * z2, z * z2);
        let one = S::one();
        Mat3([
            [one - (yy + zz), xy - wz, xz + wy],
            [xy + wz, one - (xx + zz), yz - wx],
            [xz - wy, yz + wx, one - (xx + yy)],
        ])
    }

    /// Returns the cosine of a rotation's angle.
    pub fn angle_cosine(self) -> S {
        (self[0][0] + self[1][1] + self[2][2] - S::one()) * S::number(0.5)
    }

    /// Returns angle times axis of a rotation. For a rotation by half a turn the axis is
    /// undetermined, and the vector is zero.
    pub fn rotation_vector(self) -> Vec3<S> {
        let twice =
            Vec3([self[2][1] - self[1][2], self[0][2] - self[2][0], self[1][0] - self[0][1]]);
        let sine = twice * S::number(0.5);
        // Angle and sine vanish together.
        let length = sine.dot(sine).divisible_root();
        sine * (length.atan2(self.angle_cosine()) * length.recip())
    }

    /// Returns `self · inner · selfᵀ` of a rotation.
    ///
    /// A rotation does not change multiples of the identity. A multiple with the last diagonal
    /// entry is therefore subtracted first and added at the end. It is always the same entry, since
    /// quaternions of an integrator are not exactly of unit norm. A rotation does not change the
    /// trace either, from which the first entry follows without the first row of `self · inner`.
    pub fn rotate_tensor(self, inner: Sym3<S>) -> Sym3<S> {
        let even = inner.at(2, 2);
        let along = |i: usize, j: usize| if i == j { even } else { S::zero() };
        let uneven = Sym3::from_fn(|i, j| inner.at(i, j) - along(i, j));
        let half = self * uneven.full();
        let entry = |i: usize, j: usize| half.row(j).dot(self.row(i));
        let is_full = !self[0].iter().any(|entry| entry.vanishes());
        Sym3::from_fn(|i, j| match (i, j) {
            (0, 0) if is_full => uneven.trace() - entry(1, 1) - entry(2, 2) + even,
            _ => entry(i, j) + along(i, j),
        })
    }
}

impl<S> Index<usize> for Mat3<S> {
    type Output = [S; 3];
    fn index(&self, row: usize) -> &[S; 3] {
        &self.0[row]
    }
}

impl<S: Scalar> Mul for Mat3<S> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Mat3::from_fn(|i, j| self.row(i).dot(other.column(j)))
    }
}

impl<S: Scalar> Vec3<S> {
    /// Returns the matrix `r̃` of `r × …`.
    pub fn skew(self) -> Mat3<S> {
        let ([x, y, z], o) = (self.0, S::zero());
        Mat3([[o, -z, y], [z, o, -x], [-y, x, o]])
    }
}

impl<S: Scalar> Mul<Vec3<S>> for Mat3<S> {
    type Output = Vec3<S>;
    fn mul(self, vector: Vec3<S>) -> Vec3<S> {
        Vec3::from_fn(|i| self.row(i).dot(vector))
    }
}

impl<S: Scalar> Add for Mat3<S> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Mat3::from_fn(|i, j| self[i][j] + other[i][j])
    }
}

impl<S: Scalar> Sub for Mat3<S> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Mat3::from_fn(|i, j| self[i][j] - other[i][j])
    }
}

impl<S: Scalar> Neg for Mat3<S> {
    type Output = Self;
    fn neg(self) -> Self {
        Mat3::from_fn(|i, j| -self[i][j])
    }
}

impl<S: Scalar> Mul<S> for Mat3<S> {
    type Output = Self;
    fn mul(self, factor: S) -> Self {
        Mat3::from_fn(|i, j| self[i][j] * factor)
    }
}

/// A symmetric matrix: xx, yy, zz, xy, xz, yz.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sym3<S>(pub [S; 6]);

/// The index at which entry (i, j) of a symmetric matrix is stored.
const ENTRY: [[usize; 3]; 3] = [[0, 3, 4], [3, 1, 5], [4, 5, 2]];

impl<S: Scalar> Sym3<S> {
    /// The matrix with `entry(row, column)`, which is called for the diagonal and the entries above
    /// it.
    pub fn from_fn(entry: impl Fn(usize, usize) -> S) -> Self {
        Sym3([entry(0, 0), entry(1, 1), entry(2, 2), entry(0, 1), entry(0, 2), entry(1, 2)])
    }

    /// The diagonal matrix.
    pub fn diagonal(entries: [S; 3]) -> Self {
        Sym3::from_fn(|i, j| if i == j { entries[i] } else { S::zero() })
    }

    /// Returns entry (i, j).
    pub fn at(&self, i: usize, j: usize) -> S {
        self.0[ENTRY[i][j]]
    }

    /// Returns all nine entries.
    pub fn full(self) -> Mat3<S> {
        Mat3::from_fn(|i, j| self.at(i, j))
    }

    /// Returns the sum of the diagonal.
    pub fn trace(self) -> S {
        self.0[0] + self.0[1] + self.0[2]
    }

    /// Returns `Ω · J Ω` of an inertia: twice the kinetic energy of a rotation.
    pub fn quadratic_form(self, omega: Vec3<S>) -> S {
        if self.is_diagonal() {
            let square = |k: usize| self.at(k, k) * (omega[k] * omega[k]);
            return square(0) + square(1) + square(2);
        }
        omega.dot(self * omega)
    }

    /// Returns `Ω × J Ω` of an inertia, the gyroscopic part of `E_9` in [P, Eq. (20)]. For a
    /// diagonal inertia these are Euler's equations: products of rates, which also occur in the
    /// accelerations of the body's points, and differences of moments of inertia, which vanish for
    /// a body of revolution.
    pub fn gyroscopic(self, omega: Vec3<S>) -> Vec3<S> {
        if self.is_diagonal() {
            return Vec3::from_fn(|k| {
                let (i, j) = ((k + 1) % 3, (k + 2) % 3);
                (self.at(j, j) - self.at(i, i)) * (omega[i] * omega[j])
            });
        }
        omega.cross(self * omega)
    }

    fn is_diagonal(self) -> bool {
        [(0, 1), (0, 2), (1, 2)].iter().all(|&(i, j)| self.at(i, j).vanishes())
    }

    /// Returns the inertia of a mass at `r` about the origin: `m (rᵀr 1 − r rᵀ)`.
    pub fn of_point_mass(mass: S, r: Vec3<S>) -> Self {
        let moment = r * mass;
        let (x, y, z) = (moment[0] * r[0], moment[1] * r[1], moment[2] * r[2]);
        Sym3([y + z, x + z, x + y, -(moment[0] * r[1]), -(moment[0] * r[2]), -(moment[1] * r[2])])
    }
}

impl<S: Scalar> Add for Sym3<S> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Sym3::from_fn(|i, j| self.at(i, j) + other.at(i, j))
    }
}

impl<S: Scalar> Sub for Sym3<S> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Sym3::from_fn(|i, j| self.at(i, j) - other.at(i, j))
    }
}

impl<S: Scalar> Mul<Vec3<S>> for Sym3<S> {
    type Output = Vec3<S>;
    fn mul(self, vector: Vec3<S>) -> Vec3<S> {
        self.full() * vector
    }
}

#[cfg(test)]
mod tests {
    use super::{Mat3, Sym3, Vec3};

    /// Entries are at most 20; a dozen roundings.
    fn assert_near(a: f64, b: f64) {
        assert!((a - b).abs() < 20.0 * 12.0 * f64::EPSILON, "{a} {b}");
    }

    #[test]
    fn diagonal_inertias_agree_with_the_general_formulas() {
        let omega = Vec3([0.7, -1.3, 2.1]);
        for inertia in [Sym3::diagonal([0.3, 1.9, 1.1]), Sym3([0.3, 1.9, 1.1, 0.2, -0.4, 0.1])] {
            let spin = inertia.full() * omega;
            assert_near(inertia.quadratic_form(omega), omega.dot(spin));
            let (found, expected) = (inertia.gyroscopic(omega), omega.cross(spin));
            (0..3).for_each(|k| assert_near(found[k], expected[k]));
        }
    }

    #[test]
    fn a_rotated_tensor_is_the_product_of_three_matrices() {
        let tensor = Sym3([1.0, 4.0, -3.0, 0.5, -1.5, 2.0]);
        // A full matrix, and a matrix with zeros: a rotation about one axis.
        for quaternion in [[0.1, 0.5, 0.7, 0.5], [0.6, 0.0, 0.8, 0.0]] {
            let rotation = Mat3::from_quaternion(quaternion);
            let expected = rotation * tensor.full() * rotation.transposed();
            let found = rotation.rotate_tensor(tensor).full();
            found.0.concat().iter().zip(expected.0.concat()).for_each(|(&a, b)| assert_near(a, b));
        }
    }

    #[test]
    fn both_centripetal_formulas_agree() {
        let (point, omega) = (Vec3([0.4, -0.9, 1.7]), Vec3([0.7, -1.3, 2.1]));
        let (one, other) = (point.centripetal(omega), point.centripetal_by_products(omega));
        (0..3).for_each(|k| assert_near(one[k], other[k]));
    }
}
