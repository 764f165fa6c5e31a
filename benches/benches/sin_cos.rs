//! Sines and cosines of several angles at a time, as in chains, compared with those of `std`.

use std::hint::black_box;
use std::time::Duration;

use criterion::measurement::WallTime;
use criterion::{
    BenchmarkGroup, BenchmarkId, Criterion, Throughput, criterion_group, criterion_main,
};
use mstmm::Scalar;
use mstmm_benches::random_angles;

/// The number of angles, too many for branch prediction.
const ANGLES: usize = 1 << 13;

criterion_group! {
    name = benches;
    config = Criterion::default()
        .warm_up_time(Duration::from_millis(300))
        .measurement_time(Duration::from_millis(700))
        .sample_size(40);
    targets = both_precisions
}
criterion_main!(benches);

fn both_precisions(criterion: &mut Criterion) {
    let angles = random_angles(ANGLES);
    let mut group = criterion.benchmark_group("sin and cos");
    all_counts(&mut group, &angles);
    one_by_one(&mut group, &angles, f64::sin_cos);
    group.finish();

    let angles: Vec<f32> = angles.iter().map(|&angle| angle as f32).collect();
    let mut group = criterion.benchmark_group("sin and cos, f32");
    all_counts(&mut group, &angles);
    one_by_one(&mut group, &angles, f32::sin_cos);
    group.finish();
}

fn all_counts<T: Scalar>(group: &mut BenchmarkGroup<WallTime>, angles: &[T]) {
    side_by_side::<T, 1>(group, angles);
    side_by_side::<T, 3>(group, angles);
    side_by_side::<T, 6>(group, angles);
    side_by_side::<T, 7>(group, angles);
    side_by_side::<T, 8>(group, angles);
    side_by_side::<T, 10>(group, angles);
    side_by_side::<T, 16>(group, angles);
}

fn side_by_side<T: Scalar, const N: usize>(group: &mut BenchmarkGroup<WallTime>, angles: &[T]) {
    let (chunks, _) = angles.as_chunks::<N>();
    let mut index = 0;
    group.throughput(Throughput::Elements(N as u64));
    group.bench_function(BenchmarkId::new("side by side", N), |bencher| {
        bencher.iter(|| {
            index = if index + 1 == chunks.len() { 0 } else { index + 1 };
            T::sin_cos(*black_box(&chunks[index]))
        });
    });
}

fn one_by_one<T: Scalar>(
    group: &mut BenchmarkGroup<WallTime>,
    angles: &[T],
    sin_cos: impl Fn(T) -> (T, T),
) {
    let mut index = 0;
    group.throughput(Throughput::Elements(1));
    group.bench_function("std", |bencher| {
        bencher.iter(|| {
            index = if index + 1 == angles.len() { 0 } else { index + 1 };
            sin_cos(*black_box(&angles[index]))
        });
    });
}
