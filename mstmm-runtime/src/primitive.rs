//! The primitives `f32` and `f64` as scalars.

use crate::scalar::Scalar;
use crate::trig;

/// Implements [`Scalar`] for a primitive: everything but sine, cosine, angle and square root
/// reads the same for all of them.
macro_rules! primitive {
    ($real:ident, $lanes:ident, $pack:ident, $sin_cos:path, $atan2:path, $libm_sqrt:path) => {
        impl Scalar for $real {
            type Mask = bool;
            type Real = $real;
            #[cfg(feature = "wide")]
            type Columns = crate::lanes::$lanes;
            #[cfg(not(feature = "wide"))]
            type Columns = $real;
            #[cfg(feature = "wide")]
            type Pack = wide::$pack;
            #[cfg(not(feature = "wide"))]
            type Pack = $real;

            #[inline(always)]
            fn constant(value: f64) -> Self {
                value as $real
            }

            #[inline(always)]
            fn epsilon() -> Self {
                $real::EPSILON
            }

            #[cfg(all(feature = "fma", any(target_feature = "fma", target_arch = "aarch64")))]
            #[inline(always)]
            fn mul_add(self, factor: Self, addend: Self) -> Self {
                $real::mul_add(self, factor, addend)
            }

            #[cfg(all(feature = "fma", any(target_feature = "fma", target_arch = "aarch64")))]
            #[inline(always)]
            fn mul_sub(self, factor: Self, subtrahend: Self) -> Self {
                $real::mul_add(self, factor, -subtrahend)
            }

            #[cfg(all(feature = "fma", any(target_feature = "fma", target_arch = "aarch64")))]
            #[inline(always)]
            fn mul_neg_add(self, factor: Self, addend: Self) -> Self {
                $real::mul_add(-self, factor, addend)
            }

            #[inline(always)]
            fn recip(self) -> Self {
                1.0 / self
            }

            // Both are correctly rounded, hence the same bits.
            #[inline(always)]
            fn sqrt(self) -> Self {
                #[cfg(feature = "std")]
                return $real::sqrt(self);
                #[cfg(not(feature = "std"))]
                return $libm_sqrt(self);
            }

            #[inline(always)]
            fn copysign(self, sign: Self) -> Self {
                $real::copysign(self, sign)
            }

            #[inline(always)]
            fn abs(self) -> Self {
                $real::abs(self)
            }

            #[inline]
            fn sin_cos<const N: usize>(angles: [Self; N]) -> ([Self; N], [Self; N]) {
                $sin_cos(angles)
            }

            #[inline]
            fn atan2(self, x: Self) -> Self {
                $atan2(self, x)
            }

            #[inline(always)]
            fn simd_gt(self, other: Self) -> bool {
                self > other
            }

            #[inline(always)]
            fn is_finite(self) -> bool {
                self.is_finite()
            }

            #[inline(always)]
            fn select(mask: bool, if_true: Self, if_false: Self) -> Self {
                if mask { if_true } else { if_false }
            }

            #[inline(always)]
            fn max_lane(self) -> Self {
                self
            }

            #[inline(always)]
            fn splat(value: Self) -> Self {
                value
            }
        }
    };
}

primitive!(
    f32,
    NativeF32,
    f32x4,
    trig::sin_cos::single::sin_cos,
    trig::atan2::single::atan2,
    libm::sqrtf
);
primitive!(
    f64,
    NativeF64,
    f64x4,
    trig::sin_cos::double::sin_cos,
    trig::atan2::double::atan2,
    libm::sqrt
);
