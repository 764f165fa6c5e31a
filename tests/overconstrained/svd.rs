//! Singular values by one-sided Jacobi rotations, in any precision.

use super::algebra::{Real, dot, norm};

/// A matrix A = Σ σ u vᵀ.
pub struct Decomposed<T> {
    /// The singular values, the greatest first, as many as the matrix has columns.
    pub values: Vec<T>,
    /// The products σ u.
    images: Vec<Vec<T>>,
    /// The unit vectors v.
    pub directions: Vec<Vec<T>>,
}

/// The sweeps that are tried; convergence is quadratic, and ten are enough for thirty digits.
const SWEEPS: usize = 40;

/// Decomposes a matrix that is given by its columns.
pub fn decomposed<T: Real>(columns: &[Vec<T>]) -> Decomposed<T> {
    let count = columns.len();
    let mut images = columns.to_vec();
    let unit = |k: usize| (0..count).map(|j| T::constant(f64::from(u8::from(j == k)))).collect();
    let mut directions: Vec<Vec<T>> = (0..count).map(unit).collect();
    let total = images.iter().fold(T::default(), |sum, column| sum + dot(column, column));
    let negligible = total * T::epsilon() * T::constant(4.0);
    for sweep in 0..SWEEPS {
        let mut rotated = false;
        for i in 0..count {
            for j in i + 1..count {
                let off = dot(&images[i], &images[j]);
                if off.abs() > negligible {
                    let difference = dot(&images[j], &images[j]) - dot(&images[i], &images[i]);
                    let (cosine, sine) = orthogonalising(off, difference);
                    rotate(&mut images, [i, j], cosine, sine);
                    rotate(&mut directions, [i, j], cosine, sine);
                    rotated = true;
                }
            }
        }
        if !rotated {
            break;
        }
        assert!(sweep + 1 < SWEEPS, "Jacobi rotations do not converge");
    }
    let mut order: Vec<usize> = (0..count).collect();
    let values: Vec<T> = images.iter().map(|image| norm(image)).collect();
    order.sort_by(|&i, &j| values[j].double().total_cmp(&values[i].double()));
    Decomposed {
        values: order.iter().map(|&k| values[k]).collect(),
        images: order.iter().map(|&k| images[k].clone()).collect(),
        directions: order.iter().map(|&k| directions[k].clone()).collect(),
    }
}

/// Returns the cosine and the sine of the rotation after which two columns are orthogonal.
fn orthogonalising<T: Real>(off: T, difference: T) -> (T, T) {
    let one = T::constant(1.0);
    let ratio = difference * (off + off).recip();
    let tangent = (ratio.abs() + (one + ratio * ratio).sqrt()).recip().copysign(ratio);
    let cosine = (one + tangent * tangent).sqrt().recip();
    (cosine, cosine * tangent)
}

fn rotate<T: Real>(columns: &mut [Vec<T>], [i, j]: [usize; 2], cosine: T, sine: T) {
    for k in 0..columns[i].len() {
        let (x, y) = (columns[i][k], columns[j][k]);
        columns[i][k] = cosine * x - sine * y;
        columns[j][k] = sine * x + cosine * y;
    }
}

impl<T: Real> Decomposed<T> {
    /// Returns the least x with A x = `wanted`, as far as it can be met with the first `rank`
    /// singular values.
    pub fn solved(&self, rank: usize, wanted: &[T]) -> Vec<T> {
        let coefficient = |k: usize| {
            let value = self.values[k];
            dot(&self.images[k], wanted) * (value * value).recip()
        };
        combined(&self.directions[..rank], coefficient)
    }

    /// Returns the least y with Aᵀ y = `wanted`, in the same way.
    pub fn solved_transposed(&self, rank: usize, wanted: &[T]) -> Vec<T> {
        let coefficient = |k: usize| {
            let value = self.values[k];
            dot(&self.directions[k], wanted) * (value * value).recip()
        };
        combined(&self.images[..rank], coefficient)
    }

    /// Returns the ratio of the singular value numbered `rank` to the greatest.
    pub fn ratio(&self, rank: usize) -> f64 {
        self.values.get(rank - 1).map_or(0.0, |value| value.double() / self.values[0].double())
    }
}

fn combined<T: Real>(vectors: &[Vec<T>], coefficient: impl Fn(usize) -> T) -> Vec<T> {
    let mut sum = vec![T::default(); vectors[0].len()];
    for (k, vector) in vectors.iter().enumerate() {
        let factor = coefficient(k);
        sum.iter_mut().zip(vector).for_each(|(sum, x)| *sum += *x * factor);
    }
    sum
}
