//! Operations and masks, lane by lane.

use mstmm::wide::{f32x4, f32x8, f32x16, f64x2, f64x4, f64x8};
use mstmm::{Mask, Scalar};
use mstmm_reference::Random;

use super::numbers::Lanes;

/// Numbers that are special to some operation; random ones follow.
const SPECIAL: [f64; 16] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    0.5,
    -2.5,
    std::f64::consts::PI,
    -std::f64::consts::FRAC_PI_2,
    1e4,
    -3e6,
    1e-30,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::NAN,
    1e300,
    -1e-300,
];

/// Random pairs are as many more.
const RANDOM: u64 = 2000;

fn pairs() -> Vec<(f64, f64)> {
    let special = SPECIAL.iter().flat_map(|&a| SPECIAL.map(|b| (a, b)));
    let mut random = Random::new(1);
    let mut number = || random.between(-20.0, 20.0) * 10f64.powi(random.below(7) as i32 - 3);
    special.chain((0..RANDOM).map(|_| (number(), number()))).collect()
}

/// What a number can do beside another.
fn operations<T: Scalar>(a: T, b: T) -> Vec<(&'static str, T)> {
    let ([sine, other_sine], [cosine, other_cosine]) = T::sin_cos([a, b]);
    let mut sum = a;
    sum += b;
    sum -= a;
    sum *= b;
    let one = |mask: T::Mask| T::select(mask, T::constant(1.0), T::constant(-0.0));
    vec![
        ("sums", sum),
        ("sum", a + b),
        ("difference", a - b),
        ("product", a * b),
        ("opposite", -a),
        ("mul_add", a.mul_add(b, a)),
        ("mul_sub", a.mul_sub(b, a)),
        ("mul_neg_add", a.mul_neg_add(b, a)),
        ("reciprocal", a.recip()),
        ("square root", a.sqrt()),
        ("copied sign", a.copysign(b)),
        ("magnitude", a.abs()),
        ("sine", sine),
        ("cosine", cosine),
        ("other sine", other_sine),
        ("other cosine", other_cosine),
        ("angle", a.atan2(b)),
        ("constant", T::constant(0.1)),
        ("epsilon", T::epsilon()),
        ("selected", T::select(a.simd_gt(b), a, b)),
        ("greater", one(a.simd_gt(b))),
        ("finite", one(a.is_finite())),
        ("not greater", one(!a.simd_gt(b))),
        ("both", one(a.simd_gt(b) & b.is_finite())),
        ("either", one(a.simd_gt(b) | b.is_finite())),
        ("true", one(T::Mask::splat(true))),
        ("false", one(T::Mask::splat(false) | !T::Mask::splat(true))),
    ]
}

fn check_operations<W: Lanes<Real: Lanes>>(name: &str) {
    let mut pairs = pairs().into_iter().cycle();
    // Each pair in another lane in every turn: the count of pairs is no multiple of that of lanes.
    for _ in 0..3 * pairs.clone().take(16).count() * 50 {
        let pairs: Vec<(f64, f64)> = pairs.by_ref().take(W::COUNT).collect();
        let pack = |part: fn(&(f64, f64)) -> f64| {
            W::from_lanes(|lane| Scalar::constant(part(&pairs[lane])))
        };
        let all = operations(pack(|pair| pair.0), pack(|pair| pair.1));
        for (lane, &(a, b)) in pairs.iter().enumerate() {
            let alone = operations(W::Real::constant(a), W::Real::constant(b));
            for (&(what, found), (_, alone)) in all.iter().zip(alone) {
                let (found, alone): (f64, f64) = (found.lane(lane).into(), alone.into());
                let same = found.to_bits() == alone.to_bits() || found.is_nan() && alone.is_nan();
                assert!(same, "{name}: {what} of {a:e} and {b:e} is {found:e}, alone {alone:e}");
            }
        }
    }
}

/// What all lanes decide together.
fn check_decisions<W: Lanes<Real: Lanes>>(name: &str) {
    let number = |value: f64| W::Real::constant(value);
    assert!(W::Mask::splat(true).all() && !W::Mask::splat(false).all(), "{name}");
    for odd in 0..W::COUNT {
        let but = |value: f64| {
            W::from_lanes(|lane| number(if lane == odd { value } else { lane as f64 - 2.5 }))
        };
        let largest: f64 = but(99.0).max_lane().into();
        assert!(largest == 99.0, "{name}, lane {odd}: {largest}");
        let nan: f64 = but(f64::NAN).max_lane().into();
        assert!(nan.is_nan(), "{name}, lane {odd}: {nan}");
        let infinite: f64 = but(f64::INFINITY).max_lane().into();
        assert!(infinite == f64::INFINITY, "{name}, lane {odd}: {infinite}");

        let hundred = W::constant(100.0);
        assert!(hundred.simd_gt(but(99.0)).all(), "{name}, lane {odd}");
        for value in [100.0, 101.0, f64::NAN] {
            assert!(!hundred.simd_gt(but(value)).all(), "{name}, lane {odd}: {value}");
        }
        assert!(but(99.0).is_finite().all(), "{name}, lane {odd}");
        for value in [f64::INFINITY, f64::NEG_INFINITY, f64::NAN] {
            assert!(!but(value).is_finite().all(), "{name}, lane {odd}: {value}");
        }
    }
    let splat = W::splat(number(0.1));
    (0..W::COUNT).for_each(|lane| assert!(splat.lane(lane) == number(0.1), "{name}"));
}

macro_rules! widths {
    ($($test:ident: $lanes:ident;)*) => { $(
        #[test]
        fn $test() {
            check_operations::<$lanes>(stringify!($lanes));
            check_decisions::<$lanes>(stringify!($lanes));
        }
    )* };
}

widths! {
    single_by_4: f32x4;
    single_by_8: f32x8;
    single_by_16: f32x16;
    double_by_2: f64x2;
    double_by_4: f64x4;
    double_by_8: f64x8;
}
