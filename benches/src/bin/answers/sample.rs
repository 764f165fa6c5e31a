//! States with the vectors that the questions ask for, and the runs over them.

use std::hint::black_box;
use std::time::Duration;

use mstmm::nalgebra::{SMatrix, SVector};
use mstmm::{ChainState, Error, GeneratedChain, Scalar};
use mstmm_benches::{Lanes, Times};

/// A state, inputs, and vectors of one entry per rate.
pub struct Sample<C: GeneratedChain, V, const N: usize> {
    pub state: C::State,
    pub inputs: C::Inputs,
    pub accelerations: SVector<C::Scalar, N>,
    /// Of coordinates, rates and efforts.
    pub direction: V,
    pub weights: SVector<C::Scalar, N>,
}

/// Returns the samples in numbers, one per lane.
pub fn samples_of<C, V, const N: usize>(
    chain: &C,
    numbers: &[f64],
    set_torques: fn(&mut C::Inputs, &[C::Scalar]),
    direction_of: fn([SVector<C::Scalar, N>; 3]) -> V,
) -> Vec<Sample<C, V, N>>
where
    C: GeneratedChain<Scalar: Lanes>,
    C::State: Default,
{
    let mut state = C::State::zero_position();
    let coordinates = state.coordinates().len();
    let states: Vec<&[f64]> = numbers.chunks_exact(coordinates + 7 * N).collect();
    let side_by_side = |states: &[&[f64]]| {
        let number =
            |index: usize| C::Scalar::from_lanes(|lane| states[lane.min(states.len() - 1)][index]);
        let vector = |part: usize| -> SVector<C::Scalar, N> {
            SVector::from_fn(|i, _| number(coordinates + part * N + i))
        };
        for (index, entry) in state.coordinates_mut().iter_mut().enumerate() {
            *entry = number(index);
        }
        state.rates_mut().copy_from_slice(vector(0).as_slice());
        let mut inputs = chain.no_inputs();
        set_torques(&mut inputs, vector(1).as_slice());
        Sample {
            state: state.clone(),
            inputs,
            accelerations: vector(2),
            direction: direction_of([vector(3), vector(4), vector(5)]),
            weights: vector(6),
        }
    };
    states.chunks(C::Scalar::COUNT).map(side_by_side).collect()
}

/// What to do with an answer.
#[derive(Clone, Copy)]
pub enum Task {
    /// To evaluate it at all states, then to time it for about this time.
    Time(Duration),
    /// To evaluate it a number of times.
    Repeat(usize),
}

/// The results for each state, and the times.
pub struct Run {
    pub results: Vec<f64>,
    pub times: Option<Times>,
}

/// Evaluates an answer; `numbers` returns the numbers of a result.
pub fn perform<T: Lanes, S, R>(
    samples: &[S],
    task: Task,
    mut result: R,
    evaluate: impl Fn(&S, &mut R) -> Result<(), Error>,
    numbers: impl Fn(&R) -> Vec<T>,
) -> Result<Run, Error> {
    let mut results = Vec::new();
    let budget = match task {
        Task::Time(budget) => budget,
        Task::Repeat(count) => {
            for sample in samples.iter().cycle().take(count) {
                evaluate(black_box(sample), black_box(&mut result))?;
            }
            return Ok(Run { results, times: None });
        }
    };
    for sample in samples {
        evaluate(sample, &mut result)?;
        let row = numbers(&result);
        for lane in 0..T::COUNT {
            results.extend(row.iter().map(|number| number.lane(lane)));
        }
    }
    let times = Times::of(budget, samples, T::COUNT, |sample| {
        let evaluated = evaluate(black_box(sample), black_box(&mut result));
        let _ = black_box(evaluated);
    });
    Ok(Run { results, times: Some(times) })
}

/// Returns the entries of a matrix by rows.
pub fn entries<T: Scalar, const R: usize, const C: usize>(matrix: &SMatrix<T, R, C>) -> Vec<T> {
    rows(matrix, C)
}

/// Returns the entries of a matrix's first columns by rows.
pub fn rows<T: Scalar, const R: usize, const C: usize>(
    matrix: &SMatrix<T, R, C>,
    columns: usize,
) -> Vec<T> {
    let row = |row: usize| (0..columns).map(move |column| matrix[(row, column)]);
    (0..R).flat_map(row).collect()
}
