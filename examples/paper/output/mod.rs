//! The results of a run: a summary in the terminal, tables, figures, files, and one page.

mod comparison_tables;
mod csv_file;
mod document;
pub mod drawing;
mod figure_header;
pub mod log_figure;
mod motion_page;
mod output_folder;
pub mod progress;
mod report;
pub mod result_table;
mod summary;
pub mod time_figure;

use std::error::Error;
use std::fmt::Write as _;
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use document::Document;

use crate::section::Results;

/// The files of a run.
pub struct Files {
    /// The motions (CSV and HTML), the figures (SVG) and the page, which is the last one.
    results: Vec<PathBuf>,
    /// All tables as text.
    tables: PathBuf,
}

/// Writes all files of a run.
pub fn write_files(results: &Results, tolerance: f64) -> Result<Files, Box<dyn Error>> {
    let folder = output_folder::create()?;
    let mut files = Vec::new();
    for comparison in results.iter().flat_map(|(_, result)| &result.comparisons) {
        files.extend(csv_file::write(&folder, comparison)?);
        files.push(motion_page::write(&folder, comparison)?);
    }
    for figure in results.iter().flat_map(|(_, result)| &result.figures) {
        files.push(figure.write(&folder)?);
    }
    for figure in results.iter().flat_map(|(_, result)| &result.log_figures) {
        files.push(figure.write(&folder)?);
    }
    files.push(report::write(&folder, results, tolerance)?);
    Ok(Files { results: files, tables: write_tables(&folder, results)? })
}

fn write_tables(folder: &Path, results: &Results) -> Result<PathBuf, Box<dyn Error>> {
    let path = folder.join("tables.txt");
    fs::write(&path, all_tables(results)?)?;
    Ok(path)
}

/// All tables as text, section by section.
fn all_tables(results: &Results) -> Result<String, std::fmt::Error> {
    let mut text = String::new();
    for (_, result) in results {
        for comparison in &result.comparisons {
            writeln!(text, "{}", comparison_tables::text(comparison))?;
        }
        for table in &result.tables {
            writeln!(text, "{table}")?;
        }
    }
    Ok(text)
}

/// Prints the verdicts and the folder of the files.
pub fn print_summary(results: &Results, files: &Files, tolerance: f64) -> Result<(), io::Error> {
    summary::print(&mut io::stdout().lock(), results, files, tolerance)
}

/// Prints all tables.
pub fn print_tables(results: &Results) -> Result<(), Box<dyn Error>> {
    Ok(write!(io::stdout().lock(), "\n{}", all_tables(results)?)?)
}

/// Prints all values as one JSON document.
pub fn print_document(
    results: &Results,
    files: &Files,
    tolerance: f64,
    complaints: &[String],
) -> Result<(), Box<dyn Error>> {
    Ok(Document::new(results, &files.results, tolerance, complaints)?.print()?)
}
