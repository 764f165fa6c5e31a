//! Lanes of SIMD registers as scalars, by the crate [`wide`].
//!
//! A chain of lanes computes as many states side by side as there are lanes
//! ([`Scalar::LANES`]). Every lane has the bits that it would have in a chain of `f64` or `f32`,
//! except in regressors and after `assemble`: a chain of `f64` or `f32` may compute regressors for several rates at a time,
//! by other sums, and `assemble` corrects all lanes until the last one is closed.
//!
//! [`NativeF64`] and [`NativeF32`] are the widest lanes that fit one register of the target that the crate is built
//! for. They are the fastest for most chains:
//!
//! | target | to build for it | [`NativeF64`] | [`NativeF32`] |
//! |---|---|---|---|
//! | x86-64 | | `f64x2` | `f32x4` |
//! | x86-64 with AVX | `RUSTFLAGS="-C target-cpu=x86-64-v3"` | `f64x4` | `f32x8` |
//! | x86-64 with AVX-512 | `RUSTFLAGS="-C target-cpu=x86-64-v4"` | `f64x8` | `f32x16` |
//! | aarch64 | | `f64x2` | `f32x4` |
//! | WebAssembly with `simd128` | `RUSTFLAGS="-C target-feature=+simd128"` | `f64x2` | `f32x4` |
//! | others, without registers that `wide` uses | | `f64x2` | `f32x4` |
//!
//! `RUSTFLAGS="-C target-cpu=native"` builds for the processor of the machine. The compiler decides, not the machine
//! that runs the program: a program that is built for AVX-512 does not run without AVX-512.
//!
//! ```
//! use mstmm_runtime::Scalar;
//! use mstmm_runtime::lanes::NativeF64;
//!
//! // A start for every state of an ensemble, as many at a time as a register holds.
//! let starts: Vec<f64> = (0..100).map(|index| 0.01 * f64::from(index)).collect();
//! for starts in starts.chunks(NativeF64::LANES) {
//!     let lanes = |lane: usize| starts.get(lane).copied().unwrap_or_default();
//!     let angle = NativeF64::new(std::array::from_fn(lanes));
//!     assert_eq!(angle.as_array()[0], starts[0]);
//! }
//! ```
//!
//! # Limbs of one shape
//!
//! With lanes a single state of `f32` or `f64` is faster, too, if a robot has limbs of one shape: branches that leave the
//! same body over hinges of the same kinds, such as two arms or four mirrored legs. Up to four limbs are computed side by
//! side, one in each lane of [`Scalar::Pack`]. The results are the same, bit for bit except for the sign of zeros. With
//! AVX-512 the accelerations of a quadruped with 18 degrees of freedom cost 0.72, those of a humanoid with 35 degrees of
//! freedom 0.67 of the time without lanes. Parts under `repeat` are computed one after the other.
//!
//! # Lanes that are wider than the registers
//!
//! All lanes of `wide` are scalars on all targets, so a chain of `f64x8` compiles everywhere. Without AVX-512 a value
//! of `f64x8` occupies two or four registers, most values are in memory, and a state costs more time than in
//! [`NativeF64`]. The optimised build costs the compiler two to three times the time of native lanes. For a chain of ten
//! bodies of all hinges, without AVX, in seconds of processor time:
//!
//! | | `f64x2` | `f64x8` | `f32x4` | `f32x16` |
//! |---|---|---|---|---|
//! | `accelerations_into` | 1.1 | 2.4 | 1.3 | 2.9 |
//! | with `Rk4` | 1.4 | 2.9 | 1.4 | 2.8 |
//! | with `solve_into`, without `Rk4` | 1.3 | 3.5 | 1.2 | 3.5 |
//!
//! Unoptimised code of the longest lanes needs a stack of more than 2 MB.

use wide::{f32x4, f32x8, f32x16, f64x2, f64x4, f64x8};
use wide::{u32x4, u32x8, u32x16, u64x2, u64x4, u64x8};

use crate::trig::sin_cos::{self, Quadrant};
use crate::{Columns, Mask, Scalar};

#[cfg(not(target_feature = "avx"))]
use self::{f32x4 as WidestF32, f64x2 as WidestF64};
#[cfg(all(target_feature = "avx", not(target_feature = "avx512f")))]
use self::{f32x8 as WidestF32, f64x4 as WidestF64};
#[cfg(target_feature = "avx512f")]
use self::{f32x16 as WidestF32, f64x8 as WidestF64};

/// The widest lanes of `f64` that fit one register of the target: `f64x2`, with AVX `f64x4`, with AVX-512 `f64x8`.
///
/// [`NativeF64::LANES`](Scalar::LANES) is their number.
pub type NativeF64 = WidestF64;

