//! The lanes that fit a register, and how many lanes each type has.

use mstmm::lanes::{NativeF32, NativeF64};
use mstmm::wide::{f32x4, f32x8, f32x16, f64x2, f64x4, f64x8};
use mstmm::{Mask, Scalar};

use super::numbers::Lanes;

#[test]
fn scalars_have_as_many_lanes_as_numbers() {
    fn check<T: Lanes>(lanes: usize) {
        assert_eq!([T::LANES, T::COUNT], [lanes; 2], "{}", std::any::type_name::<T>());
        assert_eq!(size_of::<T>(), lanes * size_of::<T::Real>());
    }
    check::<f32>(1);
    check::<f64>(1);
    check::<f32x4>(4);
    check::<f32x8>(8);
    check::<f32x16>(16);
    check::<f64x2>(2);
    check::<f64x4>(4);
    check::<f64x8>(8);
}

/// The bytes of the widest register that `wide` computes with.
const REGISTER: usize = match (cfg!(target_feature = "avx"), cfg!(target_feature = "avx512f")) {
    (_, true) => 64,
    (true, false) => 32,
    (false, false) => 16,
};

#[test]
fn native_lanes_fill_the_widest_register() {
    assert_eq!([size_of::<NativeF64>(), size_of::<NativeF32>()], [REGISTER; 2]);
    assert_eq!([NativeF64::LANES * 8, NativeF32::LANES * 4], [REGISTER; 2]);
}

#[test]
fn constants_keep_all_bits_in_every_lane() {
    fn check<T: Lanes<Real: Lanes>>() {
        for number in [0.0, -0.0, 0.1, -1e300, f64::INFINITY, f64::NEG_INFINITY, f64::MIN_POSITIVE]
        {
            let (lanes, expected) = (T::constant(number), T::Real::constant(number));
            for lane in 0..T::LANES {
                let found: f64 = lanes.lane(lane).into();
                assert_eq!(found.to_bits(), expected.into().to_bits(), "{number} in lane {lane}");
            }
        }
        let nan = T::constant(f64::NAN);
        assert!((!nan.simd_gt(nan) & !nan.is_finite()).all());
    }
    check::<NativeF64>();
    check::<NativeF32>();
    check::<f64x8>();
    check::<f32x16>();
}
