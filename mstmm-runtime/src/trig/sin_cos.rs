//! Sine and cosine of many angles side by side.
//!
//! An angle is reduced to [−π/4, π/4] by subtracting the nearest multiple k of π/2, which is kept
//! as a sum of parts with so few digits that k times a part is exact (Cody and Waite 1980). What is
//! left is the difference of two numbers, the second one being what the first cannot hold. Two
//! polynomials give sine and cosine there, and the last two bits of k say which is which, and the
//! signs.
//!
//! The polynomials are minimax fits in relative error over |x| ≤ 1.0001 π/4, by Remez's exchange in
//! 80 digits. Coefficients were rounded one after the other, from the lowest power on, and those
//! left fitted again each time.

use crate::Scalar;

/// c₀ + c₁ z + c₂ z² + … of z and z², in pairs, which have half the latency of Horner's
/// scheme. It is unrolled, because an inner loop, or a closure over the constants, may keep the loop over angles from
/// becoming vector instructions.
macro_rules! polynomial {
    ($z:ident, $square:ident: $even:ident) => { T::splat($even) };
    ($z:ident, $square:ident: $even:ident $odd:ident $($rest:ident)*) => {{
        let pair = $z.mul_add(T::splat($odd), T::splat($even));
        polynomial!(@ $z, $square: pair $($rest)*)
    }};
    (@ $z:ident, $square:ident: $pair:ident) => { $pair };
    (@ $z:ident, $square:ident: $pair:ident $($rest:ident)+) => {
        $square.mul_add(polynomial!($z, $square: $($rest)+), $pair)
    };
}

/// The functions of one precision, for a number or for lanes of such. The module that
/// calls this macro has their constants.
macro_rules! implementation {
    ($real:ident) => {
        use super::Quadrant;
        use crate::Scalar;
        use crate::trig::side_by_side::side_by_side;

        /// Sines and cosines of all angles, each computed by the same straight line of instructions.
        #[inline]
        pub(crate) fn sin_cos<const N: usize>(angles: [$real; N]) -> ([$real; N], [$real; N]) {
            side_by_side(angles, one)
        }

        /// Sine and cosine of an angle.
        #[inline(always)]
        pub(crate) fn one<T: Quadrant<Real = $real>>(angle: T) -> (T, T) {
            let (rest, shifted) = reduce(angle);
            let (sine, cosine) = near_zero(rest);
            T::turn(sine, cosine, shifted)
        }

        /// The angle less the nearest multiple of π/2, as an unevaluated difference of two numbers,
        /// and a number whose last bits are those of the multiple.
        #[inline(always)]
        fn reduce<T: Quadrant<Real = $real>>(angle: T) -> ((T, T), T) {
            let magic = T::splat(MAGIC);
            let shifted = angle.mul_add(T::splat(core::$real::consts::FRAC_2_PI), magic);
            let multiple = shifted - magic;
            let in_range = T::splat(MULTIPLE_LIMIT).simd_gt(Scalar::abs(multiple));
            // Exact, for the angle and the product are close.
            let left = multiple.mul_neg_add(T::splat(PI_HALF), angle);
            let (x, excess) = less_rest(left, multiple);
            ((x, T::select(in_range, excess, T::splat($real::NAN))), shifted)
        }

        /// `from − multiple · part`, rounded, and by how much that is too large, whichever
        /// of the two is larger (Knuth's sum, the product being exact).
        #[inline(always)]
        fn less_part<T: Scalar>(from: T, multiple: T, part: T) -> (T, T) {
            let difference = multiple.mul_neg_add(part, from);
            let taken = difference - from;
            (difference, multiple.mul_add(part, taken) - (from - (difference - taken)))
        }

        /// Sine and cosine of x − e, where e is small.
        #[inline(always)]
        fn near_zero<T: Scalar<Real = $real>>((x, excess): (T, T)) -> (T, T) {
            let square = x * x;
            let fourth = square * square;
            let near_cosine = square.mul_neg_add(T::splat(0.5), T::splat(1.0));
            // sin(x − e) = sin x − e cos x, of which cos x ≈ 1 − x²/2 is enough.
            let tail = square.mul_add(sine_tail(square, fourth), T::splat(SINE));
            let sine = x - (square * x).mul_neg_add(tail, excess * near_cosine);
            // cos(x − e) = cos x + e sin x, of which sin x ≈ x is enough. What rounding takes from
            // 1 − x²/2 is put back.
            let rounded = square.mul_neg_add(T::splat(0.5), T::splat(1.0) - near_cosine);
            let small = fourth.mul_add(cosine_tail(square, fourth), x.mul_add(excess, rounded));
            (sine, near_cosine + small)
        }
    };
}

/// Numbers whose last bits give the quadrant of an angle.
pub(crate) trait Quadrant: Scalar {
    /// Returns sine and cosine after the number of quarter turns in the last two bits of `shifted`.
    fn turn(sine: Self, cosine: Self, shifted: Self) -> (Self, Self);
}

macro_rules! quadrant {
    ($real:ident, $bits:ident) => {
        impl Quadrant for $real {
            #[inline(always)]
            fn turn(sine: Self, cosine: Self, shifted: Self) -> (Self, Self) {
                let quadrant = shifted.to_bits();
                let odd = quadrant & 1 != 0;
                let (new_sine, new_cosine) = if odd { (cosine, sine) } else { (sine, cosine) };
                let sine_sign = (quadrant & 2) << ($bits::BITS - 2);
                let cosine_sign = (quadrant.wrapping_add(1) & 2) << ($bits::BITS - 2);
                (
                    $real::from_bits(new_sine.to_bits() ^ sine_sign),
                    $real::from_bits(new_cosine.to_bits() ^ cosine_sign),
                )
            }
        }
    };
}

