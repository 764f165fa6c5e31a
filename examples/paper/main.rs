//! The numerical examples of Rui, Bestle, Zhang and Zhou, *A new version of transfer matrix method
//! for multibody systems* (Multibody System Dynamics, 2016), and the paper's claims.
//!
//! Generated code computes all of them. In the same run, every result is compared with an independent
//! solution: the methods that the paper compares with, a Newton–Euler solver, or a closed form.
//!
//! `cargo run --release --example paper -- --help` lists the arguments.

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
mod verdict;

use std::error::Error;
use std::process::ExitCode;

use clap::Parser;

use output::progress::Progress;
use section::{Results, Section};

/// Computes the examples of Rui et al. (2016), sections 4.1 to 4.4, and the paper's claims by generated
/// code, and compares every result with an independent solution.
///
/// Prints the verdicts. Writes a page with all figures and tables (HTML), the figures (SVG), the tables
/// (text) and the motions (CSV, and pages to play) to the folder `paper` in cargo's target folder. The exit code is not
/// zero if a verdict fails.
#[derive(Parser)]
#[command(name = "paper")]
struct Arguments {
    /// The section of the paper, or the claim, to compute; all of them by default
    section: Option<Section>,

    /// Print all tables after the verdicts
    #[arg(long, conflicts_with = "json")]
    tables: bool,

    /// Print all values as one JSON document, and nothing else, on standard output
    #[arg(long)]
    json: bool,

    /// The largest difference that passes: angles in rad, accelerations in rad/s², positions in m
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

/// Computes the sections, writes and prints the results, and returns the checks that fail.
fn run(arguments: &Arguments) -> Result<Vec<String>, Box<dyn Error>> {
    let &Arguments { section, tables, json, tolerance } = arguments;
    let sections = section.map_or(Section::ALL.to_vec(), |section| vec![section]);
    let results = compute(&sections)?;
    let complaints = section::complaints(&results, tolerance);
    let files = output::write_files(&results, tolerance)?;
    if json {
        output::print_document(&results, &files, tolerance, &complaints)?;
    } else {
        output::print_summary(&results, &files, tolerance)?;
    }
    if tables {
        output::print_tables(&results)?;
    }
    Ok(complaints)
}

fn compute(sections: &[Section]) -> Result<Results, mstmm::Error> {
    let progress = Progress::new(sections.iter().map(|section| section.motions()).sum());
    let mut results = Results::new();
    for &section in sections {
        results.push((section, section.run(&progress)?));
    }
    progress.finish();
    Ok(results)
}
