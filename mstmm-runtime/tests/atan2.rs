//! Errors of the angle of a point, in units in the last place of the true value, over samples,
//! beside the seams of the computation, and at both ends of the range.

mod wide;

use core::f64::consts::{FRAC_PI_2, FRAC_PI_4, FRAC_PI_8, PI};

use mstmm_runtime::Scalar;
use wide::{Wide, random_numbers, sin_cos_of};

/// The runtime's own; `y.atan2(x)` alone would name the one of `std`.
fn atan2<T: Scalar>(y: T, x: T) -> T {
    T::atan2(y, x)
}

/// The angle to about 30 digits: one step of Newton's method from a rounded one, by the point
/// turned back.
fn angle_of(y: f64, x: f64) -> Wide {
    let near = y.atan2(x);
    let (sine, cosine) = sin_cos_of(near);
    let (x, y) = (Wide(x, 0.0), Wide(y, 0.0));
    let across = y.times(cosine).plus(x.times(Wide(-sine.0, -sine.1)));
    let along = x.times(cosine).plus(y.times(sine));
    // The angle left is below 2⁻⁵⁰, so its cube is nothing.
    Wide(near, 0.0).plus(across.over(along.0))
}

/// The largest error over points (y, x), in units in the last place, all signs of theirs included.
fn worst_double(points: impl Iterator<Item = (f64, f64)>) -> f64 {
    let mut worst = 0.0f64;
    for (y, x) in points {
        for (y, x) in [(y, x), (y, -x), (-y, x), (-y, -x)] {
            let angle = atan2(y, x);
            assert!(angle.abs() <= PI && angle.is_sign_negative() == y.is_sign_negative());
            worst = worst.max(angle_of(y, x).ulps(angle, 53));
        }
    }
    worst
}

/// The same in single precision.
fn worst_single(points: impl Iterator<Item = (f64, f64)>) -> f64 {
    let mut worst = 0.0f64;
    for (y, x) in points {
        let (y, x) = (y as f32, x as f32);
        for (y, x) in [(y, x), (y, -x), (-y, x), (-y, -x)] {
            let angle = atan2(y, x);
            let wide = Wide(f64::from(y).atan2(x.into()), 0.0);
            assert!(angle.is_sign_negative() == y.is_sign_negative());
            worst = worst.max(wide.ulps(angle.into(), 24));
        }
    }
    worst
}

/// Points at evenly spaced angles, at many distances.
fn around(count: u32) -> impl Iterator<Item = (f64, f64)> {
    (0..count).map(move |i| {
        let angle = (f64::from(i) + 0.5) / f64::from(count) * FRAC_PI_2;
        let distance = 1.0 + f64::from(i % 977) * 0.37;
        (distance * angle.sin(), distance * angle.cos())
    })
}

/// Points whose ratio spans `decades` powers of ten either way.
fn of_many_ratios(decades: f64, count: usize) -> impl Iterator<Item = (f64, f64)> {
    random_numbers(decades, count)
        .zip(random_numbers(1.0, count + 1).skip(1))
        .map(|(exponent, x)| (10f64.powf(exponent) * (1.5 + x), 1.5 - x))
}

/// Points beside the angles at which the computation changes over, up to a few hundred units in the
/// last place of their ratio in a format of `digits` bits.
fn beside_seams(digits: i32) -> impl Iterator<Item = (f64, f64)> {
    let seams = [FRAC_PI_8.tan(), 1.0, 1.0 / FRAC_PI_8.tan()];
    let units = f64::powi(2.0, 1 - digits);
    seams.into_iter().flat_map(move |seam| {
        (-300..=300).flat_map(move |i| {
            [1.0, 1.2, 1.7].map(|x| (x * seam * (1.0 + f64::from(i) * units), x))
        })
    })
}

#[test]
fn double_is_within_one_unit() {
    let report = [
        worst_double(around(60_000)),
        worst_double(of_many_ratios(2.0, 60_000)),
        worst_double(of_many_ratios(25.0, 20_000)),
        worst_double(beside_seams(53)),
    ];
    assert!(report.iter().all(|&worst| worst < 0.75), "{report:?}");
}

