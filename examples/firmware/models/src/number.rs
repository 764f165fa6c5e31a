//! Scalars with comparable bits, and random numbers.

use mstmm::{ChainState, Scalar};

/// A scalar of one lane.
pub trait Number: Scalar<Real = Self, Mask = bool> + From<i16> {
    /// Numbers that a state should not contain, or rarely contains; a step must not take longer for them.
    const BAD: [Self; 7];

    /// Returns its bits.
    fn bits(self) -> u64;
}

macro_rules! number {
    ($real:ident) => {
        impl Number for $real {
            const BAD: [Self; 7] = [
                Self::NAN,
                Self::INFINITY,
                Self::NEG_INFINITY,
                Self::MAX,
                -1e30,
                Self::MIN_POSITIVE / 8.0,
                1e6,
            ];

            fn bits(self) -> u64 {
                self.to_bits().into()
            }
        }
    };
}

number!(f32);
number!(f64);

/// A hash of the bits of many numbers (FNV-1a, a word at a time).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hash(u64);

impl Default for Hash {
    fn default() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }
}

impl Hash {
    /// Adds all coordinates, all rates and the time to the hash.
    pub fn add_state<S: ChainState<Scalar: Number>>(&mut self, state: &S) {
        self.add(state.coordinates().iter().chain(state.rates()).copied().chain([state.time()]));
    }

    /// Adds numbers to the hash.
    pub fn add<T: Number>(&mut self, numbers: impl IntoIterator<Item = T>) {
        self.0 = numbers
            .into_iter()
            .fold(self.0, |hash, number| (hash ^ number.bits()).wrapping_mul(0x0100_0000_01b3));
    }

    /// Returns the hash.
    pub fn value(self) -> u64 {
        self.0
    }
}

/// Random numbers from integer operations, the same on every machine (SplitMix64).
#[derive(Clone, Debug)]
pub struct Random(u64);

impl Random {
    /// Returns a generator with the given seed.
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }

    /// Returns a uniformly distributed multiple of 2⁻¹⁵.
    pub fn between_minus_one_and_one<T: Number>(&mut self) -> T {
        T::from((self.bits() >> 48) as i16) * T::constant(1.0 / 32768.0)
    }
}