quadrant!(f32, u32);
quadrant!(f64, u64);

/// Double precision.
pub(crate) mod double {
    /// Added to a number below 2⁵¹ it leaves no bits for a fraction: the sum is rounded to an integer, which is in its
    /// last bits as two's complement.
    const MAGIC: f64 = 6755399441055744.0; // 1.5 · 2⁵²

    /// From this multiple of π/2 on the result is NaN: the last place of the angle is a large part of a full rotation.
    const MULTIPLE_LIMIT: f64 = 1125899906842624.0; // 2⁵⁰

    /// π/2 in two parts of 33 bits and a rest of 53. Up to 2²⁰ times a part is exact. Up to 10⁴ rad
    /// k times the rest stays below a unit in the last place of what is left; for k near 2²⁰ it is
    /// ten, of which the polynomials leave out one.
    const PI_HALF: f64 = 1.5707963267341256;
    const PI_HALF_REST: [f64; 2] = [6.077100506303966e-11, 2.0222662487959506e-21];

    /// sin x = x + x³ (S₀ + S₁ x² + …), to 2⁻⁵⁷·⁸ of sin x.
    const SINE: f64 = -0.1666666666666663;
    const SINE_TAIL: [f64; 5] = [
        0.00833333333332184,
        -0.00019841269829358528,
        2.7557313538514234e-06,
        -2.5050734389257543e-08,
        1.5895433289345202e-10,
    ];

    /// cos x = 1 − x²/2 + x⁴ (C₀ + C₁ x² + …), to 2⁻⁶³·⁹ of cos x.
    const COSINE: [f64; 6] = [
        0.041666666666666595,
        -0.0013888888888873338,
        2.480158728899748e-05,
        -2.7557314215299134e-07,
        2.087570511500033e-09,
        -1.1358732776601736e-11,
    ];

    /// S₁ + S₂ z + … of z and z².
    #[inline(always)]
    fn sine_tail<T: Scalar<Real = f64>>(z: T, square: T) -> T {
        let [s1, s2, s3, s4, s5] = SINE_TAIL;
        polynomial!(z, square: s1 s2 s3 s4 s5)
    }

    /// C₀ + C₁ z + … of z and z².
    #[inline(always)]
    fn cosine_tail<T: Scalar<Real = f64>>(z: T, square: T) -> T {
        let [c0, c1, c2, c3, c4, c5] = COSINE;
        polynomial!(z, square: c0 c1 c2 c3 c4 c5)
    }

    /// What is left of an angle less the rest of so many times π/2, as x − e. Beside a multiple of
    /// π/2, e may exceed x; then both are so small that only their difference matters.
    #[inline(always)]
    fn less_rest<T: Scalar<Real = f64>>(left: T, multiple: T) -> (T, T) {
        let [near, far] = PI_HALF_REST;
        let (left, excess) = less_part(left, multiple, T::splat(near));
        (left, multiple.mul_add(T::splat(far), excess))
    }

    implementation!(f64);
}

/// Single precision, computed in single precision only.
pub(crate) mod single {
    /// Added to a number below 2²² it leaves no bits for a fraction: the sum is rounded to an integer, which is in its
    /// last bits as two's complement.
    const MAGIC: f32 = 12582912.0; // 1.5 · 2²³

    /// From this multiple of π/2 on the result is NaN: the last place of the angle is a large part of a full rotation.
    const MULTIPLE_LIMIT: f32 = 2097152.0; // 2²¹

    /// π/2 in three parts of 11 bits and a rest of 24. Up to 2¹³ times a part is exact.
    const PI_HALF: f32 = 1.5703125;
    const PI_HALF_REST: [f32; 3] = [0.00048398972, -1.6298145e-07, 6.0771006e-11];

    /// sin x = x + x³ (S₀ + S₁ x² + …), to 2⁻²⁷·⁹ of sin x.
    const SINE: f32 = -0.166_666_55;
    const SINE_TAIL: [f32; 2] = [0.008_332_189, -0.000_195_182_85];

    /// cos x = 1 − x²/2 + x⁴ (C₀ + C₁ x² + …), to 2⁻³²·⁹ of cos x.
    const COSINE: [f32; 3] = [0.041_666_646, -0.001_388_731, 2.443_232_7e-5];

    /// S₁ + S₂ z of z and z².
    #[inline(always)]
    fn sine_tail<T: Scalar<Real = f32>>(z: T, _: T) -> T {
        let [s1, s2] = SINE_TAIL;
        z.mul_add(T::splat(s2), T::splat(s1))
    }

    /// C₀ + C₁ z + C₂ z² of z and z².
    #[inline(always)]
    fn cosine_tail<T: Scalar<Real = f32>>(z: T, square: T) -> T {
        let [c0, c1, c2] = COSINE;
        polynomial!(z, square: c0 c1 c2)
    }

    /// What is left of an angle less the rest of so many times π/2, as in double precision.
    #[inline(always)]
    fn less_rest<T: Scalar<Real = f32>>(left: T, multiple: T) -> (T, T) {
        let [near, far, farthest] = PI_HALF_REST;
        let (left, first) = less_part(left, multiple, T::splat(near));
        let (left, second) = less_part(left, multiple, T::splat(far));
        // The excess is up to 4e-7 and would be seen in what `near_zero` leaves out.
        let excess = multiple.mul_add(T::splat(farthest), first + second);
        less_part(left, excess, T::splat(1.0))
    }

    implementation!(f32);
}
