//! Sine and cosine of many angles side by side.
//!
//! An angle is reduced to [−π/4, π/4] by subtracting the nearest multiple k of π/2, which is kept
//! as a sum of parts with so few digits that k times a part is exact (Cody and Waite 1980). What is
//! left is the sum of two numbers, the second one being what the first cannot hold. Two polynomials
//! give sine and cosine there, and the last two bits of k say which is which, and the signs.
//!
//! The polynomials are minimax fits in relative error over |x| ≤ 1.0001 π/4, by Remez's exchange in
//! 80 digits. Coefficients were rounded one after the other, from the lowest power on, and those
//! left fitted again each time.

use crate::Scalar;

/// c₀ + c₁ z + c₂ z² + … of z and z², in pairs, which hang on each other half as long as Horner's
/// terms. Written out: a loop in the loop over angles would keep that from becoming vector
/// instructions, and so may a closure over the constants.
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

/// The functions of one precision, for a number or for lanes of such. Their constants stand where
/// this is called.
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
            T::turn(sine_near_zero(rest), cosine_near_zero(rest), shifted)
        }

        /// The angle less the nearest multiple of π/2, as an unevaluated sum of two numbers, and a
        /// number whose last bits are those of the multiple.
        #[inline(always)]
        fn reduce<T: Quadrant<Real = $real>>(angle: T) -> ((T, T), T) {
            let magic = T::splat(MAGIC);
            let shifted = angle.mul_add(T::splat(core::$real::consts::FRAC_2_PI), magic);
            let multiple = shifted - magic;
            let answered = T::splat(MULTIPLE_LIMIT).greater(Scalar::abs(multiple));
            let angle = T::select(answered, angle, T::splat($real::NAN));
            // Exact, for the angle and the product are close.
            let left = angle - multiple * T::splat(PI_HALF);
            (less_rest(left, multiple), shifted)
        }

        /// The rounded sum and what rounding took from it, exactly, whichever of the two is larger
        /// (Knuth).
        #[inline(always)]
        fn two_sum<T: Scalar>(a: T, b: T) -> (T, T) {
            let sum = a + b;
            let b_part = sum - a;
            (sum, (a - (sum - b_part)) + (b - b_part))
        }

        /// The sine of x + lo. The leading correction x³/6 is added last, so that only its own
        /// rounding is seen beside that of x.
        #[inline(always)]
        fn sine_near_zero<T: Scalar<Real = $real>>((x, lo): (T, T)) -> T {
            let square = x * x;
            let cube = square * x;
            // sin(x + lo) = sin x + lo cos x, of which cos x ≈ 1 − x²/2 is enough.
            let small = cube.mul_neg_add(sine_tail(square), T::splat(0.5) * lo);
            x - cube.mul_neg_add(T::splat(SINE[0]), square.mul_sub(small, lo))
        }

        /// The cosine of x + lo. What rounding takes from 1 − x²/2 is put back.
        #[inline(always)]
        fn cosine_near_zero<T: Scalar<Real = $real>>((x, lo): (T, T)) -> T {
            let square = x * x;
            let half = T::splat(0.5) * square;
            let near_one = T::splat(1.0) - half;
            // cos(x + lo) = cos x − lo sin x, of which sin x ≈ x is enough.
            let small = (square * square).mul_sub(cosine_tail(square), x * lo);
            near_one + (((T::splat(1.0) - near_one) - half) + small)
        }
    };
}

/// Numbers whose bits say in which quarter of a turn an angle lies.
pub(crate) trait Quadrant: Scalar {
    /// Sine and cosine after as many quarter turns as the last two bits of `shifted` say.
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

/// In double precision.
pub(crate) mod double {
    /// Added to a number below 2⁵¹ it leaves no room for a fraction: the sum is rounded to a whole
    /// number, which stands in its last bits as two's complement.
    const MAGIC: f64 = 6755399441055744.0; // 1.5 · 2⁵²

    /// From this multiple of π/2 on there is no answer: the angle's own last place is a good part of
    /// a turn.
    const MULTIPLE_LIMIT: f64 = 1125899906842624.0; // 2⁵⁰

