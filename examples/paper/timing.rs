//! What ways to compute the same thing cost, timed in turns, so that what else the machine does falls on
//! all of them.

use std::hint::black_box;
use std::time::Instant;

use mstmm::{ChainState, Error, GeneratedChain};

/// How long a batch of evaluations is timed in s.
const BATCH: f64 = 1e-3;
/// How many batches of each way serve for most purposes.
pub const BATCHES: usize = 15;

/// A way to compute something once.
pub type Evaluation<'a> = Box<dyn FnMut() + 'a>;

/// What an evaluation by each way takes in s: that of the fastest of so many batches, which other work on
/// the machine has slowed least.
pub fn fastest(ways: &mut [Evaluation], batches: usize) -> Vec<f64> {
    let counts: Vec<u32> = ways.iter_mut().map(|way| evaluations_in(BATCH, way)).collect();
    let mut fastest = vec![f64::INFINITY; ways.len()];
    for _ in 0..batches {
        for ((way, &count), fastest) in ways.iter_mut().zip(&counts).zip(&mut fastest) {
            *fastest = fastest.min(seconds(count, way) / f64::from(count));
        }
    }
    fastest
}

/// How many evaluations take about so long, at least one.
fn evaluations_in(duration: f64, way: &mut Evaluation) -> u32 {
    let mut count = 1;
    while seconds(count, way) < duration && count < 1 << 24 {
        count *= 2;
    }
    count
}

fn seconds(count: u32, way: &mut Evaluation) -> f64 {
    let start = Instant::now();
    for _ in 0..count {
        way();
    }
    start.elapsed().as_secs_f64()
}

/// A generated chain in a pose.
pub struct Generated<'a, C: GeneratedChain> {
    chain: &'a C,
    state: C::State,
    rate: C::State,
    inputs: C::Inputs,
}

impl<'a, C: GeneratedChain<Scalar = f64>> Generated<'a, C> {
    pub fn new(chain: &'a C, angles: &[f64], rates: &[f64]) -> Self {
        let mut state = chain.initial_state();
        state.coordinates_mut().copy_from_slice(angles);
        state.rates_mut().copy_from_slice(rates);
        Generated { chain, state, rate: C::State::default(), inputs: chain.no_inputs() }
    }

    pub fn evaluate(&mut self) -> Result<(), Error> {
        let state = black_box(&self.state);
        self.chain.derivative_into(state, black_box(&self.inputs), black_box(&mut self.rate))
    }

    /// Those of the last evaluation.
    pub fn accelerations(&self) -> &[f64] {
        self.rate.rates()
    }
}

/// The largest difference, of the largest number.
pub fn difference(a: &[f64], b: &[f64]) -> f64 {
    let largest = a.iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
    let differences = a.iter().zip(b).map(|(a, b)| (a - b).abs() / largest);
    differences.max_by(f64::total_cmp).unwrap_or(f64::NAN)
}
