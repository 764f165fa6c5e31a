//! Compares single with double precision for a chain from a file: accelerations and forces at random
//! states, and a motion.
//!
//! A chain becomes code while a crate compiles. So this program writes a small package with the chain
//! into cargo's target folder, builds it and runs it; the package runs `comparison/`.
//!
//! `cargo run --release --example precision -- --help` lists the options.

mod glue;
mod model;
mod package;
mod source;
#[cfg(test)]
mod tests;

use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Parser, ValueEnum};
use mstmm_precision::{Settings, Task};

/// Compares a chain in f32 with the same chain in f64: accelerations, forces and moments at random
/// states, and a motion from its start by the classical Runge-Kutta method. Reports how many digits
/// f32 keeps, why the others are lost, and below which step the motion gets no better.
#[derive(Parser)]
#[command(name = "precision")]
struct Arguments {
    /// A file with chains, as inside `mstmm_chain! { … }`, or a Rust file (`.rs`) with calls of this
    /// macro, which is compiled as a whole
    file: PathBuf,

    /// Name of the chain, if there are several
    #[arg(long, value_name = "NAME")]
    chain: Option<String>,

    /// Duration of the motion in s
    #[arg(long, value_name = "SECONDS", default_value_t = 10.0, value_parser = positive)]
    time: f64,

    /// Step in s
    #[arg(long, value_name = "SECONDS", default_value_t = 1e-3, value_parser = positive)]
    step: f64,

    /// Number of random states
    #[arg(long, default_value_t = 1000, value_parser = clap::value_parser!(u32).range(1..))]
    states: u32,

    /// Seed of the random states and inputs
    #[arg(long, default_value_t = 1)]
    seed: u64,

    /// Inputs of the chain: motors, loads, gravity, prescribed motions
    #[arg(long, value_enum, default_value_t = Inputs::Zero)]
    inputs: Inputs,

    /// Print all results as one JSON document on standard output
    #[arg(long)]
    json: bool,
}

/// The largest number of hinges: states and motions of longer chains need too much memory.
const MOST: usize = 20_000;

/// The inputs of a chain.
#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum Inputs {
    /// Zero, with prescribed motions at rest in the zero position
    Zero,
    /// Random: efforts up to the largest internal force and moment at the start, gravity up to 9.81 m/s²
    /// along each axis, motions like those of free hinges. During the motion inputs are constant
    /// and prescribed motions are at rest
    Random,
}

fn positive(text: &str) -> Result<f64, String> {
    let number: f64 = text.parse().map_err(|_| "not a number".to_owned())?;
    (number > 0.0 && number.is_finite()).then_some(number).ok_or("must be positive".to_owned())
}

fn main() -> ExitCode {
    match run(&Arguments::parse()) {
        Ok(text) => {
            print!("{text}");
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

/// Returns the text to print, or an error message.
fn run(arguments: &Arguments) -> Result<String, String> {
    let file = &arguments.file;
    let text = std::fs::read_to_string(file)
        .map_err(|error| format!("error: {}: {error}", file.display()))?;
    let name = arguments.chain.as_deref();
    let is_rust = file.extension().is_some_and(|extension| extension == "rs");
    let found = if is_rust { source::rust(&text, name) } else { source::chains(&text, name) }
        .map_err(|error| format!("error: {}: {error}", file.display()))?;
    let executable = package::build(file, &found.code)?;
    let Some(chain) = found.chain else {
        return Err(format!("error: {}: the chain cannot be read", file.display()));
    };
    let random_inputs = arguments.inputs == Inputs::Random;
    let description = model::describe(&chain, random_inputs);
    if description.hinges().nth(MOST).is_some() {
        return Err(format!("error: {}: more than {MOST} hinges", file.display()));
    }
    let settings = Settings {
        time: arguments.time,
        step: arguments.step,
        states: arguments.states as usize,
        seed: arguments.seed,
        random_inputs,
        json: arguments.json,
    };
    package::run(&executable, &Task { description, settings })
}
