//! The study of payloads on many processes and machines by MPI; see the readme of `bridges/studies`.
//!
//! The process of rank zero gives out chunks and writes a part for each; the others compute. A single process does both.

mod parts;

use std::error::Error;
use std::path::PathBuf;
use std::process::ExitCode;

use clap::Parser;
use mpi::traits::{Communicator, Destination, Source};
use mstmm::lanes::NativeF64;
use mstmm_payloads::{RESULTS, Sample, digest, simulate, summary};
use parts::Parts;

/// Simulates Pandas with random payloads, whose controller does not know them, and prints how far from their target they
/// stop, with the SHA-256 of all values.
#[derive(Parser, Debug)]
struct Arguments {
    /// The folder for the parts, which the process of rank zero writes
    #[arg(short, long)]
    output: PathBuf,
    /// Number of samples
    #[arg(long, default_value_t = 1000, value_parser = clap::value_parser!(u64).range(1..))]
    samples: u64,
    /// Samples in a chunk
    #[arg(long, default_value_t = 100, value_parser = clap::value_parser!(u64).range(1..))]
    chunk: u64,
    /// Seed of the samples
    #[arg(long, default_value_t = 1)]
    seed: u64,
}

/// The results of one sample.
type Results = [f64; RESULTS.len()];

impl Arguments {
    fn chunks(&self) -> u64 {
        self.samples.div_ceil(self.chunk)
    }

    fn sample(&self, number: u64) -> Sample {
        Sample::draw(self.seed, number)
    }

    /// Computes a chunk.
    fn compute(&self, chunk: u64) -> Result<Vec<Results>, mstmm::Error> {
        let first = chunk * self.chunk;
        let rows = first..(first + self.chunk).min(self.samples);
        simulate::<NativeF64>(&rows.map(|row| self.sample(row)).collect::<Vec<Sample>>(), 1)
    }
}

/// No chunk is left.
const END: u64 = u64::MAX;

fn main() -> ExitCode {
    let Some(universe) = mpi::initialize() else {
        eprintln!("error: MPI does not start");
        return ExitCode::FAILURE;
    };
    let world = universe.world();
    let arguments = Arguments::parse();
    let result = match (world.rank(), world.size()) {
        (0, size) => lead(&arguments, &world, size),
        _ => work(&arguments, &world),
    };
    if let Err(error) = result {
        eprintln!("error: {error}");
        // The others would wait for ever.
        world.abort(1);
    }
    ExitCode::SUCCESS
}

/// Computes chunks until none is left.
fn work(arguments: &Arguments, world: &impl Communicator) -> Result<(), Box<dyn Error>> {
    let lead = world.process_at_rank(0);
    // The chunk that is computed; none at first.
    let mut computed = END;
    let mut results: Vec<f64> = Vec::new();
    loop {
        lead.send(&computed);
        lead.send(&results[..]);
        let (chunk, _) = lead.receive::<u64>();
        if chunk == END {
            return Ok(());
        }
        computed = chunk;
        results = arguments.compute(chunk)?.concat();
    }
}

/// Gives out the chunks without a part, writes their parts, and prints the results.
fn lead(arguments: &Arguments, world: &impl Communicator, size: i32) -> Result<(), Box<dyn Error>> {
    let parts = Parts::open(&arguments.output, arguments)?;
    let missing: Vec<u64> = (0..arguments.chunks()).filter(|chunk| !parts.has(*chunk)).collect();
    let mut next = missing.iter().copied();
    if size == 1 {
        for chunk in next {
            parts.write(chunk, &arguments.compute(chunk)?.concat())?;
        }
    } else {
        let mut working = size - 1;
        while working > 0 {
            let (computed, status) = world.any_process().receive::<u64>();
            let worker = world.process_at_rank(status.source_rank());
            let (results, _) = worker.receive_vec::<f64>();
            if computed != END {
                parts.write(computed, &results)?;
            }
            let chunk = next.next().unwrap_or(END);
            working -= i32::from(chunk == END);
            worker.send(&chunk);
        }
    }
    eprintln!(
        "{} chunks computed, {} found",
        missing.len(),
        arguments.chunks() - missing.len() as u64
    );
    print(arguments, &parts)
}

/// Prints statistics and the hash of all parts.
fn print(arguments: &Arguments, parts: &Parts) -> Result<(), Box<dyn Error>> {
    let mut rows = Vec::new();
    for chunk in 0..arguments.chunks() {
        for results in parts.read(chunk)? {
            rows.push((arguments.sample(rows.len() as u64), results));
        }
    }
    println!("{:24}{:>8}{:>14}{:>30}{:>14}", "quantity", "samples", "mean", "95 % interval", "q95");
    for (index, name) in RESULTS.into_iter().enumerate() {
        let of = summary(rows.iter().map(|(_, results)| results[index])).ok_or("no samples")?;
        let interval =
            format!("{:.6e} to {:.6e}", of.mean - of.mean_error, of.mean + of.mean_error);
        println!(
            "{name:24}{:8}{:14.6e}{interval:>30}{:14.6e}",
            rows.len(),
            of.mean,
            of.quantiles[1]
        );
    }
    println!("sha256 {}", digest(&rows));
    Ok(())
}
