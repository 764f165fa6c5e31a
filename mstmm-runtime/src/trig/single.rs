//! Sine and cosine in single precision, computed in single precision alone.

use core::f32::consts::FRAC_2_PI;

/// Added to a number below 2²² it leaves no room for a fraction: the sum is rounded to a whole
/// number, which stands in its last bits as two's complement.
const MAGIC: f32 = 12582912.0; // 1.5 · 2²³

/// From this multiple of π/2 on there is no answer: the angle's own last place is a good part of a
/// turn.
const MULTIPLE_LIMIT: f32 = 2097152.0; // 2²¹

/// π/2 in three parts of 11 bits and a rest of 24. Up to 2¹³ times a part is exact.
const PI_HALF: [f32; 4] = [1.5703125, 0.00048398972, -1.6298145e-07, 6.0771006e-11];

/// sin x = x + x³ (S₀ + S₁ x² + …), to 2⁻²⁷·⁹ of sin x.
const SINE: [f32; 3] = [-0.166_666_55, 0.008_332_189, -0.000_195_182_85];

/// cos x = 1 − x²/2 + x⁴ (C₀ + C₁ x² + …), to 2⁻³²·⁹ of cos x.
const COSINE: [f32; 3] = [0.041_666_646, -0.001_388_731, 2.443_232_7e-5];

/// Sines and cosines of all angles, each computed by the same straight line of instructions.
#[inline]
pub(crate) fn sin_cos<const N: usize>(angles: [f32; N]) -> ([f32; N], [f32; N]) {
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
fn reduce(angle: f32) -> ((f32, f32), u32) {
    let shifted = angle * FRAC_2_PI + MAGIC;
    let multiple = shifted - MAGIC;
    let angle = if multiple.abs() < MULTIPLE_LIMIT { angle } else { f32::NAN };
    // Exact, for the angle and the product are close.
    let first = angle - multiple * PI_HALF[0];
    // Beside a multiple of π/2 each further product may exceed all that the ones before it left.
    let (second, lost_second) = two_sum(first, -(multiple * PI_HALF[1]));
    let (third, lost_third) = two_sum(second, -(multiple * PI_HALF[2]));
    let (fourth, lost_fourth) = two_sum(third, -(multiple * PI_HALF[3]));
    (two_sum(fourth, lost_second + (lost_third + lost_fourth)), shifted.to_bits())
}

/// The rounded sum and what rounding took from it, exactly, whichever of the two is larger (Knuth).
#[inline(always)]
fn two_sum(a: f32, b: f32) -> (f32, f32) {
    let sum = a + b;
    let b_part = sum - a;
    (sum, (a - (sum - b_part)) + (b - b_part))
}

/// The sine of x + lo. The leading correction x³/6 is added last, so that only its own rounding is
/// seen beside that of x.
#[inline(always)]
fn sine_near_zero((x, lo): (f32, f32)) -> f32 {
    let square = x * x;
    let cube = square * x;
    let [s0, s1, s2] = SINE;
    let tail = s1 + square * s2;
    // sin(x + lo) = sin x + lo cos x, of which cos x ≈ 1 − x²/2 is enough.
    x - ((square * (0.5 * lo - cube * tail) - lo) - cube * s0)
}

/// The cosine of x + lo. What rounding takes from 1 − x²/2 is put back.
#[inline(always)]
fn cosine_near_zero((x, lo): (f32, f32)) -> f32 {
    let square = x * x;
    let [c0, c1, c2] = COSINE;
    let tail = square * (c0 + square * (c1 + square * c2));
    let half = 0.5 * square;
    let near_one = 1.0 - half;
    // cos(x + lo) = cos x − lo sin x, of which sin x ≈ x is enough.
    near_one + (((1.0 - near_one) - half) + (square * tail - x * lo))
}

/// Sine and cosine after as many quarter turns as the last two bits of `quadrant` say.
#[inline(always)]
fn turn(sine: f32, cosine: f32, quadrant: u32) -> (f32, f32) {
    let odd = quadrant & 1 != 0;
    let (new_sine, new_cosine) = if odd { (cosine, sine) } else { (sine, cosine) };
    let sine_sign = (quadrant & 2) << 30;
    let cosine_sign = (quadrant.wrapping_add(1) & 2) << 30;
    (
        f32::from_bits(new_sine.to_bits() ^ sine_sign),
        f32::from_bits(new_cosine.to_bits() ^ cosine_sign),
    )
}
