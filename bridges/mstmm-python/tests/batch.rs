//! Rows of a batch have the bits of the chain in `f64`, for any number of threads.
#![allow(missing_docs)]

use std::num::NonZero;

use mstmm::{ChainState, Described, Error, Rk4, mstmm_chain};
use mstmm_python::{
    Arrays, Batch, Blocks, Inputs, Lanes, Method, Model, OnError, Steps, Threads, Work,
};

mstmm_chain! {
    /// A pin and a ball.
    pub chain Arm {
        gravity = [0, 0, -9.81] m/s^2;
        body Rod { mass = 1 kg; com = [0.5, 0.1, 0] m; inertia = diag(0.1, 0.2, 0.15) kg*m^2 about com; output = [1, 0, 0] m; }
        ground -> pin(y) a -> Rod upper -> ball b -> Rod lower;
        hinge a { torque = input; }
    }
}

mstmm_chain! {
    /// A chain without degrees of freedom.
    pub chain Plate {
        answers = [push, pull];
        body Slab { mass = 1 kg; com = [0, 0, 0] m; inertia = diag(0.1, 0.1, 0.1) kg*m^2 about com; }
        ground -> weld foot -> Slab slab;
    }
}

mstmm_python::module!(arm: Arm);

const ROWS: usize = 77;
const STEPS: usize = 25;
const NX: usize = 9;

/// Returns states with rates, in the order of rows.
fn states() -> Vec<f64> {
    let start = Model::<Arm<Lanes>>::default().start();
    assert_eq!(start.len(), NX);
    let mut bits = 0x1234_5678_u64; // the seed of a linear congruential generator
    let mut random = || {
        bits = bits.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (bits >> 33) as f64 / f64::from(1u32 << 31) - 0.5
    };
    (0..ROWS * NX)
        .map(|index| match index % NX {
            // Quaternions stay unit.
            entry @ 1..5 => start[entry],
            entry => start[entry] + random(),
        })
        .collect()
}

fn run(work: Work, states: &[f64], threads: usize, on_error: OnError) -> Result<Vec<f64>, String> {
    let chain = Model::<Arm<Lanes>>::default();
    let len = match work {
        Work::Steps { every: 0, .. } => NX,
        Work::Steps { steps, every, .. } => NX * (steps / every + 1),
        Work::Accelerations => 4,
        _ => 2,
    };
    let inputs: Vec<f64> = (0..ROWS).map(|row| 0.1 * row as f64).collect();
    let mut results = vec![0.0; ROWS * len];
    let threads = NonZero::new(threads).map_or(Threads::Cores, Threads::Count);
    let arrays = Arrays {
        rows: ROWS,
        states,
        inputs: Inputs { values: &inputs, row_stride: 1, step_stride: 0 },
        given: &[],
        results: &mut results,
    };
    let batch = Batch { chain: &chain, on_error, threads };
    batch.run(work, arrays).map_err(|failure| format!("{failure:?}"))?;
    Ok(results)
}

const RK4: Work = Work::Steps { method: Method::Rk4, step: 1e-2, steps: STEPS, every: 0 };

#[test]
fn rows_have_the_bits_of_one_state() -> Result<(), Error> {
    let states = states();
    let together = run(RK4, &states, 0, OnError::Fail).expect("states that can be computed");
    let chain = Arm::<f64>::new();
    for (row, start) in states.chunks(NX).enumerate() {
        let mut state = chain.initial_state();
        state.coordinates_mut().copy_from_slice(&start[..5]);
        state.rates_mut().copy_from_slice(&start[5..]);
        let inputs = Arm::<f64>::inputs_from_slice(&[0.1 * row as f64]).expect("one input");
        let mut rk4 = Rk4::new(1e-2);
        for _ in 0..STEPS {
            rk4.step_held(&chain, &mut state, &inputs)?;
        }
        let single: Vec<f64> = state.coordinates().iter().chain(state.rates()).copied().collect();
        let bits = |values: &[f64]| values.iter().map(|it| it.to_bits()).collect::<Vec<_>>();
        assert_eq!(bits(&single), bits(&together[row * NX..][..NX]), "row {row}");
    }
    Ok(())
}

#[test]
fn any_number_of_threads_gives_the_same_bits() {
    let states = states();
    for work in [RK4, Work::Accelerations, Work::Energies] {
        let one = run(work, &states, 1, OnError::Fail);
        for threads in [2, 3, 8, 200] {
            assert_eq!(run(work, &states, threads, OnError::Fail), one);
        }
    }
}

#[test]
fn recorded_states_are_those_of_single_steps() {
    let states = states();
    let every = 5;
    let work = Work::Steps { method: Method::Rk4, step: 1e-2, steps: STEPS, every };
    let recorded = run(work, &states, 2, OnError::Fail).expect("states that can be computed");
    for place in 0..=STEPS / every {
        let work = Work::Steps { method: Method::Rk4, step: 1e-2, steps: place * every, every: 0 };
        let expected = run(work, &states, 1, OnError::Fail).expect("states");
        for row in 0..ROWS {
            let at = (row * (STEPS / every + 1) + place) * NX;
            assert_eq!(recorded[at..at + NX], expected[row * NX..][..NX], "row {row}");
        }
    }
}

#[test]
fn the_first_row_that_fails_is_reported_and_others_are_computed() {
    let mut states = states();
    let good = run(RK4, &states, 1, OnError::Fail).expect("states that can be computed");
    for row in [19, 40] {
        states[row * NX] = f64::NAN;
    }
    for threads in [1, 4] {
        let failed = run(RK4, &states, threads, OnError::Fail).expect_err("two states are NaN");
        assert_eq!(failed, "Failure { row: 19, step: Some(0), error: NotFinite(Coordinate(0)) }");
        let rest = run(RK4, &states, threads, OnError::Nan).expect("NaN for those that fail");
        for row in 0..ROWS {
            let values = &rest[row * NX..][..NX];
            match row {
                19 | 40 => assert!(values.iter().all(|value| value.is_nan())),
                _ => assert_eq!(values, &good[row * NX..][..NX], "row {row}"),
            }
        }
    }
}

#[test]
fn a_chain_without_degrees_of_freedom_has_empty_results() {
    let chain = Model::<Plate<Lanes>>::default();
    let steps = Steps { step: 1e-2, count: STEPS };
    for work in [RK4, Work::Accelerations, Work::Pullback(steps), Work::Pushforward(steps)] {
        for rows in [0, 1, ROWS] {
            let inputs = Inputs { values: &[], row_stride: 0, step_stride: 0 };
            let arrays = Arrays { rows, states: &[], inputs, given: &[], results: &mut [] };
            let batch = Batch { chain: &chain, on_error: OnError::Fail, threads: Threads::Cores };
            assert_eq!(batch.run(work, arrays), Ok(()), "{work:?}, {rows} rows");
        }
    }
}
