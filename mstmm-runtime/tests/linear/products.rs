//! Products of matrices of integers, which have no rounding errors.

use super::{Random, converted};
use mstmm_runtime::Scalar;
use mstmm_runtime::linear::negative_product;
use mstmm_runtime::nalgebra::SMatrix;

/// Entries are integers up to 9; sums of N products of two are exact in `f32` too.
fn check<T: Scalar, const N: usize, const M: usize>() {
    for seed in 0..5 {
        let mut random = Random::new(seed);
        let a = random.matrix::<N, N>().map(|x| (9.0 * x).round());
        let d = random.matrix::<N, M>().map(|x| (9.0 * x).round());
        let expected = SMatrix::<f64, N, M>::from_fn(|row, column| {
            -(0..N).map(|k| a[(row, k)] * d[(k, column)]).sum::<f64>()
        });
        let mut result = SMatrix::repeat(T::constant(f64::NAN));
        negative_product::<T, N, M>(&converted(&a), &converted(&d), &mut result);
        assert_eq!(result, converted(&expected), "seed {seed}: {N} × {M}");
    }
}

#[test]
fn products_of_all_sizes_are_exact_for_integers() {
    macro_rules! sizes {
        ($($size:literal)*) => { $(
            check::<f64, $size, { 3 * $size }>();
            check::<f32, $size, { 3 * $size }>();
            check::<f64, $size, 1>();
            check::<f64, $size, 0>();
        )* };
    }
    sizes!(0 1 2 3 4 5 6 7 8 9 12 18);
    #[cfg(feature = "wide")]
    {
        check::<mstmm_runtime::wide::f64x4, 7, 21>();
        check::<mstmm_runtime::wide::f32x16, 9, 27>();
    }
}
