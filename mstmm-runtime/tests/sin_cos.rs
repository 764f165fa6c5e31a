//! Errors of sine and cosine, in units in the last place of the true value, over samples and beside
//! multiples of π/2.

mod wide;

use mstmm_runtime::Scalar;
use wide::{Wide, random_numbers, sin_cos_of};

/// The runtime's own; `f64::sin_cos` alone would name the one of `std`.
fn sin_cos<T: Scalar, const N: usize>(angles: [T; N]) -> ([T; N], [T; N]) {
    T::sin_cos(angles)
}

/// The largest error over the angles, in units in the last place.
fn worst_double(angles: impl Iterator<Item = f64>) -> f64 {
    let mut worst = 0.0f64;
    for angle in angles {
        let ([sine], [cosine]) = sin_cos::<f64, _>([angle]);
        let (true_sine, true_cosine) = sin_cos_of(angle);
        assert!(sine.abs() <= 1.0 && cosine.abs() <= 1.0, "{angle}");
        worst = worst.max(if angle == 0.0 { sine.abs() } else { true_sine.ulps(sine, 53) });
        worst = worst.max(true_cosine.ulps(cosine, 53));
    }
    worst
}

/// The largest error over the angles, in units in the last place.
fn worst_single(angles: impl Iterator<Item = f32>) -> f64 {
    let mut worst = 0.0f64;
    for angle in angles {
        let ([sine], [cosine]) = sin_cos::<f32, _>([angle]);
        let wide = f64::from(angle);
        assert!(sine.abs() <= 1.0 && cosine.abs() <= 1.0, "{angle}");
        worst =
            worst.max(if angle == 0.0 { 0.0 } else { Wide(wide.sin(), 0.0).ulps(sine.into(), 24) });
        worst = worst.max(Wide(wide.cos(), 0.0).ulps(cosine.into(), 24));
    }
    worst
}

/// The doubles around every multiple of π/4 up to `multiples`, both signs: there sine or cosine
/// nearly vanishes, or the quadrant changes.
fn beside_multiples(multiples: u32) -> impl Iterator<Item = f64> {
    (1..=multiples).flat_map(|k| {
        let near = f64::from(k) * core::f64::consts::FRAC_PI_4;
        let around = [
            near.next_down().next_down(),
            near.next_down(),
            near,
            near.next_up(),
            near.next_up().next_up(),
        ];
        around.into_iter().flat_map(|x| [x, -x])
    })
}

/// The same for `f32`.
fn beside_multiples_single(multiples: u32) -> impl Iterator<Item = f32> {
    (1..=multiples).flat_map(|k| {
        let near = (f64::from(k) * core::f64::consts::FRAC_PI_4) as f32;
        [near.next_down(), near, near.next_up(), -near.next_down(), -near, -near.next_up()]
    })
}

#[test]
fn double_is_within_one_unit_up_to_ten_thousand() {
    let dense = (-200_000..=200_000).map(|i| f64::from(i) * 5e-5);
    let report = [
        worst_double(dense),
        worst_double(random_numbers(1e4, 400_000)),
        worst_double(random_numbers(1e-3, 20_000)),
        worst_double(beside_multiples(12_740)),
    ];
    assert!(report.iter().all(|&worst| worst < 1.0), "{report:?}");
}

#[test]
fn double_stays_within_two_units_up_to_a_million() {
    let report = [
        worst_double(random_numbers(1e6, 200_000)),
        worst_double(beside_multiples(1_280_000).step_by(3)),
    ];
    assert!(report.iter().all(|&worst| worst < 1.8), "{report:?}");
}

#[test]
fn single_is_within_one_unit_up_to_ten_thousand() {
    let dense = (-200_000..=200_000).map(|i| i as f32 * 5e-5);
    let report = [
        worst_single(dense),
        worst_single(random_numbers(1e4, 1_000_000).map(|x| x as f32)),
        worst_single(beside_multiples_single(12_740)),
    ];
    assert!(report.iter().all(|&worst| worst < 1.0), "{report:?}");
}

#[test]
fn far_out_the_error_is_that_of_the_angle() {
    for range in [1e7, 1e9, 1e12, 1e15] {
        for angle in random_numbers(range, 20_000) {
            let ([sine], [cosine]) = sin_cos::<f64, _>([angle]);
            let (true_sine, true_cosine) = (angle.sin(), angle.cos());
            let bound = angle.abs() * f64::EPSILON + f64::EPSILON;
            assert!(
                (sine - true_sine).abs() < bound && (cosine - true_cosine).abs() < bound,
                "{angle:e}"
            );
        }
    }
    for range in [1e5, 1e6, 3e6] {
        for angle in random_numbers(range, 20_000).map(|x| x as f32) {
            let ([sine], [cosine]) = sin_cos::<f32, _>([angle]);
            let (true_sine, true_cosine) = (f64::from(angle).sin(), f64::from(angle).cos());
            let bound = f64::from(angle.abs() * f32::EPSILON + f32::EPSILON);
            assert!((f64::from(sine) - true_sine).abs() < bound, "{angle:e}");
            assert!((f64::from(cosine) - true_cosine).abs() < bound, "{angle:e}");
        }
    }
}

#[test]
fn angles_without_an_answer_give_nan() {
    let (sines, cosines) =
        sin_cos::<f64, _>([f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 2e15, -1e300, f64::MAX]);
    assert!(sines.iter().chain(&cosines).all(|x| x.is_nan()));
    let (sines, cosines) =
        sin_cos::<f32, _>([f32::NAN, f32::INFINITY, f32::NEG_INFINITY, 4e6, -1e30, f32::MAX]);
    assert!(sines.iter().chain(&cosines).all(|x| x.is_nan()));
}

#[test]
fn zero_and_tiny_angles() {
    let tiny = [0.0, -0.0, f64::MIN_POSITIVE, 5e-324, -1e-200];
    let (sines, cosines) = sin_cos::<f64, _>(tiny);
    assert_eq!(sines, tiny);
    assert_eq!(cosines, [1.0; 5]);
    let (sines, cosines) = sin_cos::<f32, _>([0.0, -0.0, f32::MIN_POSITIVE, 1e-45, -1e-30]);
    assert_eq!(sines, [0.0, -0.0, f32::MIN_POSITIVE, 1e-45, -1e-30]);
    assert_eq!(cosines, [1.0; 5]);
}

#[test]
fn many_angles_give_the_same_bits_as_one() {
    let angles: [f64; 11] = core::array::from_fn(|i| (i as f64 - 5.0) * 1.7);
    let (sines, cosines) = sin_cos::<f64, _>(angles);
    for (i, &angle) in angles.iter().enumerate() {
        assert_eq!(sin_cos::<f64, _>([angle]), ([sines[i]], [cosines[i]]));
    }
    assert_eq!(sin_cos::<f64, _>([]), ([], []));
}
