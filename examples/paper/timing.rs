//! Times of several methods for the same computation. The methods are timed in turns, so that other
//! processes on the machine affect all of them.

use std::hint::black_box;
use std::time::Instant;

use mstmm::{ChainState, Error, GeneratedChain};

/// The duration of a batch of evaluations in s.
const BATCH: f64 = 1e-3;
/// The number of batches of each method for most measurements.
pub const BATCHES: usize = 15;

/// One evaluation by a method.
pub type Evaluation<'a> = Box<dyn FnMut() + 'a>;

/// The time of one evaluation by each method in s: the smallest mean of a batch, which other processes have
/// affected least.
pub fn fastest(methods: &mut [Evaluation], batches: usize) -> Vec<f64> {
    let counts: Vec<u32> =
        methods.iter_mut().map(|evaluation| evaluations_in(BATCH, evaluation)).collect();
    let mut fastest = vec![f64::INFINITY; methods.len()];
    for _ in 0..batches {
        for ((evaluation, &count), fastest) in methods.iter_mut().zip(&counts).zip(&mut fastest) {
            *fastest = fastest.min(seconds(count, evaluation) / f64::from(count));
        }
    }
    fastest
}

/// The number of evaluations that take about `duration` in s, at least one.
fn evaluations_in(duration: f64, evaluation: &mut Evaluation) -> u32 {
    let mut count = 1;
    while seconds(count, evaluation) < duration && count < 1 << 24 {
        count *= 2;
    }
    count
}

fn seconds(count: u32, evaluation: &mut Evaluation) -> f64 {
    let start = Instant::now();
    for _ in 0..count {
        evaluation();
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
        Generated { chain, state, rate: C::State::zero_position(), inputs: chain.no_inputs() }
    }

    pub fn evaluate(&mut self) -> Result<(), Error> {
        let state = black_box(&self.state);
        self.chain.derivative_into(state, black_box(&self.inputs), black_box(&mut self.rate))
    }

    /// The accelerations of the last evaluation.
    pub fn accelerations(&self) -> &[f64] {
        self.rate.rates()
    }
}

/// The largest difference between two lists, relative to the largest value of the first list.
pub fn difference(a: &[f64], b: &[f64]) -> f64 {
    let largest = a.iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
    let differences = a.iter().zip(b).map(|(a, b)| (a - b).abs() / largest);
    differences.max_by(f64::total_cmp).unwrap_or(f64::NAN)
}