    /// π/2 in two parts of 33 bits and a rest of 53. Up to 2²⁰ times a part is exact; what the
    /// product with the rest loses is seen only beside a multiple of π/2, where the parts cancel,
    /// and adds up to 0.3 units in the last place for k near 2²⁰.
    const PI_HALF: f64 = 1.5707963267341256;
    const PI_HALF_REST: [f64; 2] = [6.077100506303966e-11, 2.0222662487959506e-21];

    /// sin x = x + x³ (S₀ + S₁ x² + …), to 2⁻⁵⁷·⁸ of sin x.
    const SINE: [f64; 6] = [
        -0.1666666666666663,
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

    /// S₁ + S₂ z + …
    #[inline(always)]
    fn sine_tail<T: Scalar<Real = f64>>(z: T) -> T {
        let ([_, s1, s2, s3, s4, s5], square) = (SINE, z * z);
        polynomial!(z, square: s1 s2 s3 s4 s5)
    }

    /// C₀ + C₁ z + …
    #[inline(always)]
    fn cosine_tail<T: Scalar<Real = f64>>(z: T) -> T {
        let ([c0, c1, c2, c3, c4, c5], square) = (COSINE, z * z);
        polynomial!(z, square: c0 c1 c2 c3 c4 c5)
    }

    /// What is left of an angle less the rest of so many times π/2. Beside a multiple of π/2 each
    /// further product may exceed all that the ones before it left; but where rounding took
    /// anything, what is left exceeds the last product by far.
    #[inline(always)]
    fn less_rest<T: Scalar<Real = f64>>(left: T, multiple: T) -> (T, T) {
        let [near, far] = PI_HALF_REST;
        let (left, lost) = two_sum(left, -(multiple * T::splat(near)));
        two_sum(left, lost - multiple * T::splat(far))
    }

    implementation!(f64);
}

/// In single precision, computed in single precision alone.
pub(crate) mod single {
    /// Added to a number below 2²² it leaves no room for a fraction: the sum is rounded to a whole
    /// number, which stands in its last bits as two's complement.
    const MAGIC: f32 = 12582912.0; // 1.5 · 2²³

    /// From this multiple of π/2 on there is no answer: the angle's own last place is a good part of
    /// a turn.
    const MULTIPLE_LIMIT: f32 = 2097152.0; // 2²¹

    /// π/2 in three parts of 11 bits and a rest of 24. Up to 2¹³ times a part is exact.
    const PI_HALF: f32 = 1.5703125;
    const PI_HALF_REST: [f32; 3] = [0.00048398972, -1.6298145e-07, 6.0771006e-11];

    /// sin x = x + x³ (S₀ + S₁ x² + …), to 2⁻²⁷·⁹ of sin x.
    const SINE: [f32; 3] = [-0.166_666_55, 0.008_332_189, -0.000_195_182_85];

    /// cos x = 1 − x²/2 + x⁴ (C₀ + C₁ x² + …), to 2⁻³²·⁹ of cos x.
    const COSINE: [f32; 3] = [0.041_666_646, -0.001_388_731, 2.443_232_7e-5];

    /// S₁ + S₂ z
    #[inline(always)]
    fn sine_tail<T: Scalar<Real = f32>>(z: T) -> T {
        let [_, s1, s2] = SINE;
        z.mul_add(T::splat(s2), T::splat(s1))
    }

    /// C₀ + C₁ z + C₂ z²
    #[inline(always)]
    fn cosine_tail<T: Scalar<Real = f32>>(z: T) -> T {
        let ([c0, c1, c2], square) = (COSINE, z * z);
        polynomial!(z, square: c0 c1 c2)
    }

    /// What is left of an angle less the rest of so many times π/2, as in double precision.
    #[inline(always)]
    fn less_rest<T: Scalar<Real = f32>>(left: T, multiple: T) -> (T, T) {
        let [near, far, farthest] = PI_HALF_REST;
        let (left, first_lost) = two_sum(left, -(multiple * T::splat(near)));
        let (left, second_lost) = two_sum(left, -(multiple * T::splat(far)));
        two_sum(left, (first_lost + second_lost) - multiple * T::splat(farthest))
    }

    implementation!(f32);
}
