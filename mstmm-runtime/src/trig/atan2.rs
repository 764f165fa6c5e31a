//! The angle of a point of the plane: without a branch, without a table, without a fused operation.
//!
//! With the larger of |x| and |y| below and the smaller above, the quotient t lies in [0, 1]; beyond
//! tan(π/8) it is replaced by (t − 1)/(1 + t), the tangent of an angle less by π/4. An odd
//! polynomial gives the arctangent on what is left, [−tan(π/8), tan(π/8)]; the angle is that or its
//! negative, and a multiple of π/4. Numerator, denominator, quotient and that multiple are all kept
//! together with their rounding errors, so that the error is little more than that of the last rounding.
//!
//! The polynomials were fitted like those of sine and cosine, over |t| ≤ 1.0002 tan(π/8).

/// The functions of one precision. The module that calls this macro has its constants.
macro_rules! implementation {
    ($real:ident, $bits:ident) => {
        /// The angle in rad, within ±π, from the x axis to the point (x, y).
        #[inline]
        pub(crate) fn atan2(y: $real, x: $real) -> $real {
            let (above, below) = within_range(x.abs(), y.abs());
            let steep = y.abs().to_bits() > x.abs().to_bits();

            let far = is_negative(FAR * below - above);
            let (top, top_lost) = two_sum(above, -($real::from(far) * below));
            let (bottom, bottom_lost) = two_sum(below, $real::from(far) * above);
            let quotient = top / bottom;
            let (product, product_lost) = two_product(quotient, bottom);
            let rest = ((top - product) - product_lost) + (top_lost - quotient * bottom_lost);
            // Parts of tiny products underflow. A tiny angle is the rounded quotient itself, and
            // beside multiples of π/4 its last place does not matter.
            let precise = u8::from(quotient.abs() > NEGLIGIBLE);
            let quotient_lost = $real::from(precise) * (rest / bottom);

            let square = quotient * quotient;
            let series = ARCTANGENT.iter().rev().fold(0.0, |sum, term| term + square * sum);
            let correction = quotient_lost + quotient * (square * series);

            // So many eighths of a turn, more or less the arctangent.
            let (steep, left) = (u8::from(steep), is_negative(x));
            let eighths = far + 2 * (steep & !far);
            let eighths = eighths + left * (4 - 2 * eighths);
            let eighths = $real::from(eighths);
            let [high, low] = EIGHTH_TURN;
            let back = steep ^ left;
            let (angle, lost) = two_sum(eighths * high, signed(quotient, back));
            (angle + (lost + (eighths * low + signed(correction, back)))).copysign(y)
        }

        /// The lesser and the greater of two numbers that are not negative, so scaled that no product
        /// of theirs leaves the range. They are finite unless the greater one is NaN, which any NaN
        /// is: two infinite numbers are equal, others vanish beside an infinite one, and zero is as
        /// small as can be.
        #[inline(always)]
        fn within_range(a: $real, b: $real) -> ($real, $real) {
            // Bits of numbers that are not negative are in the order of the numbers, NaN the last.
            let (a, b) = (a.to_bits(), b.to_bits());
            let infinite = $real::INFINITY.to_bits();
            let (lesser, greater) = (a.min(b), a.max(b));
            let vanishing = greater == infinite && lesser != infinite;
            let lesser = if vanishing { 0 } else { lesser } - $bits::from(lesser == infinite);
            let greater = greater - $bits::from(greater == infinite) | $bits::from(greater == 0);
            let up = $bits::from(greater < SMALL.to_bits()) * UP;
            let down = $bits::from(greater > LARGE.to_bits()) * DOWN;
            let scale = $real::from_bits((1.0 as $real).to_bits() + up - down);
            ($real::from_bits(lesser) * scale, $real::from_bits(greater) * scale)
        }

        /// One for numbers with the sign of −0, zero for others. Unlike a comparison's answer the
        /// compiler makes no branch of it.
        #[inline(always)]
        fn is_negative(number: $real) -> u8 {
            (number.to_bits() >> ($bits::BITS - 1)) as u8
        }

        /// The number for zero, its negative for one.
        #[inline(always)]
        fn signed(number: $real, negative: u8) -> $real {
            $real::from_bits(number.to_bits() ^ ($bits::from(negative) << ($bits::BITS - 1)))
        }

        /// The rounded sum and its exact rounding error, whichever of the two is larger
        /// (Knuth).
        #[inline(always)]
        fn two_sum(a: $real, b: $real) -> ($real, $real) {
            let sum = a + b;
            let b_part = sum - a;
            (sum, (a - (sum - b_part)) + (b - b_part))
        }

        /// The rounded product and its exact rounding error (Dekker).
        #[inline(always)]
        fn two_product(a: $real, b: $real) -> ($real, $real) {
            let product = a * b;
            let ((a_high, a_low), (b_high, b_low)) = (split(a), split(b));
            let lost = (a_high * b_high - product) + a_high * b_low + a_low * b_high;
            (product, lost + a_low * b_low)
        }

        /// A number as the sum of two of half its digits.
        #[inline(always)]
        fn split(number: $real) -> ($real, $real) {
            let shifted = SPLITTER * number;
            let high = shifted - (shifted - number);
            (high, number - high)
        }
    };
}

