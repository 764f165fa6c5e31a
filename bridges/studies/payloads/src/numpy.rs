//! The random numbers of numpy's `default_rng`, from its documentation: the seeds are mixed by `SeedSequence`, the
//! generator is PCG XSL RR 128/64.

use rand_core::Rng;
use rand_pcg::Pcg64;

/// The number of words in the pool of a `SeedSequence`.
const POOL: usize = 4;

/// The generator of `numpy.random.default_rng(list of integers)`.
#[derive(Clone, Debug)]
pub struct Generator(Pcg64);

impl Generator {
    /// Makes the generator of a list of integers.
    #[must_use]
    pub fn new(seeds: &[u64]) -> Self {
        let words = seeds.iter().flat_map(|seed| words(*seed)).collect::<Vec<u32>>();
        let [a, b, c, d] = state(&pool(&words));
        let wide = |high: u64, low: u64| u128::from(high) << 64 | u128::from(low);
        Generator(Pcg64::new(wide(a, b), wide(c, d)))
    }

    /// Returns the next number of `uniform(low, high)`.
    pub fn uniform(&mut self, low: f64, high: f64) -> f64 {
        // 53 bits.
        let unit = (self.0.next_u64() >> 11) as f64 * (1.0 / (1u64 << 53) as f64);
        low + (high - low) * unit
    }
}

/// Returns the words of an integer, the least significant first, and no further ones than it needs.
fn words(seed: u64) -> impl Iterator<Item = u32> {
    let (low, high) = (seed as u32, (seed >> 32) as u32);
    std::iter::once(low).chain((high != 0).then_some(high))
}

/// A hash whose constant changes with each word.
struct Hash {
    constant: u32,
    factor: u32,
}

impl Hash {
    fn word(&mut self, value: u32) -> u32 {
        let value = value ^ self.constant;
        self.constant = self.constant.wrapping_mul(self.factor);
        let value = value.wrapping_mul(self.constant);
        value ^ value >> 16
    }
}

fn mixed(x: u32, y: u32) -> u32 {
    let mixed = x.wrapping_mul(0xca01_f9dd).wrapping_sub(y.wrapping_mul(0x4973_f715));
    mixed ^ mixed >> 16
}

/// Returns the pool of a `SeedSequence` with this entropy.
fn pool(entropy: &[u32]) -> [u32; POOL] {
    let mut hash = Hash { constant: 0x43b0_d7e5, factor: 0x931e_8875 };
    let mut pool = [0; POOL];
    for (index, word) in pool.iter_mut().enumerate() {
        *word = hash.word(entropy.get(index).copied().unwrap_or(0));
    }
    for from in 0..POOL {
        for to in (0..POOL).filter(|to| *to != from) {
            pool[to] = mixed(pool[to], hash.word(pool[from]));
        }
    }
    for word in entropy.iter().skip(POOL) {
        for place in &mut pool {
            *place = mixed(*place, hash.word(*word));
        }
    }
    pool
}

/// Returns `generate_state(4, uint64)` of a pool.
fn state(pool: &[u32; POOL]) -> [u64; 4] {
    let mut hash = Hash { constant: 0x8b51_f9dd, factor: 0x58f3_8ded };
    let mut words = pool.iter().cycle().map(|word| hash.word(*word));
    let mut next = || words.next().map_or(0, u64::from);
    [(); 4].map(|()| {
        let low = next();
        next() << 32 | low
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers printed by numpy 2.4.6: the bits of `default_rng(seeds).uniform(-0.3, 0.3, 2)`.
    #[test]
    fn numbers_are_those_of_numpy() {
        for (seeds, expected) in NUMBERS {
            let mut random = Generator::new(seeds);
            let found = [(); 2].map(|()| random.uniform(-0.3, 0.3));
            assert_eq!(found, expected.map(f64::from_bits), "{seeds:?}");
        }
    }

    const NUMBERS: [(&[u64], [u64; 2]); 4] = [
        (&[1, 0], [0x3f7d0d85ee248200, 0x3fd14c3d029032cd]),
        (&[0, 0], [0x3fb5098d7cb5db18, 0xbfc1ae2d68a58b75]),
        (&[7, 123456], [0x3f9dd13740fe6270, 0x3fba684f942e63f8]),
        (&[1099511627776, 3, 5, 9, 11], [0xbfc6ab578d20abe4, 0xbfcffd8960b8fb50]),
    ];
}
