//! The numerical examples of Rui, Bestle, Zhang and Zhou, *A new version of transfer matrix method
//! for multibody systems* (Multibody System Dynamics, 2016), computed by generated code and, in
//! the same run, by the ways that the paper compares with, or exactly; and what it claims beyond them.
//!
//! `cargo run --release --example paper -- --help` tells what it takes.

mod claims;
mod compare;
mod figure_8;
mod generated;
mod msdttmm;
mod newton_euler;
mod output;
mod power_law;
mod rods;
mod section;
mod section_4_1;
mod section_4_2;
mod section_4_3;
mod section_4_4;
mod system;
mod timing;

use std::error::Error;
use std::process::ExitCode;

use clap::Parser;

use output::progress::Progress;
use section::{Outcome, Section};

/// Computes the examples of Rui et al. (2016), sections 4.1 to 4.4, by generated code and by the ways
/// that the paper compares with, or exactly, and then what it claims beyond its examples.
///
/// Prints tables of angles, accelerations and energies; writes time series (CSV) and the paper's
/// figures (SVG) to the folder `paper` in cargo's target folder. Fails if the two disagree.
#[derive(Parser)]
#[command(name = "paper")]
struct Arguments {
    /// The section of the paper, or the claim, to compute; all of them if none is named
    section: Option<Section>,

    /// Print all numbers as one JSON document, and nothing else, on standard output
    #[arg(long)]
    json: bool,

    /// The largest difference that passes, in rad for angles, rad/s² for accelerations, m for positions
    #[arg(long, value_name = "LARGEST", default_value_t = 1e-8)]
    tolerance: f64,
}

fn main() -> ExitCode {
    match run(&Arguments::parse()) {
        Ok(complaints) if complaints.is_empty() => ExitCode::SUCCESS,
        Ok(complaints) => {
            complaints.iter().for_each(|complaint| eprintln!("error: {complaint}"));
            ExitCode::FAILURE
        }
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

/// Does what was asked and returns what does not agree.
fn run(arguments: &Arguments) -> Result<Vec<String>, Box<dyn Error>> {
    let sections = arguments.section.map_or(Section::ALL.to_vec(), |section| vec![section]);
    let outcome = compute(&sections)?;
    let files = output::write_files(&outcome)?;
    let complaints = outcome.complaints(arguments.tolerance);
    if arguments.json {
        output::print_document(&outcome, &files, arguments.tolerance, &complaints)?;
    } else {
        output::print_tables(&outcome, &files)?;
    }
    Ok(complaints)
}

fn compute(sections: &[Section]) -> Result<Outcome, mstmm::Error> {
    let progress = Progress::new(sections.iter().map(|section| section.motions()).sum());
    let mut outcome = Outcome::default();
    for section in sections {
        outcome.extend(section.run(&progress)?);
    }
    progress.finish();
    Ok(outcome)
}
