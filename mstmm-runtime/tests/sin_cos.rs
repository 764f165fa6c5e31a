//! Errors of sine and cosine, in units in the last place of the true value, over samples and beside
//! multiples of π/2.

use mstmm_runtime::Scalar;

/// The runtime's own; `f64::sin_cos` alone would name the one of `std`.
fn sin_cos<T: Scalar, const N: usize>(angles: [T; N]) -> ([T; N], [T; N]) {
    T::sin_cos(angles)
}

/// A number of about 32 digits, as an unevaluated sum.
#[derive(Clone, Copy)]
struct Wide(f64, f64);

impl Wide {
    fn sum(a: f64, b: f64) -> Self {
        let sum = a + b;
        let b_part = sum - a;
        Wide(sum, (a - (sum - b_part)) + (b - b_part))
    }

    fn product(a: f64, b: f64) -> Self {
        let product = a * b;
        Wide(product, a.mul_add(b, -product))
    }

    fn plus(self, other: Self) -> Self {
        let high = Wide::sum(self.0, other.0);
        let low = Wide::sum(self.1, other.1);
        let once = Wide::sum(high.0, high.1 + low.0);
        Wide::sum(once.0, once.1 + low.1)
    }

    fn times(self, other: Self) -> Self {
        let product = Wide::product(self.0, other.0);
        Wide::sum(product.0, product.1 + (self.0 * other.1 + self.1 * other.0))
    }

    fn over(self, divisor: f64) -> Self {
        let quotient = self.0 / divisor;
        let rest = self.plus(Wide::product(-quotient, divisor));
        Wide::sum(quotient, (rest.0 + rest.1) / divisor)
    }

    /// How far `value` is from this number, in units in the last place of this number in a format
    /// of `digits` bits.
    fn ulps(self, value: f64, digits: i32) -> f64 {
        let exponent = (self.0.abs().to_bits() >> 52) as i32 - 1023;
        let error = Wide(self.0, self.1).plus(Wide(-value, 0.0));
        (error.0 + error.1).abs() / f64::powi(2.0, exponent + 1 - digits)
    }
}

/// π/2 as a sum of four doubles, of 212 bits, from π to 100 digits.
const PI_HALF: [f64; 4] = [
    core::f64::consts::FRAC_PI_2,
    6.123233995736766e-17,
    -1.4973849048591698e-33,
    5.562271104316826e-50,
];

/// Sine and cosine to about 30 digits: reduced with 212 bits of π/2, then Taylor's series.
fn reference(angle: f64) -> (Wide, Wide) {
    let multiple = (angle * core::f64::consts::FRAC_2_PI).round();
    let mut rest = Wide(angle, 0.0);
    for part in PI_HALF {
        rest = rest.plus(Wide::product(-multiple, part));
    }
    let square = rest.times(rest);
    let series = |first: Wide, from: u32| {
        let (mut term, mut total) = (first, first);
        for order in (from..from + 28).step_by(2) {
            term = term.times(square).over(-f64::from(order * (order + 1)));
            total = total.plus(term);
        }
        total
    };
    let (sine, cosine) = (series(rest, 2), series(Wide(1.0, 0.0), 1));
    let negative = |w: Wide| Wide(-w.0, -w.1);
    match multiple.rem_euclid(4.0) as u8 {
        0 => (sine, cosine),
        1 => (cosine, negative(sine)),
        2 => (negative(sine), negative(cosine)),
        _ => (negative(cosine), sine),
    }
}

/// Reproducible angles, uniform over ±`range` (SplitMix64).
fn random_angles(range: f64, count: usize) -> impl Iterator<Item = f64> {
    let mut seed = 0x005e_ed0f_u64;
    (0..count).map(move |_| {
        seed = seed.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = seed;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        bits ^= bits >> 31;
        ((bits >> 11) as f64 / (1u64 << 52) as f64 - 1.0) * range
    })
}

/// The largest error over the angles, in units in the last place.
fn worst_double(angles: impl Iterator<Item = f64>) -> f64 {
    let mut worst = 0.0f64;
    for angle in angles {
        let ([sine], [cosine]) = sin_cos::<f64, _>([angle]);
        let (true_sine, true_cosine) = reference(angle);
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
        worst_double(random_angles(1e4, 400_000)),
        worst_double(random_angles(1e-3, 20_000)),
        worst_double(beside_multiples(12_740)),
    ];
    assert!(report.iter().all(|&worst| worst < 1.0), "{report:?}");
}

#[test]
fn double_stays_within_eleven_tenths_of_a_unit_up_to_a_million() {
    let report = [
        worst_double(random_angles(1e6, 200_000)),
        worst_double(beside_multiples(1_280_000).step_by(3)),
    ];
    assert!(report.iter().all(|&worst| worst < 1.1), "{report:?}");
}

#[test]
fn single_is_within_one_unit_up_to_ten_thousand() {
    let dense = (-200_000..=200_000).map(|i| i as f32 * 5e-5);
    let report = [
        worst_single(dense),
        worst_single(random_angles(1e4, 1_000_000).map(|x| x as f32)),
        worst_single(beside_multiples_single(12_740)),
    ];
    assert!(report.iter().all(|&worst| worst < 1.0), "{report:?}");
}

#[test]
fn far_out_the_error_is_that_of_the_angle() {
    for range in [1e7, 1e9, 1e12, 1e15] {
        for angle in random_angles(range, 20_000) {
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
        for angle in random_angles(range, 20_000).map(|x| x as f32) {
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
