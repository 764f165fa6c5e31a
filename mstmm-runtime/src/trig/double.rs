//! Sine and cosine in double precision.

use core::f64::consts::FRAC_2_PI;

/// Added to a number below 2⁵¹ it leaves no room for a fraction: the sum is rounded to a whole
/// number, which stands in its last bits as two's complement.
const MAGIC: f64 = 6755399441055744.0; // 1.5 · 2⁵²

/// From this multiple of π/2 on there is no answer: the angle's own last place is a good part of a
/// turn.
const MULTIPLE_LIMIT: f64 = 1125899906842624.0; // 2⁵⁰

/// π/2 in two parts of 33 bits and a rest of 53. Up to 2²⁰ times a part is exact; what the product
/// with the rest loses is seen only beside a multiple of π/2, where the parts cancel, and adds up
/// to 0.3 units in the last place for k near 2²⁰.
const PI_HALF: [f64; 3] = [1.5707963267341256, 6.077100506303966e-11, 2.0222662487959506e-21];

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

/// Sines and cosines of all angles, each computed by the same straight line of instructions.
#[inline]
pub(crate) fn sin_cos<const N: usize>(angles: [f64; N]) -> ([f64; N], [f64; N]) {
    let (mut sines, mut cosines) = ([0.0; N], [0.0; N]);
    for ((&angle, sine), cosine) in angles.iter().zip(&mut sines).zip(&mut cosines) {
        let (rest, quadrant) = reduce(angle);
        (*sine, *cosine) = turn(sine_near_zero(rest), cosine_near_zero(rest), quadrant);
    }
    (sines, cosines)
}

/// The angle less the nearest multiple of π/2, as an unevaluated sum of two numbers, and that
/// multiple's last bits.
#[inline(always)]
fn reduce(angle: f64) -> ((f64, f64), u64) {
    let shifted = angle * FRAC_2_PI + MAGIC;
    let multiple = shifted - MAGIC;
    let angle = if multiple.abs() < MULTIPLE_LIMIT { angle } else { f64::NAN };
    // Exact, for the angle and the product are close.
    let first = angle - multiple * PI_HALF[0];
    // Beside a multiple of π/2 each further product may exceed all that the ones before it left.
    let (second, lost_second) = two_sum(first, -(multiple * PI_HALF[1]));
    let (third, lost_third) = two_sum(second, -(multiple * PI_HALF[2]));
    (two_sum(third, lost_second + lost_third), shifted.to_bits())
}

/// The rounded sum and what rounding took from it, exactly, whichever of the two is larger (Knuth).
#[inline(always)]
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let b_part = sum - a;
    (sum, (a - (sum - b_part)) + (b - b_part))
}

/// The sine of x + lo. The leading correction x³/6 is added last, so that only its own rounding is
/// seen beside that of x.
#[inline(always)]
fn sine_near_zero((x, lo): (f64, f64)) -> f64 {
    let square = x * x;
    let cube = square * x;
    let [s0, s1, s2, s3, s4, s5] = SINE;
    let tail = s1 + square * (s2 + square * (s3 + square * (s4 + square * s5)));
    // sin(x + lo) = sin x + lo cos x, of which cos x ≈ 1 − x²/2 is enough.
    x - ((square * (0.5 * lo - cube * tail) - lo) - cube * s0)
}

/// The cosine of x + lo. What rounding takes from 1 − x²/2 is put back.
#[inline(always)]
fn cosine_near_zero((x, lo): (f64, f64)) -> f64 {
    let square = x * x;
    let [c0, c1, c2, c3, c4, c5] = COSINE;
    let tail =
        square * (c0 + square * (c1 + square * (c2 + square * (c3 + square * (c4 + square * c5)))));
    let half = 0.5 * square;
    let near_one = 1.0 - half;
    // cos(x + lo) = cos x − lo sin x, of which sin x ≈ x is enough.
    near_one + (((1.0 - near_one) - half) + (square * tail - x * lo))
}

/// Sine and cosine after as many quarter turns as the last two bits of `quadrant` say.
#[inline(always)]
fn turn(sine: f64, cosine: f64, quadrant: u64) -> (f64, f64) {
    let odd = quadrant & 1 != 0;
    let (new_sine, new_cosine) = if odd { (cosine, sine) } else { (sine, cosine) };
    let sine_sign = (quadrant & 2) << 62;
    let cosine_sign = (quadrant.wrapping_add(1) & 2) << 62;
    (
        f64::from_bits(new_sine.to_bits() ^ sine_sign),
        f64::from_bits(new_cosine.to_bits() ^ cosine_sign),
    )
}
