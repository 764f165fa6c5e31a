//! A small generator of repeatable random numbers.

/// A seeded generator (SplitMix64). The same seed always gives the same numbers, so a failing test
/// can name its seed.
#[derive(Clone, Debug)]
pub struct Random {
    state: u64,
}

impl Random {
    /// Returns a generator with the given seed.
    pub fn new(seed: u64) -> Random {
        Random { state: seed }
    }

    /// Returns a generator of other numbers. The sequence of this one stays as it is.
    pub fn beside(&self) -> Random {
        Random { state: self.state ^ 0x5851_F42D_4C95_7F2D }
    }

    /// Returns the next 64 random bits.
    pub fn bits(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut mixed = self.state;
        mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        mixed ^ (mixed >> 31)
    }

    /// Returns a number that is uniformly distributed from `low` to `high`.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        let fraction = (self.bits() >> 11) as f64 / (1_u64 << 53) as f64;
        low + (high - low) * fraction
    }

    /// Returns a number like [`Random::between`], rounded to the given number of decimals and never a
    /// negative zero.
    pub fn rounded(&mut self, low: f64, high: f64, decimals: i32) -> f64 {
        round_to(self.between(low, high), decimals)
    }

    /// Returns `true` with the given probability.
    pub fn chance(&mut self, probability: f64) -> bool {
        self.between(0.0, 1.0) < probability
    }

    /// Returns a number below `count`, which must not be zero.
    pub fn below(&mut self, count: usize) -> usize {
        // The bias is negligible, since counts are small compared with 2⁶⁴.
        (self.bits() % count as u64) as usize
    }

    /// Returns one of `choices`, which must not be empty.
    pub fn choose<'a, T>(&mut self, choices: &'a [T]) -> &'a T {
        &choices[self.below(choices.len())]
    }
}

/// Rounds to a number of decimals and replaces a negative zero by zero.
pub(crate) fn round_to(value: f64, decimals: i32) -> f64 {
    let scale = 10_f64.powi(decimals);
    (value * scale).round() / scale + 0.0
}
