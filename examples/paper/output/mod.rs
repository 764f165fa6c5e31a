//! What a run comes to, as tables in the terminal, figures, files for machines, and one page.

mod csv_file;
mod document;
pub mod exhibit;
pub mod log_plot;
mod output_folder;
pub mod plot;
pub mod progress;
mod report;
mod table;

use std::error::Error;
use std::io::{self, Write};
use std::path::PathBuf;

use document::Document;

use crate::section::Outcome;

/// Writes all files of a run and returns them.
pub fn write_files(outcome: &Outcome) -> Result<Vec<PathBuf>, Box<dyn Error>> {
    let folder = output_folder::create()?;
    let mut files = Vec::new();
    for comparison in &outcome.comparisons {
        files.extend(csv_file::write(&folder, comparison)?);
    }
    for figure in &outcome.figures {
        files.push(figure.write(&folder)?);
    }
    for figure in &outcome.log_figures {
        files.push(figure.write(&folder)?);
    }
    files.push(report::write(&folder, outcome)?);
    Ok(files)
}

/// Prints all tables, and which files were written.
pub fn print_tables(outcome: &Outcome, files: &[PathBuf]) -> Result<(), io::Error> {
    let mut out = io::stdout().lock();
    for comparison in &outcome.comparisons {
        writeln!(out, "{}", table::of(comparison))?;
    }
    for exhibit in &outcome.exhibits {
        writeln!(out, "{exhibit}")?;
    }
    writeln!(out, "Written:")?;
    for file in files {
        writeln!(out, "  {}", output_folder::shown(file).display())?;
    }
    Ok(())
}

/// Prints all numbers as one JSON document.
pub fn print_document(
    outcome: &Outcome,
    files: &[PathBuf],
    tolerance: f64,
    complaints: &[String],
) -> Result<(), io::Error> {
    Document::new(outcome, files, tolerance, complaints).print()
}
