//! Tables of numbers beside those that are published or known.

use std::fmt::{self, Display, Formatter};

use serde::Serialize;

/// A table.
#[derive(Serialize)]
pub struct Exhibit {
    /// The section of the paper, or the claim.
    pub section: &'static str,
    pub title: &'static str,
    /// The heading of each column of numbers.
    pub columns: Vec<String>,
    pub rows: Vec<Row>,
    /// What it shows.
    pub says: Vec<&'static str>,
    /// What must not differ by more than the tolerance.
    pub differences: Vec<KnownDifference>,
    /// What does not come out as it must, whatever the tolerance.
    pub faults: Vec<String>,
}

/// A row of numbers.
#[derive(Serialize)]
pub struct Row {
    pub name: String,
    /// Where there is none, not a number.
    pub values: Vec<f64>,
}

/// How far something is from what it should be.
#[derive(Serialize)]
pub struct KnownDifference {
    pub what: String,
    pub size: f64,
    pub unit: &'static str,
}

impl Exhibit {
    pub fn complaints(&self, tolerance: f64) -> Vec<String> {
        let large = self.differences.iter().filter_map(|difference| {
            let KnownDifference { what, size, unit } = difference;
            // Written so that NaN is a complaint too.
            let close = *size <= tolerance;
            (!close)
                .then(|| format!("{what} is off by {size:.1e} {unit}, more than {tolerance:.1e}"))
        });
        let section = self.section;
        self.faults.iter().cloned().chain(large).map(|text| format!("{section}: {text}")).collect()
    }
}

impl Display for Exhibit {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}: {}", self.section, self.title)?;
        write!(f, "  {:<48}", "")?;
        for column in &self.columns {
            write!(f, " {column:>12}")?;
        }
        writeln!(f)?;
        for Row { name, values } in &self.rows {
            write!(f, "  {name:<48}")?;
            for value in values {
                write!(f, " {:>12}", shown(*value))?;
            }
            writeln!(f)?;
        }
        for KnownDifference { what, size, unit } in &self.differences {
            writeln!(f, "  {what}: {size:.1e} {unit}")?;
        }
        for line in &self.says {
            writeln!(f, "  {line}")?;
        }
        Ok(())
    }
}

/// A number as tables show it.
pub fn shown(value: f64) -> String {
    if value.is_nan() { "–".into() } else { format!("{value:.2E}") }
}
