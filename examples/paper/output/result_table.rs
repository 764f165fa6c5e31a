//! Tables of computed values, with published or known ones for comparison.

use std::fmt::{self, Display, Formatter};

use serde::Serialize;

use crate::verdict::Verdict;

/// A table of values, with the verdicts on them.
pub struct ResultTable {
    /// The section of the paper, or the claim.
    pub section: &'static str,
    pub title: &'static str,
    /// The heading of each column of values.
    pub columns: Vec<String>,
    pub rows: Vec<Row>,
    /// What the table shows.
    pub note: &'static str,
    pub verdicts: Vec<Verdict>,
}

/// A row of values.
#[derive(Serialize)]
pub struct Row {
    pub name: String,
    /// NaN where there is no value.
    pub values: Vec<f64>,
}

impl Display for ResultTable {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}: {}", self.section, self.title)?;
        write!(f, "  {:<48}", "")?;
        for column in &self.columns {
            write!(f, " {column:>12}")?;
        }
        writeln!(f)?;
        for Row { name, values } in &self.rows {
            write!(f, "  {name:<48}")?;
            for &value in values {
                write!(f, " {:>12}", formatted(value))?;
            }
            writeln!(f)?;
        }
        for check in self.verdicts.iter().flat_map(|verdict| &verdict.checks) {
            writeln!(f, "  {}: {:.1e} {}", check.what, check.size, check.unit)?;
        }
        for line in wrapped(self.note, NOTE_WIDTH) {
            writeln!(f, "  {line}")?;
        }
        Ok(())
    }
}

/// The longest line of a note in characters.
const NOTE_WIDTH: usize = 96;

/// Breaks a text into lines of at most `width` characters.
fn wrapped(text: &str, width: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        match lines.last_mut() {
            Some(line) if line.chars().count() + 1 + word.chars().count() <= width => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

/// Formats a value for a table in text; a dash for NaN.
pub fn formatted(value: f64) -> String {
    if value.is_nan() { "–".into() } else { format!("{value:.2E}") }
}
