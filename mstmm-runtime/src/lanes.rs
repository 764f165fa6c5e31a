//! Lanes of SIMD registers as numbers, by the crate `wide`: a chain of such moves in as many states
//! side by side as there are lanes, each with the bits that it would have alone.

use wide::{f32x4, f32x8, f32x16, f64x2, f64x4, f64x8};
use wide::{u32x4, u32x8, u32x16, u64x2, u64x4, u64x8};

use crate::trig::sin_cos::{self, Quadrant};
use crate::{Mask, Scalar};

/// Implements [`Scalar`] for lanes of a primitive. Operations are those of IEEE 754, lane by lane.
macro_rules! lanes {
    ($($lanes:ident ($($number:literal)*) of $real:ident, bits $bits:ident of $integer:ident, $precision:ident;)*) => { $(
        /// All bits of a lane are set where it is true.
        impl Mask for $lanes {
            #[inline(always)]
            fn splat(value: bool) -> Self {
                $lanes::from_bits($bits::splat(if value { $integer::MAX } else { 0 }))
            }

            #[inline(always)]
            fn all(self) -> bool {
                $lanes::all(self)
            }
        }

        impl Scalar for $lanes {
            type Mask = $lanes;
            type Real = $real;

            // Where there are 32 registers that hold all lanes. Where a value takes several of 16, most
            // are spilled by the compiler all the same, which takes it ten times as long.
            const EXPLICIT_SPILLS: bool = cfg!(target_feature = "avx512f");

            // Not `inline(always)`: see `splat`.
            #[inline]
            fn constant(value: f64) -> Self {
                <Self as Scalar>::splat(value as $real)
            }

            #[inline(always)]
            fn epsilon() -> Self {
                <Self as Scalar>::splat($real::EPSILON)
            }

            #[cfg(all(feature = "fma", any(target_feature = "fma", target_arch = "aarch64")))]
            #[inline(always)]
            fn mul_add(self, factor: Self, addend: Self) -> Self {
                $lanes::mul_add(self, factor, addend)
            }

            #[cfg(all(feature = "fma", any(target_feature = "fma", target_arch = "aarch64")))]
            #[inline(always)]
            fn mul_sub(self, factor: Self, subtrahend: Self) -> Self {
                $lanes::mul_sub(self, factor, subtrahend)
            }

            #[cfg(all(feature = "fma", any(target_feature = "fma", target_arch = "aarch64")))]
            #[inline(always)]
            fn mul_neg_add(self, factor: Self, addend: Self) -> Self {
                $lanes::mul_neg_add(self, factor, addend)
            }

            #[inline(always)]
            fn recip(self) -> Self {
                Self::constant(1.0) / self
            }

            #[inline(always)]
            fn sqrt(self) -> Self {
                $lanes::sqrt(self)
            }

            #[inline(always)]
            fn copysign(self, sign: Self) -> Self {
                $lanes::copysign(self, sign)
            }

            #[inline(always)]
            fn abs(self) -> Self {
                $lanes::abs(self)
            }

            #[inline]
            fn sin_cos<const N: usize>(angles: [Self; N]) -> ([Self; N], [Self; N]) {
                let (mut sines, mut cosines) = ([Self::default(); N], [Self::default(); N]);
                for ((&angle, sine), cosine) in angles.iter().zip(&mut sines).zip(&mut cosines) {
                    (*sine, *cosine) = sin_cos::$precision::one(angle);
                }
                (sines, cosines)
            }

            #[inline]
            fn atan2(self, x: Self) -> Self {
                let (mut angle, x) = (self.to_array(), x.to_array());
                angle.iter_mut().zip(x).for_each(|(y, x)| *y = Scalar::atan2(*y, x));
                $lanes::new(angle)
            }

            #[inline(always)]
            fn greater(self, other: Self) -> Self {
                self.simd_gt(other)
            }

            #[inline(always)]
            fn finite(self) -> Self {
                Self::constant(f64::INFINITY).simd_gt($lanes::abs(self))
            }

            // In four sums: a processor has room for fewer instructions on vectors while it waits.
            #[inline(always)]
            fn total(numbers: &[&[Self]]) -> Self {
                let mut sums = [Self::default(); 4];
                for numbers in numbers {
                    let (blocks, rest) = numbers.as_chunks::<4>();
                    for block in blocks {
                        sums.iter_mut().zip(block).for_each(|(sum, &number)| *sum += number);
                    }
                    sums.iter_mut().zip(rest).for_each(|(sum, &number)| *sum += number);
                }
                let [a, b, c, d] = sums;
                (a + b) + (c + d)
            }

            #[inline(always)]
            fn select(mask: Self, yes: Self, no: Self) -> Self {
                mask.select(yes, no)
            }

            #[inline]
            fn worst(self) -> $real {
                self.to_array().into_iter().fold($real::NEG_INFINITY, |worst, lane| {
                    if worst >= lane || worst.is_nan() { worst } else { lane }
                })
            }

            // Not by an array of copies, `[value; N]`, as in `$lanes::splat`: that is a loop until the compiler
            // is nearly done, and it orders the statements around loops anew.
            //
            // Lanes in several registers are a variable in memory to the compiler, and a number that is written
            // to part of a register reads the rest of it first. To show that this rest is undefined, LLVM's
            // promotion to registers (`PromoteMemToReg`) walks through the block up to the constant, for each
            // constant and lane: the square of the length of a chain. So the copies are
            // put together within this function, which is optimised before LLVM inlines it (`inline(always)` inlines
            // it unoptimised), and the result is that of an operation on whole registers, which changes no bit and
            // of which no instruction remains.
            #[inline]
            fn splat(value: $real) -> Self {
                let mut copies = Self::default();
                $(copies.as_mut_array()[$number] = value;)*
                copies | Self::default()
            }
        }

        impl Quadrant for $lanes {
            #[inline(always)]
            fn turn(sine: Self, cosine: Self, shifted: Self) -> (Self, Self) {
                let (one, two) = ($bits::splat(1), $bits::splat(2));
                let quadrant = shifted.to_bits();
                let odd = $lanes::from_bits((quadrant & one).simd_eq(one));
                let sign = |bits: $bits| $lanes::from_bits((bits & two) << ($integer::BITS - 2));
                (
                    odd.select(cosine, sine) ^ sign(quadrant),
                    odd.select(sine, cosine) ^ sign(quadrant + one),
                )
            }
        }
    )* };
}

lanes! {
    f32x4 (0 1 2 3) of f32, bits u32x4 of u32, single;
    f32x8 (0 1 2 3 4 5 6 7) of f32, bits u32x8 of u32, single;
    f32x16 (0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15) of f32, bits u32x16 of u32, single;
    f64x2 (0 1) of f64, bits u64x2 of u64, double;
    f64x4 (0 1 2 3) of f64, bits u64x4 of u64, double;
    f64x8 (0 1 2 3 4 5 6 7) of f64, bits u64x8 of u64, double;
}
