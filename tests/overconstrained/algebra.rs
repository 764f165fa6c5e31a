//! Vectors and rotations over any real scalar.

use crate::double_double::DoubleDouble;
use mstmm::Scalar;

/// A scalar without lanes that can be ordered.
pub trait Real: Scalar<Real = Self, Mask = bool> + PartialOrd {
    /// Returns the nearest value in double precision.
    fn double(self) -> f64;

    /// Returns the same value in twice the precision of `f64`, exactly.
    fn exact(self) -> DoubleDouble;

    /// Returns the value nearest to `value`.
    fn nearest(value: DoubleDouble) -> Self;
}

impl Real for f64 {
    fn double(self) -> f64 {
        self
    }

    fn exact(self) -> DoubleDouble {
        DoubleDouble::constant(self)
    }

    fn nearest(value: DoubleDouble) -> f64 {
        value.high
    }
}

impl Real for f32 {
    fn double(self) -> f64 {
        f64::from(self)
    }

    fn exact(self) -> DoubleDouble {
        DoubleDouble::constant(f64::from(self))
    }

    fn nearest(value: DoubleDouble) -> f32 {
        value.high as f32
    }
}

impl Real for DoubleDouble {
    fn double(self) -> f64 {
        self.high
    }

    fn exact(self) -> DoubleDouble {
        self
    }

    fn nearest(value: DoubleDouble) -> DoubleDouble {
        value
    }
}

pub type Vector<T> = [T; 3];
/// The rows of a matrix.
pub type Matrix<T> = [[T; 3]; 3];

pub fn constants<T: Real, const N: usize>(values: [f64; N]) -> [T; N] {
    values.map(T::constant)
}

pub fn dot<T: Real>(a: &[T], b: &[T]) -> T {
    a.iter().zip(b).fold(T::default(), |sum, (x, y)| sum + *x * *y)
}

pub fn norm<T: Real>(a: &[T]) -> T {
    dot(a, a).sqrt()
}

pub fn sum<T: Real>(a: Vector<T>, b: Vector<T>) -> Vector<T> {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

pub fn less<T: Real>(a: Vector<T>, b: Vector<T>) -> Vector<T> {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub fn scaled<T: Real>(a: Vector<T>, factor: T) -> Vector<T> {
    a.map(|x| x * factor)
}

pub fn cross<T: Real>(a: Vector<T>, b: Vector<T>) -> Vector<T> {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub fn transformed<T: Real>(matrix: &Matrix<T>, vector: Vector<T>) -> Vector<T> {
    matrix.map(|row| dot(&row, &vector))
}

pub fn transposed<T: Real>(a: &Matrix<T>) -> Matrix<T> {
    [0, 1, 2].map(|row| [a[0][row], a[1][row], a[2][row]])
}

pub fn product<T: Real>(a: &Matrix<T>, b: &Matrix<T>) -> Matrix<T> {
    let columns = transposed(b);
    a.map(|row| [0, 1, 2].map(|column| dot(&row, &columns[column])))
}

/// Returns the rotation by a quaternion w, x, y, z of any length, without a square root.
pub fn rotation_of<T: Real>(quaternion: [T; 4]) -> Matrix<T> {
    let [w, x, y, z] = quaternion;
    let factor = T::constant(2.0) * dot(&quaternion, &quaternion).recip();
    let one = T::constant(1.0);
    [
        [one - (y * y + z * z) * factor, (x * y - w * z) * factor, (x * z + w * y) * factor],
        [(x * y + w * z) * factor, one - (x * x + z * z) * factor, (y * z - w * x) * factor],
        [(x * z - w * y) * factor, (y * z + w * x) * factor, one - (x * x + y * y) * factor],
    ]
}

/// Returns the rotation by an angle about an axis of unit length.
pub fn rotation_about<T: Real>(axis: Vector<T>, angle: T) -> Matrix<T> {
    // The half angle keeps the digits of 1 − cos near zero.
    let ([sine], [cosine]) = T::sin_cos([angle * T::constant(0.5)]);
    let [x, y, z] = scaled(axis, sine);
    rotation_of([cosine, x, y, z])
}
