//! Products, linear systems, discrete models and regulators in fixed arrays.

mod common;

#[path = "linear/discrete.rs"]
mod discrete;
#[path = "linear/products.rs"]
mod products;
#[path = "linear/regulator.rs"]
mod regulator;
#[path = "linear/systems.rs"]
mod systems;

use mstmm_runtime::Scalar;
use mstmm_runtime::nalgebra::SMatrix;

/// Random numbers within ±1 (a linear congruential generator).
struct Random(u64);

impl Random {
    fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(2).wrapping_add(1))
    }

    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }

    fn matrix<const R: usize, const C: usize>(&mut self) -> SMatrix<f64, R, C> {
        SMatrix::from_fn(|_, _| self.next())
    }
}

fn converted<T: Scalar, const R: usize, const C: usize>(
    matrix: &SMatrix<f64, R, C>,
) -> SMatrix<T, R, C> {
    matrix.map(T::constant)
}
