//! What single precision loses beside double precision for a chain from a file: accelerations and
//! forces over random states, and a motion.
//!
//! A chain becomes code while a crate compiles. So this writes a small package into cargo's target
//! folder that holds the chain, builds it and runs it; what it runs is `comparison/`.
//!
//! `cargo run --release --example precision -- --help` tells what it takes.

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

/// Compares a chain in f32 with itself in f64: accelerations, forces and moments over random
/// states, and a motion from its start by the classical Runge-Kutta method; says how many digits
/// f32 keeps, what takes them, and below which step it gets no better.
#[derive(Parser)]
#[command(name = "precision")]
struct Arguments {
    /// The text of chains, as it stands inside `mstmm_chain! { … }`, or a file of Rust (`.rs`) with
    /// such calls in it, which is compiled as a whole
    file: PathBuf,

    /// Which chain, if there are several
    #[arg(long, value_name = "NAME")]
    chain: Option<String>,

    /// How long the motion is, in s
    #[arg(long, value_name = "SECONDS", default_value_t = 10.0, value_parser = positive)]
    time: f64,

    /// The step, in s
    #[arg(long, value_name = "SECONDS", default_value_t = 1e-3, value_parser = positive)]
    step: f64,

    /// How many random states
    #[arg(long, default_value_t = 1000, value_parser = clap::value_parser!(u32).range(1..))]
    states: u32,

    /// Random states and inputs follow from it
    #[arg(long, default_value_t = 1)]
    seed: u64,

    /// What the chain takes from outside: motors, loads, gravity, motions that are told
    #[arg(long, value_enum, default_value_t = Inputs::Zero)]
    inputs: Inputs,

    /// Print all numbers as one JSON document, and nothing else, on standard output
    #[arg(long)]
    json: bool,
}

/// States and motions of longer chains would take more memory than there may be.
const MOST: usize = 20_000;

/// What a chain takes from outside.
#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum Inputs {
    /// Nothing, and motions at rest in the zero position
    Zero,
    /// At random: efforts up to the largest inside the chain at its start, gravity up to 9.81 m/s²
    /// along each axis, motions as those of free hinges; constant during the motion, where motions
    /// told are at rest
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

/// What is to be printed, or what is wrong.
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