/// Double precision.
pub(crate) mod double {
    /// atan t = t + t³ (A₀ + A₁ t² + …), to 2⁻⁵⁹·⁴ of atan t.
    const ARCTANGENT: [f64; 11] = [
        -0.333333333333332,
        0.19999999999953624,
        -0.14285714280191916,
        0.11111110783017761,
        -0.09090897741840152,
        0.07692059902495109,
        -0.06663100323126392,
        0.05847861587303208,
        -0.05039178898041436,
        0.03806137112711811,
        -0.017903745455243255,
    ];

    /// π/4 in a part of 51 bits, as the constant happens to be, small multiples of which are exact,
    /// and a rest.
    const EIGHTH_TURN: [f64; 2] = [core::f64::consts::FRAC_PI_4, 3.061616997868383e-17];

    /// Quotients beyond tan(π/8) are replaced.
    const FAR: f64 = 0.41421356237309503;

    const SPLITTER: f64 = 134217729.0; // 2²⁷ + 1

    /// Quotients up to here need no correction.
    const NEGLIGIBLE: f64 = 1e-120;

    /// Points closer than `SMALL` are scaled by `UP`, 2⁶⁰⁰, those beyond `LARGE` by `DOWN`, 2⁻⁶⁰, so
    /// that no product leaves the range.
    /// What underflows in the latter case has an angle that does, too.
    const SMALL: f64 = 1e-120;
    const UP: u64 = 600 << 52;
    const LARGE: f64 = 1e289;
    const DOWN: u64 = 60 << 52;

    implementation!(f64, u64);
}

/// Single precision, computed in single precision only.
pub(crate) mod single {
    /// atan t = t + t³ (A₀ + A₁ t² + …), to 2⁻³⁰·⁴ of atan t.
    const ARCTANGENT: [f32; 5] =
        [-0.333_333_16, 0.199_985_28, -0.142_443_88, 0.105_991_21, -0.060_898_68];

    /// π/4 in a part of 22 bits, small multiples of which are exact, and a rest.
    const EIGHTH_TURN: [f32; 2] = [f32::from_bits(0x3f49_0fd8), 1.569_582_4e-7];

    /// Quotients beyond tan(π/8) are replaced.
    const FAR: f32 = 0.414_213_57;

    const SPLITTER: f32 = 4097.0; // 2¹² + 1

    /// Quotients up to here need no correction.
    const NEGLIGIBLE: f32 = 1e-9;

    /// Points closer than `SMALL` are scaled by `UP`, 2⁸⁰, those beyond `LARGE` by `DOWN`, 2⁻²⁰, so
    /// that no product leaves the range.
    /// What underflows in the latter case has an angle that does, too.
    const SMALL: f32 = 1e-12;
    const UP: u32 = 80 << 23;
    const LARGE: f32 = 1e33;
    const DOWN: u32 = 20 << 23;

    implementation!(f32, u32);
}
