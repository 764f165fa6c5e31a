//! Vectors, matrices and poses over real numbers and jets.

use super::Real;
use super::jet::Jet;
use std::ops::{Add, Mul, Neg, Sub};

/// A number of a vector.
pub(super) trait Number:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Neg<Output = Self>
{
    fn constant(value: f64) -> Self;
}

impl Number for Real {
    fn constant(value: f64) -> Real {
        Real::new(value)
    }
}

impl Number for Jet {
    fn constant(value: f64) -> Jet {
        Jet::constant(Real::new(value))
    }
}

pub(super) type Vector<T = Real> = [T; 3];
/// A matrix by rows.
pub(super) type Matrix<T = Real> = [[T; 3]; 3];

/// A frame in another one: the vector to its origin, and the rotation from its components to those of
/// the other frame.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pose<T = Jet> {
    pub(super) position: Vector<T>,
    pub(super) rotation: Matrix<T>,
}

pub(super) fn plus<T: Number>(a: Vector<T>, b: Vector<T>) -> Vector<T> {
    std::array::from_fn(|k| a[k] + b[k])
}

pub(super) fn minus<T: Number>(a: Vector<T>, b: Vector<T>) -> Vector<T> {
    std::array::from_fn(|k| a[k] - b[k])
}

pub(super) fn scaled<T: Number>(a: Vector<T>, by: T) -> Vector<T> {
    a.map(|entry| entry * by)
}

pub(super) fn dot<T: Number>(a: Vector<T>, b: Vector<T>) -> T {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(super) fn cross<T: Number>(a: Vector<T>, b: Vector<T>) -> Vector<T> {
    std::array::from_fn(|k| {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        a[i] * b[j] - a[j] * b[i]
    })
}

pub(super) fn norm(a: Vector) -> Real {
    dot(a, a).sqrt()
}

pub(super) fn times<T: Number>(matrix: Matrix<T>, vector: Vector<T>) -> Vector<T> {
    matrix.map(|row| dot(row, vector))
}

pub(super) fn transposed<T: Number>(matrix: Matrix<T>) -> Matrix<T> {
    std::array::from_fn(|row| std::array::from_fn(|column| matrix[column][row]))
}

pub(super) fn product<T: Number>(a: Matrix<T>, b: Matrix<T>) -> Matrix<T> {
    let columns = transposed(b);
    a.map(|row| columns.map(|column| dot(row, column)))
}

pub(super) fn sum<T: Number>(a: Matrix<T>, b: Matrix<T>) -> Matrix<T> {
    std::array::from_fn(|row| plus(a[row], b[row]))
}

pub(super) fn identity<T: Number>() -> Matrix<T> {
    let entry = |row, column| T::constant(f64::from(u8::from(row == column)));
    std::array::from_fn(|row| std::array::from_fn(|column| entry(row, column)))
}

/// Returns the matrix of `a × …`.
pub(super) fn cross_matrix<T: Number>([x, y, z]: Vector<T>) -> Matrix<T> {
    let none = T::constant(0.0);
    [[none, -z, y], [z, none, -x], [-y, x, none]]
}

/// Returns the vector of the skew part of a matrix.
pub(super) fn skew_vector<T: Number>(matrix: Matrix<T>) -> Vector<T> {
    let half = T::constant(0.5);
    std::array::from_fn(|k| {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        (matrix[j][i] - matrix[i][j]) * half
    })
}

/// Returns the rotation about a unit vector.
pub(super) fn about(axis: Vector<Jet>, angle: Jet) -> Matrix<Jet> {
    let (sine, cosine) = angle.sin_cos();
    let versine = <Jet as Number>::constant(1.0) - cosine;
    let turning = cross_matrix(scaled(axis, sine));
    std::array::from_fn(|row| {
        std::array::from_fn(|column| {
            let along = axis[row] * axis[column] * versine + turning[row][column];
            if row == column { along + cosine } else { along }
        })
    })
}

/// Returns the rotation of a quaternion (w, x, y, z) of any length except zero.
pub(super) fn from_quaternion(wxyz: &[Real]) -> Matrix {
    let (w, imaginary) = (wxyz[0], [wxyz[1], wxyz[2], wxyz[3]]);
    let square = w * w + dot(imaginary, imaginary);
    let turning = cross_matrix(imaginary);
    let squared = product(turning, turning);
    // R = 1 + 2 (w [x]× + [x]×²) / |q|².
    let scale = Real::new(2.0) * square.recip();
    let entry = |row: usize, column: usize| {
        (w * turning[row][column] + squared[row][column]) * scale
            + <Real as Number>::constant(f64::from(u8::from(row == column)))
    };
    std::array::from_fn(|row| std::array::from_fn(|column| entry(row, column)))
}

pub(super) fn constant(vector: Vector) -> Vector<Jet> {
    vector.map(Jet::constant)
}

pub(super) fn constant_matrix(matrix: Matrix) -> Matrix<Jet> {
    matrix.map(constant)
}

/// Returns a rotation with this angular velocity and its derivative, both in its own axes.
pub(super) fn rotating(rotation: Matrix, spin: Vector, change: Vector) -> Matrix<Jet> {
    let turning = cross_matrix(spin);
    let rate = product(rotation, turning);
    let second = product(rotation, sum(product(turning, turning), cross_matrix(change)));
    std::array::from_fn(|row| {
        std::array::from_fn(|column| {
            Jet::new(rotation[row][column], rate[row][column], second[row][column])
        })
    })
}

/// Returns the vector with these derivatives.
pub(super) fn moving(position: Vector, velocity: Vector, acceleration: Vector) -> Vector<Jet> {
    std::array::from_fn(|k| Jet::new(position[k], velocity[k], acceleration[k]))
}

impl Pose<Jet> {
    pub(super) fn identity() -> Self {
        Pose { position: [<Jet as Number>::constant(0.0); 3], rotation: identity() }
    }

    /// Returns the pose of a frame that is given in this frame.
    pub(super) fn then(&self, next: &Self) -> Self {
        let position = plus(self.position, times(self.rotation, next.position));
        Pose { position, rotation: product(self.rotation, next.rotation) }
    }

    /// Returns the pose of the other frame in this one.
    pub(super) fn inverse(&self) -> Self {
        let rotation = transposed(self.rotation);
        Pose { position: times(rotation, self.position).map(|entry| -entry), rotation }
    }

    pub(super) fn velocity(&self) -> Vector {
        self.position.map(|entry| entry.rate)
    }

    pub(super) fn acceleration(&self) -> Vector {
        self.position.map(|entry| entry.second)
    }

    /// Returns the angular velocity and the angular acceleration in the axes of the other frame.
    pub(super) fn spin(&self) -> [Vector; 2] {
        let parts = |part: fn(Jet) -> Real| self.rotation.map(|row| row.map(part));
        let (value, rate, second) = (parts(|x| x.value), parts(|x| x.rate), parts(|x| x.second));
        let back = transposed(value);
        // Ṙ Rᵀ = [ω]×, and R̈ Rᵀ = [ω̇]× + [ω]×², of which the last term is symmetric.
        [skew_vector(product(rate, back)), skew_vector(product(second, back))]
    }

    /// Returns the angular velocity and its derivative in the axes of this frame.
    pub(super) fn own_spin(&self) -> [Vector; 2] {
        let back = transposed(self.rotation.map(|row| row.map(|x| x.value)));
        self.spin().map(|vector| times(back, vector))
    }
}
