//! Benchmarks of accelerations in both precisions, of z and of all results, and of steps.
//!
//! Each evaluation is at another state, so that no branch can be predicted.

use std::hint::black_box;
use std::time::{Duration, Instant};

use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, Criterion, criterion_group, criterion_main};
use mstmm::wide::{f32x16, f64x8};
use mstmm::{ChainState, Rk4, Scalar};
use mstmm_benches::{
    Balls3, Balls10, Balls100, Case, Lanes, Panda, Pins7, Pins30, Rods3, Rods10, Rods100, Rods1000,
    numbers_of_state, samples, with_cases, with_z,
};

type Group<'a> = BenchmarkGroup<'a, WallTime>;

/// The number of values in all states of a chain, which fit into a cache, and the largest number of
/// states.
const NUMBERS: usize = 1 << 16;
const MOST_STATES: usize = 1024;

/// The step in s.
const STEP: f64 = 1e-3;

criterion_group! {
    name = benches;
    config = Criterion::default()
        .warm_up_time(Duration::from_millis(300))
        .measurement_time(Duration::from_millis(700))
        .sample_size(40);
    targets = all_chains
}
criterion_main!(benches);

macro_rules! groups {
    ($($chain:ident)*) => {
        fn all_chains(criterion: &mut Criterion) {
            let mut group = criterion.benchmark_group("accelerations");
            $(accelerations::<$chain<f64>>(&mut group);)*
            group.finish();
            let mut group = criterion.benchmark_group("accelerations, f32");
            $(accelerations::<$chain<f32>>(&mut group);)*
            group.finish();
            let mut group = criterion.benchmark_group("z");
            $(everything::<with_z::$chain<f64>>(&mut group);)*
            group.finish();
            let mut group = criterion.benchmark_group("everything");
            $(everything::<$chain<f64>>(&mut group);)*
            group.finish();
            let mut group = criterion.benchmark_group("all results, read at all points");
            $(everything_read::<$chain<f64>>(&mut group);)*
            group.finish();
            let mut group = criterion.benchmark_group("RK4 step");
            $(step::<$chain<f64>>(&mut group);)*
            group.finish();
            lanes(criterion);
        }
    };
}
with_cases!(groups);

/// Benchmarks in lanes; times are per state.
fn lanes(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("accelerations, f64x8, a state");
    accelerations::<Balls3<f64x8>>(&mut group);
    accelerations::<Panda<f64x8>>(&mut group);
    group.finish();
    let mut group = criterion.benchmark_group("accelerations, f32x16, a state");
    accelerations::<Balls3<f32x16>>(&mut group);
    accelerations::<Panda<f32x16>>(&mut group);
    group.finish();
}

fn accelerations<C: Case>(group: &mut Group) {
    let (chain, mut rate) = (C::default(), C::State::zero_position());
    bench_each::<C>(group, &chain, |(state, inputs)| {
        let result = chain.accelerations_into(black_box(state), inputs, black_box(&mut rate));
        let _ = black_box(result);
    });
}

fn everything<C: Case>(group: &mut Group) {
    let chain = C::default();
    let mut at = chain.workspace();
    bench_each::<C>(group, &chain, |(state, inputs)| {
        let result = chain.solve_into(black_box(state), inputs, black_box(&mut at));
        let _ = black_box(result);
    });
}

fn everything_read<C: Case>(group: &mut Group) {
    let chain = C::default();
    let mut at = chain.workspace();
    bench_each::<C>(group, &chain, |(state, inputs)| {
        let result = chain.solve_into(black_box(state), inputs, black_box(&mut at));
        let _ = black_box((result, C::points_at(&at)));
    });
}

fn step<C: Case>(group: &mut Group) {
    let chain = C::default();
    let mut rk4 = Rk4::new(Scalar::constant(STEP));
    bench_each::<C>(group, &chain, |(state, inputs)| {
        let mut state = black_box(state).clone();
        let result = rk4.step(&chain, &mut state, |_, _| inputs.clone());
        let _ = black_box((result, &state));
    });
}

fn bench_each<C: Case>(
    group: &mut Group,
    chain: &C,
    mut evaluate: impl FnMut(&(C::State, C::Inputs)),
) {
    let count = (NUMBERS / numbers_of_state::<C::State>()).min(MOST_STATES);
    let samples = samples(chain, count);
    let mut index = 0;
    let mut next = || {
        evaluate(&samples[index]);
        index = if index + 1 == samples.len() { 0 } else { index + 1 };
    };
    let lanes = C::Scalar::COUNT as u64;
    group.bench_function(C::NAME, |bencher| match lanes {
        1 => bencher.iter(&mut next),
        _ => bencher.iter_custom(|states| {
            let start = Instant::now();
            let samples = states.div_ceil(lanes);
            (0..samples).for_each(|_| next());
            start.elapsed().mul_f64(states as f64 / (samples * lanes) as f64)
        }),
    });
}
