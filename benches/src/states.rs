//! Random states, the same in every run and for every tool.

use std::f64::consts::PI;

use mstmm::ChainState;

use crate::{Case, Lanes};

/// The seed of all states.
const SEED: u64 = 0x6d73_746d_6d20_3031;

/// The rates of a floating base.
pub(crate) const FLOATING: usize = 6;

/// Largest components of a position in m, of a rate in rad/s or m/s and of a torque in N m.
const LARGEST_POSITION: f64 = 1.0;
const LARGEST_RATE: f64 = 2.0;
const LARGEST_TORQUE: f64 = 5.0;

/// Returns a number of states of a case with their inputs.
pub fn samples<C: Case>(chain: &C, count: usize) -> Vec<(C::State, C::Inputs)> {
    let numbers = random_states::<C::State>(count);
    samples_from(chain, &numbers)
}

/// Returns the states in [numbers](random_states), one per lane. If the last states are fewer than the
/// lanes, the last state fills the other lanes.
pub fn samples_from<C: Case>(chain: &C, numbers: &[f64]) -> Vec<(C::State, C::Inputs)> {
    let of_state = numbers_of_state::<C::State>();
    let states: Vec<&[f64]> = numbers.chunks_exact(of_state).collect();
    let side_by_side = |states: &[&[f64]]| {
        let number =
            |index: usize| C::Scalar::from_lanes(|lane| states[lane.min(states.len() - 1)][index]);
        chain.sample((0..of_state).map(number))
    };
    states.chunks(C::Scalar::COUNT).map(side_by_side).collect()
}

/// Returns the number of values of a state: coordinates, rates and torques.
pub fn numbers_of_state<S: ChainState>() -> usize {
    let state = S::zero_position();
    state.coordinates().len() + 2 * state.rates().len()
}

/// Returns a number of states, one after the other: coordinates, rates and torques of all hinges, which
/// are either pins or balls, or pins on a floating base, which comes first and has no effort.
///
/// Angles and orientations are uniformly distributed, so that no branch can be predicted.
pub fn random_states<S: ChainState>(count: usize) -> Vec<f64> {
    let state = S::zero_position();
    let (coordinates, rates) = (state.coordinates().len(), state.rates().len());
    let mut random = Random(SEED);
    let mut numbers = Vec::with_capacity(count * numbers_of_state::<S>());
    for _ in 0..count {
        // An orientation has four numbers, its rate three.
        let (base, pins, balls) = match coordinates - rates {
            0 => (0, coordinates, 0),
            1 => (FLOATING, rates - FLOATING, 0),
            balls => (0, 0, balls),
        };
        if base > 0 {
            numbers.extend([(); 3].map(|()| random.within(LARGEST_POSITION)));
            numbers.extend(random.orientation());
        }
        numbers.extend((0..pins).map(|_| random.within(PI)));
        numbers.extend((0..balls).flat_map(|_| random.orientation()));
        numbers.extend((0..rates).map(|_| random.within(LARGEST_RATE)));
        numbers.extend((0..base).map(|_| 0.0));
        numbers.extend((base..rates).map(|_| random.within(LARGEST_TORQUE)));
    }
    numbers
}

/// Returns a number of random angles in ±π.
pub fn random_angles(count: usize) -> Vec<f64> {
    let mut random = Random(SEED);
    (0..count).map(|_| random.within(PI)).collect()
}

/// Returns a state from such numbers, and the torques.
pub fn state_from<S: ChainState>(
    mut numbers: impl Iterator<Item = S::Scalar>,
) -> (S, Vec<S::Scalar>) {
    let mut state = S::zero_position();
    let (coordinates, rates) = (state.coordinates().len(), state.rates().len());
    for (entry, number) in
        state.coordinates_mut().iter_mut().zip(numbers.by_ref().take(coordinates))
    {
        *entry = number;
    }
    for (entry, number) in state.rates_mut().iter_mut().zip(numbers.by_ref().take(rates)) {
        *entry = number;
    }
    (state, numbers.collect())
}

/// Random numbers by SplitMix64 (Steele, Lea and Flood 2014).
struct Random(u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }

    /// Returns a number uniformly distributed in ±`bound`.
    fn within(&mut self, bound: f64) -> f64 {
        let unit = (self.bits() >> 11) as f64 / (1_u64 << 53) as f64;
        bound * (2.0 * unit - 1.0)
    }

    /// Returns a uniformly distributed unit quaternion: a point in the ball, projected onto its surface.
    fn orientation(&mut self) -> [f64; 4] {
        loop {
            let point = [(); 4].map(|()| self.within(1.0));
            let square: f64 = point.iter().map(|x| x * x).sum();
            if (0.1..=1.0).contains(&square) {
                return point.map(|x| x / square.sqrt());
            }
        }
    }
}
