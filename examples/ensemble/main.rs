//! The study of payloads of `bridges/studies` on one machine: many robot arms with random payloads under the same
//! controller, in SIMD lanes on all cores. Compares the speed with that of single arms, and reports the final position
//! errors and the hash of all results, which is that of the study on many machines.
//!
//! `cargo run --release --example ensemble -- --help` lists the options.

mod output;
mod run;

use std::error::Error;
use std::process::ExitCode;

use clap::Parser;

use mstmm_payloads::{RESULTS, Sample, digest, summary};
use output::Spread;
use run::{DOUBLE, ONE_BY_ONE, Progress, Run, SINGLE};

/// The number of arms that are also simulated one by one, and in shorter steps, for comparison.
const SAMPLE: usize = 64;

/// The fraction of the arms that is simulated to measure the speed of a scalar type.
const TRIED: usize = 40;
const ALONE: usize = 10;

/// Simulates Franka Emika Pandas with random payloads and starts, whose controller moves them to the
/// same pose, and reports how far from this pose they stop.
///
/// Each SIMD register holds several arms. A fraction of the arms is simulated in lanes of other widths
/// and one by one, and the steps per second of each are reported.
/// `RUSTFLAGS="-C target-cpu=native"` uses the widest registers. Fails if the results of an arm in
/// lanes and alone differ in any bit.
#[derive(Parser)]
#[command(name = "ensemble")]
struct Arguments {
    /// Number of arms
    #[arg(long, default_value_t = 100_000, value_parser = clap::value_parser!(u32).range(1..))]
    arms: u32,

    /// Arms in a chunk, which a core simulates at a time; it has no effect on results
    #[arg(long, default_value_t = 64, value_parser = clap::value_parser!(u32).range(1..))]
    chunk: u32,

    /// Seed of the random payloads and starts
    #[arg(long, default_value_t = 1)]
    seed: u64,

    /// Also simulate all arms in single precision
    #[arg(long)]
    single: bool,

    /// Print all results as one JSON document on standard output
    #[arg(long)]
    json: bool,
}

/// The results.
#[derive(serde::Serialize)]
struct Outcome {
    arms: usize,
    chunk: usize,
    seed: u64,
    cores: usize,
    runs: Vec<Run>,
    /// Distance of the flange from its target, and its height above the target, in m.
    distance: Spread,
    height: Spread,
    /// The largest change of this distance with steps of half the length, in m.
    step_error: f64,
    /// The largest change of this distance in single precision, in m.
    single_error: Option<f64>,
    /// The number of arms that were compared with the same arm simulated alone.
    compared: usize,
    /// The hash of all samples and results in double precision.
    sha256: String,
}

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    match compute(&arguments).and_then(|outcome| output::print(&outcome, arguments.json)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn compute(arguments: &Arguments) -> Result<Outcome, Box<dyn Error>> {
    let chunk = arguments.chunk as usize;
    let arms: Vec<Sample> =
        (0..u64::from(arguments.arms)).map(|number| Sample::draw(arguments.seed, number)).collect();
    // A fraction is enough to measure the speed.
    let part = |of: usize| &arms[..arms.len().div_ceil(of)];
    let cores = std::thread::available_parallelism()?.get();
    let precisions = if arguments.single { [DOUBLE, SINGLE].as_slice() } else { &[DOUBLE] };

    let each = precisions.len() * (arms.len() + DOUBLE.ways.len() * part(TRIED).len());
    let progress = Progress::new(each + part(TRIED).len() + part(ALONE).len());
    let mut runs = Vec::new();
    for &way in ONE_BY_ONE {
        runs.push(way.run(part(TRIED), chunk, 1, &progress)?.0);
        runs.push(way.run(part(ALONE), chunk, cores, &progress)?.0);
    }
    let mut ends = Vec::new();
    for precision in precisions {
        for way in precision.ways {
            runs.push(way.run(part(TRIED), chunk, 1, &progress)?.0);
        }
        let native = precision.native().ok_or("no lanes fit a register")?;
        let (run, of_all) = native.run(&arms, chunk, cores, &progress)?;
        runs.push(run);
        ends.push(of_all);
    }
    progress.finish();

    let (double, single) = (&ends[0], ends.get(1));
    let sample = &arms[..arms.len().min(SAMPLE)];
    let [alone, finer] = [1, 2].map(|finer| ONE_BY_ONE[0].ends(sample, finer));
    let (alone, finer) = (alone?, finer?);
    if let Some(index) = (0..sample.len()).find(|&index| double[index] != alone[index]) {
        let (found, alone) = (double[index], alone[index]);
        return Err(format!("arm {index} ends at {found:?} in lanes, at {alone:?} alone").into());
    }
    let rows: Vec<_> = arms.iter().copied().zip(double.iter().copied()).collect();
    let spread = |index: usize| summary(double.iter().map(|end| end[index])).ok_or("no arms");
    Ok(Outcome {
        arms: arms.len(),
        chunk,
        seed: arguments.seed,
        cores,
        runs,
        distance: Spread::of(spread(0)?),
        height: Spread::of(spread(1)?),
        step_error: largest(&alone, &finer),
        single_error: single.map(|single| largest(double, single)),
        compared: sample.len(),
        sha256: digest(&rows),
    })
}

/// Returns the largest difference of the results of the same arm, in m.
fn largest(ends: &[[f64; RESULTS.len()]], others: &[[f64; RESULTS.len()]]) -> f64 {
    let pairs = ends.iter().flatten().zip(others.iter().flatten());
    pairs.map(|(end, other)| (end - other).abs()).fold(0.0, f64::max)
}