/// The widest lanes of `f32` that fit one register of the target: `f32x4`, with AVX `f32x8`, with AVX-512 `f32x16`.
///
/// [`NativeF32::LANES`](Scalar::LANES) is their number.
pub type NativeF32 = WidestF32;

/// Whether lanes fit one register of the target.
const fn fits_register<L>() -> bool {
    size_of::<L>() <= size_of::<WidestF64>()
}

/// Calls a function that is not inlined.
///
/// LLVM orders the instructions between two calls, and assigns registers to them, in more than linear time. Lanes of
/// several registers have several times the instructions of native lanes. Calls for the long operations divide a block
/// into short parts and keep the operations out of it. The bits are the same.
#[inline(never)]
fn called<L, R>(lanes: L, function: impl Fn(L) -> R) -> R {
    function(lanes)
}

/// Writes a block of four entries of a column.
#[inline(always)]
fn write_block<T, const R: usize>(column: &mut [T; R], number: usize, entries: [T; 4]) {
    let (blocks, _) = column.as_chunks_mut::<4>();
    if let Some(block) = blocks.get_mut(number) {
        *block = entries;
    }
}

/// Implements [`Scalar`] for lanes of a primitive. Operations are those of IEEE 754, lane by lane.
macro_rules! lanes {
    ($($lanes:ident ($($number:literal)*) of $real:ident, four $four:ident, bits $bits:ident of $integer:ident, $precision:ident;)*) => { $(
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
            type Columns = Self;
            type Pack = Self;

            const LANES: usize = [$($number),*].len();

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
            #[inline]
            fn mul_add(self, factor: Self, addend: Self) -> Self {
                $lanes::mul_add(self, factor, addend)
            }

            // The defaults, but optimised before LLVM inlines them: that spares it a variable in memory for the product.
            #[cfg(not(all(feature = "fma", any(target_feature = "fma", target_arch = "aarch64"))))]
            #[inline]
            fn mul_add(self, factor: Self, addend: Self) -> Self {
                self * factor + addend
            }

            #[cfg(all(feature = "fma", any(target_feature = "fma", target_arch = "aarch64")))]
            #[inline]
            fn mul_sub(self, factor: Self, subtrahend: Self) -> Self {
                $lanes::mul_sub(self, factor, subtrahend)
            }

            #[cfg(not(all(feature = "fma", any(target_feature = "fma", target_arch = "aarch64"))))]
            #[inline]
            fn mul_sub(self, factor: Self, subtrahend: Self) -> Self {
                self * factor - subtrahend
            }

            #[cfg(all(feature = "fma", any(target_feature = "fma", target_arch = "aarch64")))]
            #[inline]
            fn mul_neg_add(self, factor: Self, addend: Self) -> Self {
                $lanes::mul_neg_add(self, factor, addend)
            }

            #[cfg(not(all(feature = "fma", any(target_feature = "fma", target_arch = "aarch64"))))]
            #[inline]
            fn mul_neg_add(self, factor: Self, addend: Self) -> Self {
                addend - self * factor
            }

            // Not `-self`: `wide` flips the sign in integers. A variable that is written in floating point and read in
            // integers costs LLVM a walk through the block, as a constant does: see `splat`. The bits are the same.
            #[inline]
            fn negate(self) -> Self {
                Self::constant(-0.0) - self
            }

            #[inline(always)]
            fn recip(self) -> Self {
                let recip = |divisor| Self::constant(1.0) / divisor;
                if fits_register::<Self>() { recip(self) } else { called(self, recip) }
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
                    (*sine, *cosine) = if fits_register::<Self>() {
                        sin_cos::$precision::one(angle)
                    } else {
                        called(angle, sin_cos::$precision::one)
                    };
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
            fn simd_gt(self, other: Self) -> Self {
                self.simd_gt(other)
            }

            #[inline(always)]
            fn is_finite(self) -> Self {
                Self::constant(f64::INFINITY).simd_gt($lanes::abs(self))
            }

            // In four sums: a processor has room for fewer instructions on vectors while it waits.
            #[inline(always)]
            fn sum(slices: &[&[Self]]) -> Self {
                let mut sums = [Self::default(); 4];
                for values in slices {
                    let (blocks, rest) = values.as_chunks::<4>();
                    for block in blocks {
                        sums.iter_mut().zip(block).for_each(|(sum, &value)| *sum += value);
                    }
                    sums.iter_mut().zip(rest).for_each(|(sum, &value)| *sum += value);
                }
                let [a, b, c, d] = sums;
                (a + b) + (c + d)
            }

            #[inline(always)]
            fn select(mask: Self, if_true: Self, if_false: Self) -> Self {
                mask.select(if_true, if_false)
            }

            #[inline]
            fn max_lane(self) -> $real {
                self.to_array().into_iter().fold($real::NEG_INFINITY, |largest, lane| {
                    if largest >= lane || largest.is_nan() { largest } else { lane }
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

        impl Columns<$real> for $lanes {
            const COUNT: usize = <Self as Scalar>::LANES;

            #[inline(always)]
            fn repeated(value: $real) -> Self {
                Scalar::splat(value)
            }

            #[inline]
            fn from_fn(value: impl Fn(usize) -> $real) -> Self {
                Self::new(core::array::from_fn(value))
            }

            #[inline]
            fn values(self) -> impl Iterator<Item = $real> {
                self.to_array().into_iter()
            }

            // In blocks of four rows and columns: registers are transposed in a few instructions. The columns of a block are
            // written one by one, without a loop, so that the block stays in registers.
            #[inline]
            fn write_columns<const R: usize>(rows: &[Self; R], columns: &mut [[$real; R]]) {
                let (blocks, last_rows) = rows.as_chunks::<4>();
                let (groups, last_columns) = columns.as_chunks_mut::<4>();
                let done = 4 * groups.len();
                for (group, [a, b, c, d]) in groups.iter_mut().enumerate() {
                    let four = |row: &Self| {
                        let (groups, _) = row.as_array().as_chunks::<4>();
                        $four::new(groups.get(group).copied().unwrap_or_default())
                    };
                    for (number, block) in blocks.iter().enumerate() {
                        let [p, q, r, s] = block;
                        let [p, q, r, s] = $four::transpose([four(p), four(q), four(r), four(s)]);
                        write_block(a, number, p.to_array());
                        write_block(b, number, q.to_array());
                        write_block(c, number, r.to_array());
                        write_block(d, number, s.to_array());
                    }
                    for (k, column) in [a, b, c, d].into_iter().enumerate() {
                        let (_, last) = column.as_chunks_mut::<4>();
                        for (entry, row) in last.iter_mut().zip(last_rows) {
                            *entry = row.column(4 * group + k);
                        }
                    }
                }
                for (k, column) in last_columns.iter_mut().enumerate() {
                    for (entry, row) in column.iter_mut().zip(rows) {
                        *entry = row.column(done + k);
                    }
                }
            }

            #[inline]
            fn column(self, column: usize) -> $real {
                self.as_array().get(column).copied().unwrap_or_default()
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
    f32x4 (0 1 2 3) of f32, four f32x4, bits u32x4 of u32, single;
    f32x8 (0 1 2 3 4 5 6 7) of f32, four f32x4, bits u32x8 of u32, single;
    f32x16 (0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15) of f32, four f32x4, bits u32x16 of u32, single;
    f64x2 (0 1) of f64, four f64x4, bits u64x2 of u64, double;
    f64x4 (0 1 2 3) of f64, four f64x4, bits u64x4 of u64, double;
    f64x8 (0 1 2 3 4 5 6 7) of f64, four f64x4, bits u64x8 of u64, double;
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_are_written_from_rows_of_any_number() {
        fn check<L: Columns<T>, T: Scalar, const R: usize>(columns: usize) {
            let value = |row: usize, column: usize| T::constant((100 * row + column) as f64);
            let rows: [L; R] = core::array::from_fn(|row| L::from_fn(|column| value(row, column)));
            let mut written = [[T::constant(-1.0); R]; 16];
            L::write_columns(&rows, &mut written[..columns]);
            for (column, entries) in written.iter().enumerate() {
                for (row, &entry) in entries.iter().enumerate() {
                    let is_there = column < columns && column < L::COUNT;
                    let expected = if is_there { value(row, column) } else { T::constant(-1.0) };
                    assert_eq!(entry, expected, "{R} rows, row {row}, column {column}");
                }
            }
        }
        fn sizes<L: Columns<T>, T: Scalar>() {
            for columns in 0..=L::COUNT {
                check::<L, T, 0>(columns);
                check::<L, T, 1>(columns);
                check::<L, T, 4>(columns);
                check::<L, T, 7>(columns);
                check::<L, T, 18>(columns);
            }
        }
        sizes::<f64, f64>();
        sizes::<f64x2, f64>();
        sizes::<f64x4, f64>();
        sizes::<f64x8, f64>();
        sizes::<f32x4, f32>();
        sizes::<f32x8, f32>();
        sizes::<f32x16, f32>();
    }

    #[test]
    fn the_negative_is_that_of_the_operator_also_of_zeros() {
        fn check<L: Scalar>() {
            let one = L::constant(1.0);
            for number in [0.0, -0.0, 1.5, -1.5, 1e-40, f64::INFINITY, f64::NEG_INFINITY] {
                let number = L::constant(number);
                assert_eq!(number.negate(), -number);
                assert_eq!(one.copysign(number.negate()), one.copysign(-number));
            }
        }
        check::<f64>();
        check::<f64x2>();
        check::<f64x8>();
        check::<f32x4>();
        check::<f32x16>();
    }
}
