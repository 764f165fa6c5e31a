//! Compares single with double precision for any chain made by `mstmm_chain!`. The command `precision`
//! of the examples writes a program that calls [`compare`] with a chain.
//!
//! | module | holds |
//! |---|---|
//! | `description` | the description of a chain and the settings |
//! | `subject` | a chain in either precision |
//! | `scales`, `sample` | characteristic length and rate; random states and inputs |
//! | `evaluation` | errors of single evaluations |
//! | `mixed`, `course`, `motion` | errors of a motion, and their causes |
//! | `verdict`, `output` | the verdict; tables or JSON |
#![deny(missing_docs)]

mod course;
mod description;
mod evaluation;
mod mixed;
mod motion;
mod output;
mod sample;
mod scales;
mod statistics;
mod subject;
mod verdict;

pub use std::process::ExitCode;

pub use description::{Description, Group, Hinge, Input, InputKind, Part, Settings, Task};
pub use subject::{Number, Reading, Subject};

use evaluation::Errors;
use motion::Motion;
use sample::Start;
use scales::Scales;
use serde::Serialize;

/// The stack size: long chains keep values of every body on the stack.
const STACK: usize = 1 << 30;

/// The chain that a program compares.
pub trait Chosen {
    /// Runs the task in the first argument, a [`Task`] as JSON.
    fn compare() -> ExitCode;
}

/// The results.
#[derive(Debug, Serialize)]
struct Report {
    chain: String,
    states_asked: usize,
    seed: u64,
    random_inputs: bool,
    /// Whether the chain cannot be closed from its start and a random start was used instead.
    start_drawn: bool,
    scales: Scales,
    errors: Errors,
    /// None if all motions are prescribed.
    motion: Option<Motion>,
    verdict: Vec<String>,
}

/// Compares a chain in both precisions by the task in the program's first argument, a [`Task`] as
/// JSON, and prints the results.
pub fn compare<D, S>() -> ExitCode
where
    D: Subject<Scalar = f64>,
    S: Subject<Scalar = f32>,
{
    let thread = std::thread::Builder::new().stack_size(STACK).spawn(printed::<D, S>);
    let done = thread.map_err(|error| error.to_string()).and_then(|thread| {
        thread.join().unwrap_or_else(|_| Err("the comparison failed".to_owned()))
    });
    match done {
        Ok(text) => {
            print!("{text}");
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn printed<D, S>() -> Result<String, String>
where
    D: Subject<Scalar = f64>,
    S: Subject<Scalar = f32>,
{
    let argument = std::env::args().nth(1).ok_or("what is to be done is missing")?;
    let task: Task = serde_json::from_str(&argument).map_err(|error| error.to_string())?;
    let report = report::<D, S>(&task).map_err(|error| error.to_string())?;
    if task.settings.json {
        return serde_json::to_string_pretty(&report)
            .map(|text| text + "\n")
            .map_err(|error| error.to_string());
    }
    Ok(output::text(&report, &task.description))
}

fn report<D, S>(task: &Task) -> Result<Report, mstmm::Error>
where
    D: Subject<Scalar = f64>,
    S: Subject<Scalar = f32>,
{
    let Task { description, settings } = task;
    let (double, single) = (D::default(), S::default());
    let start = Start::of(&double, description, settings)?;
    let scales = Scales::of(&double, description, &start, settings)?;
    let (both, from) = ((&double, &single), (description, &start));
    let errors = evaluation::errors(both, from, scales, settings)?;
    let moves = description.groups().next().is_some();
    let motion = moves.then(|| motion::motion(both, from, scales, settings)).transpose()?;
    let verdict = verdict::verdict(&errors, motion.as_ref(), description);
    Ok(Report {
        chain: description.name.clone(),
        states_asked: settings.states,
        seed: settings.seed,
        random_inputs: settings.random_inputs,
        start_drawn: start.drawn,
        scales,
        errors,
        motion,
        verdict,
    })
}
