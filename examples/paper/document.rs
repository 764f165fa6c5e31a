//! All numbers of a run as one JSON document.

use std::io::{self, Write};
use std::path::PathBuf;

use serde::Serialize;

use crate::compare::Comparison;

/// The document.
#[derive(Serialize)]
pub struct Document<'a> {
    /// In rad for angles, in rad/s² for accelerations.
    tolerance: f64,
    /// What differs by more than the tolerance.
    complaints: Vec<String>,
    files: &'a [PathBuf],
    comparisons: &'a [Comparison],
}

impl<'a> Document<'a> {
    pub fn new(comparisons: &'a [Comparison], files: &'a [PathBuf], tolerance: f64) -> Self {
        let complaints = comparisons.iter().flat_map(|one| one.complaints(tolerance)).collect();
        Document { tolerance, complaints, files, comparisons }
    }

    pub fn print(&self) -> Result<(), io::Error> {
        let mut out = io::stdout().lock();
        serde_json::to_writer_pretty(&mut out, self)?;
        writeln!(out)
    }
}
