//! Products of matrices of integers, which have no rounding errors.

use super::{Random, converted};
use mstmm_runtime::Scalar;
use mstmm_runtime::linear::{negative_product, negative_product_of_rows};
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

/// Pairs of columns: zeros, full, and with other numbers than zero in the first and the last row only. Numbers that are left
/// out must not be read.
#[expect(clippy::single_range_in_vec_init, reason = "a list of ranges")]
fn check_rows<T: Scalar, const N: usize>() {
    let pattern: [(usize, &[_]); 3] = [(2, &[]), (2, &[0..N]), (2, &[0..1, N - 1..N])];
    let counts = |row: usize, column: usize| match column {
        0 | 1 => false,
        2 | 3 => true,
        _ => row == 0 || row == N - 1,
    };
    for seed in 0..5 {
        let mut random = Random::new(seed);
        let a = converted(&random.matrix::<N, N>().map(|x| (9.0 * x).round()));
        let d = random.matrix::<N, 6>().map(|x| (9.0 * x).round());
        let with = |other: f64| {
            let entry = |row, column| if counts(row, column) { d[(row, column)] } else { other };
            converted(&SMatrix::<f64, N, 6>::from_fn(entry))
        };
        let [mut expected, mut result] = [SMatrix::<T, N, 6>::repeat(T::constant(f64::NAN)); 2];
        negative_product(&a, &with(0.0), &mut expected);
        negative_product_of_rows(&a, &with(f64::NAN), &pattern, &mut result);
        assert_eq!(result, expected, "seed {seed}: {N} rows");
    }
}

#[test]
fn products_leave_out_rows() {
    check_rows::<f64, 3>();
    check_rows::<f64, 9>();
    check_rows::<f32, 18>();
    #[cfg(feature = "wide")]
    check_rows::<mstmm_runtime::wide::f64x4, 7>();
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
