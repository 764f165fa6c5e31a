//! All values of a run as one JSON document.
//!
//! Programs read this document: its keys, names and notes stay as they are, whatever the tables for
//! people say.

use std::collections::BTreeMap;
use std::io::{self, Write};
use std::path::PathBuf;

use serde::Serialize;

use crate::compare::Comparison;
use crate::output::result_table::{ResultTable, Row};
use crate::section::Results;
use crate::verdict::{Bound, Check};

/// The notes of the document's tables, by the titles of the tables.
const NOTES: &str = include_str!("document_notes.json");

#[derive(Serialize)]
pub struct Document<'a> {
    /// In rad for angles, rad/s² for accelerations, m for positions.
    tolerance: f64,
    /// Each check that fails.
    complaints: &'a [String],
    files: &'a [PathBuf],
    comparisons: Vec<&'a Comparison>,
    tables: Vec<Table<'a>>,
}

#[derive(Serialize)]
struct Table<'a> {
    section: &'a str,
    title: &'a str,
    columns: &'a [String],
    rows: &'a [Row],
    says: Vec<&'static str>,
    /// The checks that the tolerance bounds.
    differences: Vec<Difference<'a>>,
    /// The checks with bounds of their own that fail.
    faults: Vec<String>,
}

#[derive(Serialize)]
struct Difference<'a> {
    what: &'a str,
    size: f64,
    unit: &'a str,
}

impl<'a> Document<'a> {
    pub fn new(
        results: &'a Results,
        files: &'a [PathBuf],
        tolerance: f64,
        complaints: &'a [String],
    ) -> Result<Self, serde_json::Error> {
        let notes: BTreeMap<&str, Vec<&str>> = serde_json::from_str(NOTES)?;
        let tables = results.iter().flat_map(|(_, result)| &result.tables);
        let table = |table: &'a ResultTable| {
            let says = notes.get(table.title).cloned().unwrap_or_default();
            Table::new(table, says, tolerance)
        };
        Ok(Document {
            tolerance,
            complaints,
            files,
            comparisons: results.iter().flat_map(|(_, result)| &result.comparisons).collect(),
            tables: tables.map(table).collect(),
        })
    }

    pub fn print(&self) -> Result<(), io::Error> {
        let mut out = io::stdout().lock();
        serde_json::to_writer_pretty(&mut out, self)?;
        writeln!(out)
    }
}

impl<'a> Table<'a> {
    fn new(table: &'a ResultTable, says: Vec<&'static str>, tolerance: f64) -> Self {
        let ResultTable { section, title, columns, rows, verdicts, .. } = table;
        let checks = || verdicts.iter().flat_map(|verdict| &verdict.checks);
        let difference = |check: &'a Check| {
            let Check { what, size, unit, bound } = check;
            let difference = Difference { what, size: *size, unit };
            matches!(bound, Bound::Tolerance).then_some(difference)
        };
        let fault = |check: &Check| {
            let Check { what, size, bound, .. } = check;
            let failed = matches!(bound, Bound::Fixed(_)) && !check.passes(tolerance);
            failed.then(|| format!("{what}: {size:.1e}, more than {:.1e}", bound.value(tolerance)))
        };
        Table {
            section,
            title,
            columns,
            rows,
            says,
            differences: checks().filter_map(difference).collect(),
            faults: checks().filter_map(fault).collect(),
        }
    }
}
