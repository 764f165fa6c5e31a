//! All numbers of a run as one JSON document.

use std::io::{self, Write};
use std::path::PathBuf;

use serde::Serialize;

use crate::compare::Comparison;
use crate::output::exhibit::Exhibit;
use crate::section::Outcome;

/// The document.
#[derive(Serialize)]
pub struct Document<'a> {
    /// In rad for angles, rad/s² for accelerations, m for positions.
    tolerance: f64,
    /// What differs by more than the tolerance.
    complaints: &'a [String],
    files: &'a [PathBuf],
    comparisons: &'a [Comparison],
    tables: &'a [Exhibit],
}

impl<'a> Document<'a> {
    pub fn new(
        outcome: &'a Outcome,
        files: &'a [PathBuf],
        tolerance: f64,
        complaints: &'a [String],
    ) -> Self {
        let Outcome { comparisons, exhibits: tables, .. } = outcome;
        Document { tolerance, complaints, files, comparisons, tables }
    }

    pub fn print(&self) -> Result<(), io::Error> {
        let mut out = io::stdout().lock();
        serde_json::to_writer_pretty(&mut out, self)?;
        writeln!(out)
    }
}
