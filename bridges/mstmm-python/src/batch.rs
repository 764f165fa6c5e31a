//! Many states: rows of arrays, on all cores.

use std::num::NonZero;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, OnceLock};
use std::thread;

use mstmm::Error;

use crate::blocks::{Blocks, Rows};
use crate::work::Work;

/// The inputs of all states.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Inputs<'a> {
    /// The values; empty if all inputs are zero.
    pub values: &'a [f64],
    /// The distance between two rows; zero if all rows have the same inputs.
    pub row_stride: usize,
    /// The distance between two steps; zero if inputs are held over all steps.
    pub step_stride: usize,
}

/// The arrays of a computation, row by row.
#[derive(Debug)]
pub struct Arrays<'a> {
    /// The number of states.
    pub rows: usize,
    /// Coordinates and rates of each state.
    pub states: &'a [f64],
    /// Inputs.
    pub inputs: Inputs<'a>,
    /// Given values of an answer.
    pub given: &'a [f64],
    /// Results.
    pub results: &'a mut [f64],
}

/// What happens with a state that cannot be computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OnError {
    /// The computation fails.
    Fail,
    /// The results of the state are NaN.
    Nan,
}

/// The number of threads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Threads {
    /// As many as there are cores.
    Cores,
    /// This number.
    Count(NonZero<usize>),
}

/// The reason why a state cannot be computed.
#[derive(Clone, Debug, PartialEq)]
pub struct Failure {
    /// The row of the state.
    pub row: usize,
    /// The step, counted from zero, in an integration.
    pub step: Option<usize>,
    /// The error.
    pub error: Error,
}

/// The states of a chunk of work should be this many at least, times their steps: a thread costs about as much.
const SMALL: usize = 512;

/// The stack of a thread in bytes, for the matrices of long chains.
const STACK: usize = 64 << 20;

/// The number of cores. The system is asked once, because its answer takes as long as some computations of a state.
static CORES: OnceLock<usize> = OnceLock::new();

/// Computes many states of a chain.
#[derive(Clone, Copy, Debug)]
pub struct Batch<'a> {
    /// The chain.
    pub chain: &'a dyn Blocks,
    /// What happens with a state that cannot be computed.
    pub on_error: OnError,
    /// The number of threads. It has no effect on results: rows do not depend on each other.
    pub threads: Threads,
}

impl Batch<'_> {
    /// Computes all rows.
    ///
    /// # Errors
    /// The failure of the first row that fails, unless [`OnError::Nan`] is set.
    pub fn run(&self, work: Work, arrays: Arrays<'_>) -> Result<(), Failure> {
        let Arrays { rows, states, inputs, given, results } = arrays;
        if rows == 0 {
            return Ok(());
        }
        let [state, given_len, result] =
            [states.len(), given.len(), results.len()].map(|len| len / rows);
        let lanes = self.chain.lanes();
        let chunk = self.chunk_size(work, rows, result);
        let first_failure: Mutex<Option<Failure>> = Mutex::new(None);
        let run = |number: usize, results: &mut [f64]| {
            let first = number * chunk;
            let count = chunk.min(rows - first);
            let inputs = Inputs {
                values: inputs.values.get(first * inputs.row_stride..).unwrap_or_default(),
                ..inputs
            };
            let rows = Rows {
                count,
                states: &states[first * state..(first + count) * state],
                inputs,
                given: &given[first * given_len..(first + count) * given_len],
                results,
            };
            if let Err(failure) = self.chain.run(work, rows, self.on_error) {
                let failure = Failure { row: failure.row + first, ..failure };
                let mut known = first_failure.lock().unwrap_or_else(|broken| broken.into_inner());
                if known.as_ref().is_none_or(|known| failure.row < known.row) {
                    *known = Some(failure);
                }
            }
        };
        let chunks = rows.div_ceil(chunk);
        let threads = self.thread_count().min(chunks);
        let is_small = chunks == 1 && result * lanes < 1 << 14;
        if is_small {
            run(0, results);
        } else {
            let parts: Vec<Mutex<&mut [f64]>> =
                results.chunks_mut((chunk * result).max(1)).map(Mutex::new).collect();
            let next = AtomicUsize::new(0);
            let take_all = || {
                while let Some(part) = {
                    let number = next.fetch_add(1, Ordering::Relaxed);
                    parts.get(number).map(|part| (number, part))
                } {
                    let (number, results) = part;
                    let mut results = results.lock().unwrap_or_else(|broken| broken.into_inner());
                    run(number, &mut results);
                }
            };
            thread::scope(|scope| {
                for _ in 0..threads {
                    let thread = thread::Builder::new().stack_size(STACK);
                    if thread.spawn_scoped(scope, take_all).is_err() {
                        // The system has no more threads; those that run do all chunks.
                        break;
                    }
                }
            });
            // If no thread could be started, this one does the work.
            take_all();
        }
        first_failure.into_inner().unwrap_or_else(|broken| broken.into_inner()).map_or(Ok(()), Err)
    }

    fn thread_count(&self) -> usize {
        match self.threads {
            Threads::Count(count) => count.get(),
            Threads::Cores => {
                *CORES.get_or_init(|| thread::available_parallelism().map_or(1, NonZero::get))
            }
        }
    }

    /// Returns the number of rows in a chunk, a multiple of the lanes.
    fn chunk_size(&self, work: Work, rows: usize, result: usize) -> usize {
        let lanes = self.chain.lanes();
        let steps = match work {
            Work::Steps { steps, .. } => steps.max(1),
            // A step with its derivatives costs several steps.
            Work::Pullback(steps) | Work::Pushforward(steps) => {
                steps.count.max(1).saturating_mul(4)
            }
            _ => 1,
        };
        // Several chunks for each thread, so that all end at about the same time.
        let fair = rows.div_ceil(4 * self.thread_count());
        let worthwhile = SMALL.div_ceil(steps.saturating_mul(1 + result / 512));
        fair.max(worthwhile).next_multiple_of(lanes)
    }
}
