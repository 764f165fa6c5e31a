//! Many robot arms with random payloads under the same controller, simulated in lanes of SIMD registers
//! on all cores, and for comparison one by one: what that brings, and how far off they stop.
//!
//! `cargo run --release --example ensemble -- --help` tells what it takes.

mod arm;
mod chain;
mod lanes;
mod output;
mod run;
mod statistics;

use std::error::Error;
use std::process::ExitCode;

use clap::Parser;

use arm::{Arm, End};
use run::{DOUBLE, ONE_BY_ONE, Progress, Run, SINGLE, Settings};
use statistics::Spread;

/// So many arms are also simulated one by one, and in shorter steps, to be compared with.
const SAMPLE: usize = 64;

/// To know its pace, a way simulates this part of the arms on one core, one by one on all cores.
const TRIED: usize = 40;
const ALONE: usize = 10;

/// Simulates Franka Emika Pandas with random payloads and starts, whose controller brings them to the
/// same pose, and says how far from it they stop.
///
/// Does so in lanes, as many arms side by side as a register holds, and for a part of them in lanes
/// of other widths and one by one, and says how many steps a second each way takes.
/// `RUSTFLAGS="-C target-cpu=native"` makes use of the widest registers. Fails if an arm in lanes does
/// not have the bits that it has alone.
#[derive(Parser)]
#[command(name = "ensemble")]
struct Arguments {
    /// How many arms
    #[arg(long, default_value_t = 100_000, value_parser = clap::value_parser!(u32).range(1..))]
    arms: u32,

    /// For how long, in s
    #[arg(long, value_name = "SECONDS", default_value_t = 1.0)]
    time: f64,

    /// The step of the classical Runge-Kutta method, in s
    #[arg(long, value_name = "SECONDS", default_value_t = 4e-3)]
    step: f64,

    /// Payloads and starts follow from it
    #[arg(long, default_value_t = 1)]
    seed: u64,

    /// Simulate all arms in single precision too
    #[arg(long)]
    single: bool,

    /// Print all numbers as one JSON document, and nothing else, on standard output
    #[arg(long)]
    json: bool,
}

/// What came out.
#[derive(serde::Serialize)]
struct Outcome {
    arms: usize,
    settings: Settings,
    seed: u64,
    cores: usize,
    runs: Vec<Run>,
    /// How far the flange stops from the pose asked for, and how far above it, in m.
    distance: Spread,
    height: Spread,
    /// What steps of half the length change of that distance at most, in m.
    step_error: f64,
    /// What single precision changes of it at most, in m.
    single_error: Option<f64>,
    /// How many arms were held against themselves alone.
    compared: usize,
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
    let settings = Settings::new(arguments.time, arguments.step)?;
    let arms = Arm::random(arguments.seed, arguments.arms as usize);
    // A part is enough to know the pace.
    let part = |of: usize| &arms[..arms.len().div_ceil(of)];
    let cores = std::thread::available_parallelism()?.get();
    let precisions = if arguments.single { [DOUBLE, SINGLE].as_slice() } else { &[DOUBLE] };

    let each = precisions.len() * (arms.len() + DOUBLE.ways.len() * part(TRIED).len());
    let progress = Progress::new(each + part(TRIED).len() + part(ALONE).len());
    let mut runs = Vec::new();
    for &way in ONE_BY_ONE {
        runs.push(way.run(part(TRIED), &settings, 1, &progress)?.0);
        runs.push(way.run(part(ALONE), &settings, cores, &progress)?.0);
    }
    let mut ends = Vec::new();
    for precision in precisions {
        for way in precision.ways {
            runs.push(way.run(part(TRIED), &settings, 1, &progress)?.0);
        }
        let native = precision.native().ok_or("no lanes fit a register")?;
        let (run, of_all) = native.run(&arms, &settings, cores, &progress)?;
        runs.push(run);
        ends.push(of_all);
    }
    progress.finish();

    let (double, single) = (&ends[0], ends.get(1));
    let sample = &arms[..arms.len().min(SAMPLE)];
    let [alone, finer] = [settings, settings.finer()].map(|to| ONE_BY_ONE[0].ends(sample, &to));
    let (alone, finer) = (alone?, finer?);
    if let Some(index) = (0..sample.len()).find(|&index| double[index] != alone[index]) {
        let (found, alone) = (double[index], alone[index]);
        return Err(format!("arm {index} ends at {found:?} in lanes, at {alone:?} alone").into());
    }
    Ok(Outcome {
        arms: arms.len(),
        settings,
        seed: arguments.seed,
        cores,
        runs,
        distance: Spread::of(double.iter().map(End::distance))?,
        height: Spread::of(double.iter().map(|end| end.offset[2]))?,
        step_error: largest(&alone, &finer),
        single_error: single.map(|single| largest(double, single)),
        compared: sample.len(),
    })
}

/// The largest way between where the same flanges end, in m.
fn largest(ends: &[End], others: &[End]) -> f64 {
    ends.iter().zip(others).map(|(end, other)| end.apart(other)).fold(0.0, f64::max)
}
