//! Times of batches, and the files of contenders of `benches/peers`, whose README describes both.

use std::time::{Duration, Instant};

/// The warm-up time of the processor before timing.
const WARM_UP: Duration = Duration::from_millis(5);

/// The shortest time of a batch of evaluations.
const BATCH: Duration = Duration::from_micros(200);

/// Batches with the same number of evaluations, each of one state.
pub struct Times {
    evaluations: usize,
    nanoseconds: Vec<u128>,
}

impl Times {
    /// Times `evaluate` for all samples repeatedly, for about the given time, with a number of states per
    /// sample.
    pub fn of<S>(
        budget: Duration,
        samples: &[S],
        states: usize,
        mut evaluate: impl FnMut(&S),
    ) -> Self {
        let mut samples = samples.iter().cycle();
        let mut batch = |evaluations: usize| {
            let start = Instant::now();
            samples.by_ref().take(evaluations).for_each(&mut evaluate);
            start.elapsed()
        };
        let start = Instant::now();
        while start.elapsed() < WARM_UP {
            batch(1);
        }
        let mut count = 1;
        while batch(count) < BATCH {
            count *= 2;
        }
        let start = Instant::now();
        let mut nanoseconds = vec![batch(count).as_nanos()];
        while start.elapsed() < budget {
            nanoseconds.push(batch(count).as_nanos());
        }
        Self { evaluations: count * states, nanoseconds }
    }

    /// Prints the batches as JSON.
    pub fn print(&self) {
        let Self { evaluations, nanoseconds } = self;
        println!("{{\"evaluations\": {evaluations}, \"nanoseconds\": {nanoseconds:?}}}");
    }
}

/// Converts numbers to the format of files.
pub fn to_bytes(numbers: &[f64]) -> Vec<u8> {
    numbers.iter().flat_map(|number| number.to_le_bytes()).collect()
}

/// Converts the format of files to numbers.
pub fn from_bytes(bytes: &[u8]) -> Vec<f64> {
    let (numbers, _) = bytes.as_chunks();
    numbers.iter().map(|&bytes| f64::from_le_bytes(bytes)).collect()
}
