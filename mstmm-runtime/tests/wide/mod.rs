//! Numbers of twice the digits, for true values that double precision cannot hold.
#![allow(dead_code, reason = "each test uses a part")]

/// A number of about 32 digits, as an unevaluated sum.
#[derive(Clone, Copy, Debug)]
pub struct Wide(pub f64, pub f64);

impl Wide {
    pub fn sum(a: f64, b: f64) -> Self {
        let sum = a + b;
        let b_part = sum - a;
        Wide(sum, (a - (sum - b_part)) + (b - b_part))
    }

    pub fn product(a: f64, b: f64) -> Self {
        let product = a * b;
        Wide(product, a.mul_add(b, -product))
    }

    pub fn plus(self, other: Self) -> Self {
        let high = Wide::sum(self.0, other.0);
        let low = Wide::sum(self.1, other.1);
        let once = Wide::sum(high.0, high.1 + low.0);
        Wide::sum(once.0, once.1 + low.1)
    }

    pub fn times(self, other: Self) -> Self {
        let product = Wide::product(self.0, other.0);
        Wide::sum(product.0, product.1 + (self.0 * other.1 + self.1 * other.0))
    }

    pub fn over(self, divisor: f64) -> Self {
        let quotient = self.0 / divisor;
        let rest = self.plus(Wide::product(-quotient, divisor));
        Wide::sum(quotient, (rest.0 + rest.1) / divisor)
    }

    /// How far `value` is from this number, in units in the last place of this number in a format
    /// of `digits` bits.
    pub fn ulps(self, value: f64, digits: i32) -> f64 {
        let exponent = (self.0.abs().to_bits() >> 52) as i32 - 1023;
        let error = Wide(self.0, self.1).plus(Wide(-value, 0.0));
        (error.0 + error.1).abs() / f64::powi(2.0, exponent + 1 - digits)
    }
}

/// π/2 as a sum of four doubles, of 212 bits, from π to 100 digits.
const PI_HALF: [f64; 4] = [
    core::f64::consts::FRAC_PI_2,
    6.123233995736766e-17,
    -1.4973849048591698e-33,
    5.562271104316826e-50,
];

/// Sine and cosine to about 30 digits: reduced with 212 bits of π/2, then Taylor's series.
pub fn sin_cos_of(angle: f64) -> (Wide, Wide) {
    let multiple = (angle * core::f64::consts::FRAC_2_PI).round();
    let mut rest = Wide(angle, 0.0);
    for part in PI_HALF {
        rest = rest.plus(Wide::product(-multiple, part));
    }
    let square = rest.times(rest);
    let series = |first: Wide, from: u32| {
        let (mut term, mut total) = (first, first);
        for order in (from..from + 28).step_by(2) {
            term = term.times(square).over(-f64::from(order * (order + 1)));
            total = total.plus(term);
        }
        total
    };
    let (sine, cosine) = (series(rest, 2), series(Wide(1.0, 0.0), 1));
    let negative = |w: Wide| Wide(-w.0, -w.1);
    match multiple.rem_euclid(4.0) as u8 {
        0 => (sine, cosine),
        1 => (cosine, negative(sine)),
        2 => (negative(sine), negative(cosine)),
        _ => (negative(cosine), sine),
    }
}

/// Reproducible numbers, uniform over ±`range` (SplitMix64).
pub fn random_numbers(range: f64, count: usize) -> impl Iterator<Item = f64> {
    let mut seed = 0x005e_ed0f_u64;
    (0..count).map(move |_| {
        seed = seed.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = seed;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        bits ^= bits >> 31;
        ((bits >> 11) as f64 / (1u64 << 52) as f64 - 1.0) * range
    })
}
