//! A comparison as tables, for the terminal and for the page.

use std::fmt::{self, Display, Formatter};

use crate::compare::{Comparison, Difference};
use crate::system::{Angle, RECORDS_PER_SECOND, Record};

/// The times in s at which angles are shown.
const TIMES: [f64; 7] = [0.0, 0.5, 1.0, 2.0, 3.0, 4.0, 5.0];

/// Numbers under headings.
pub struct Grid {
    pub title: String,
    /// What it shows.
    pub says: &'static str,
    pub columns: Vec<String>,
    pub rows: Vec<Vec<String>>,
}

/// What a comparison is of.
pub fn title(comparison: &Comparison) -> String {
    format!("Section {}: {}", comparison.system.label, comparison.system.title)
}

/// How its motions were computed.
pub fn method(comparison: &Comparison) -> String {
    let Comparison { integrator, step_s, .. } = comparison;
    format!("method: riccati, {integrator}, step {step_s} s; beside it Newton–Euler (N–E)")
}

/// Its numbers: angles group by group, then the accelerations at the start.
pub fn grids(comparison: &Comparison) -> Vec<Grid> {
    let mut first = 0;
    let mut grids = Vec::new();
    for group in comparison.system.angles.chunk_by(|one, next| one.group == next.group) {
        grids.push(angles(comparison, group, first));
        first += group.len();
    }
    grids.push(start_accelerations(comparison));
    grids
}

/// The angles of one group, whose first one is the system's angle `first`.
fn angles(comparison: &Comparison, group: &[Angle], first: usize) -> Grid {
    let columns = ["method", "N–E"]
        .iter()
        .flat_map(|way| group.iter().map(move |angle| format!("{} {way}", angle.symbol)));
    let row = |&time: &f64| {
        let method = &comparison.method[(time * f64::from(RECORDS_PER_SECOND)) as usize];
        let independent = comparison.newton_euler.iter().find(|record| record.time_s == time);
        let records = [Some(method), independent].into_iter().flatten();
        let angles = records.flat_map(|record: &Record| &record.angles_rad[first..][..group.len()]);
        // Adding zero takes the sign from a negative zero.
        let shown = angles.map(|angle| format!("{:.10}", angle + 0.0));
        [format!("{time:.1}")].into_iter().chain(shown).collect()
    };
    Grid {
        title: format!("Angles of {} in rad", group[0].group),
        says: "Generated code and Newton–Euler, with integrators of their own, show the same angles.",
        columns: ["t/s".to_owned()].into_iter().chain(columns).collect(),
        rows: TIMES.iter().map(row).collect(),
    }
}

fn start_accelerations(comparison: &Comparison) -> Grid {
    let found = &comparison.accelerations;
    let known = comparison.system.start.iter().enumerate();
    let row = |(row, known): (usize, &crate::system::KnownAcceleration)| {
        let ways = [found.riccati[row], found.transfer[row], found.newton_euler[row], known.value];
        let values = ways.iter().map(|value| format!("{:.14}", value + 0.0));
        // The name comes last, since a letter with dots is two characters of one column's width.
        values.chain([known.name.to_owned()]).collect()
    };
    Grid {
        title: "Accelerations at t = 0 in rad/s²".to_owned(),
        says: "Both methods and Newton–Euler agree with what follows by hand to the last digits.",
        columns: ["riccati", "transfer", "Newton–Euler", "closed form", ""]
            .map(String::from)
            .into(),
        rows: known.map(row).collect(),
    }
}

/// What it comes to: names and values.
pub fn summary(comparison: &Comparison) -> [(&'static str, String); 3] {
    let difference = |difference: &Difference| {
        let Difference { size_rad, angle, time_s } = difference;
        format!("{size_rad:.1e} rad ({angle}, t = {time_s} s)")
    };
    let drift = &comparison.energy_drift;
    let (size, relative, scale) =
        (drift.largest_j, drift.relative(), drift.largest_kinetic_energy_j);
    let of = format!("{relative:.1e} of the largest kinetic energy, {scale:.3} J");
    [
        (
            "largest difference, riccati to Newton–Euler",
            difference(&comparison.difference_to_newton_euler),
        ),
        (
            "largest difference, riccati to transfer",
            difference(&comparison.difference_between_methods),
        ),
        ("energy drift, largest |E(t) − E(0)|", format!("{size:.1e} J ({of})")),
    ]
}

/// The comparison as it is printed, several tables one below the other.
pub fn of(comparison: &Comparison) -> impl Display + '_ {
    Table(comparison)
}

struct Table<'a>(&'a Comparison);

impl Display for Table<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}\n  {}", title(self.0), method(self.0))?;
        for grid in grids(self.0) {
            writeln!(f, "\n{grid}")?;
        }
        for (what, value) in summary(self.0) {
            writeln!(f, "  {what:<45} {value}")?;
        }
        Ok(())
    }
}

impl Display for Grid {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        writeln!(f, "  {}", self.title)?;
        let width = |column: usize| {
            let cells = self.rows.iter().map(|row| row[column].chars().count());
            cells.chain([self.columns[column].chars().count()]).max().unwrap_or(0)
        };
        let widths: Vec<usize> = (0..self.columns.len()).map(width).collect();
        for row in [&self.columns].into_iter().chain(&self.rows) {
            for (cell, width) in row.iter().zip(&widths) {
                write!(f, "  {cell:>width$}")?;
            }
            writeln!(f)?;
        }
        Ok(())
    }
}