#[test]
fn single_is_within_one_unit() {
    let report = [
        worst_single(around(400_000)),
        worst_single(of_many_ratios(2.0, 400_000)),
        worst_single(of_many_ratios(25.0, 100_000)),
        worst_single(beside_seams(24)),
    ];
    assert!(report.iter().all(|&worst| worst < 0.85), "{report:?}");
}

/// Only the ratio counts: far out and far in the angle is the same to the last bit, as long as both
/// numbers keep all their digits.
#[test]
fn powers_of_two_change_nothing() {
    for (y, x) in around(500).chain(of_many_ratios(20.0, 500)) {
        let angle = atan2(y, x);
        for exponent in [-900, -700, -420, -380, 300, 600, 930, 950] {
            let far = f64::powi(2.0, exponent);
            assert_eq!(atan2(y * far, x * far).to_bits(), angle.to_bits(), "{y} {x} {exponent}");
        }
    }
    for (y, x) in around(500).chain(of_many_ratios(4.0, 500)) {
        let (y, x) = (y as f32, x as f32);
        let angle = atan2(y, x);
        for exponent in [-100, -60, -45, -35, 40, 80, 90, 100] {
            let far = f32::powi(2.0, exponent);
            assert_eq!(atan2(y * far, x * far).to_bits(), angle.to_bits(), "{y} {x} {exponent}");
        }
    }
}

/// A tiny angle is its tangent, down to where it underflows.
#[test]
fn tiny_angles_are_rounded_quotients() {
    for exponent in (200..=1074).step_by(7) {
        let y = 1.1 * f64::powi(2.0, -exponent / 2) * f64::powi(2.0, exponent / 2 - exponent);
        for x in [0.7, 1.0, 1.3, 3e5, 1e200, f64::MAX] {
            assert_eq!(atan2(y, x), y / x, "{y:e} {x:e}");
            assert_eq!(atan2(y, -x), PI);
            assert_eq!(atan2(-x, y), -FRAC_PI_2);
        }
    }
    for exponent in (40..=149).step_by(3) {
        let y = 1.1 * f32::powi(2.0, -exponent / 2) * f32::powi(2.0, exponent / 2 - exponent);
        for x in [0.7, 1.0, 1.3, 3e5, 1e30, f32::MAX] {
            assert_eq!(atan2(y, x), y / x, "{y:e} {x:e}");
            assert_eq!(atan2(y, -x), core::f32::consts::PI);
            assert_eq!(atan2(-x, y), -core::f32::consts::FRAC_PI_2);
        }
    }
    let (least, most) = (f64::from_bits(1), f64::MAX);
    assert_eq!(atan2(least, least), FRAC_PI_4);
    assert_eq!(atan2(most, -most), 3.0 * FRAC_PI_4);
    assert_eq!(atan2(least, most), 0.0);
    assert_eq!(atan2(f32::MAX, f32::MAX), core::f32::consts::FRAC_PI_4);
}

/// The table of IEEE 754, for which the standard library is a reference.
#[test]
fn zeros_and_infinities() {
    let values = [0.0, -0.0, 1.0, -1.0, f64::INFINITY, f64::NEG_INFINITY];
    for y in values {
        for x in values {
            let (angle, expected) = (atan2(y, x), y.atan2(x));
            assert_eq!(angle.to_bits(), expected.to_bits(), "{y} {x}: {angle} {expected}");
            let (y, x) = (y as f32, x as f32);
            let (angle, expected) = (atan2(y, x), y.atan2(x));
            assert_eq!(angle.to_bits(), expected.to_bits(), "{y} {x}: {angle} {expected}");
        }
    }
}

#[test]
fn nan_gives_nan() {
    for other in [0.0, 1.0, f64::MAX, f64::INFINITY, f64::NAN] {
        assert!(atan2(f64::NAN, other).is_nan() && atan2(other, f64::NAN).is_nan());
        let single = other as f32;
        assert!(atan2(f32::NAN, single).is_nan() && atan2(single, f32::NAN).is_nan());
    }
}

/// With sine and cosine it comes back to the angle.
#[test]
fn angles_come_back() {
    for angle in random_numbers(PI, 10_000) {
        let ([sine], [cosine]) = <f64 as Scalar>::sin_cos([angle]);
        // Half a unit of sine and cosine turns the point by as much.
        assert!((atan2(sine, cosine) - angle).abs() <= 2.0 * f64::EPSILON, "{angle}");
    }
}
