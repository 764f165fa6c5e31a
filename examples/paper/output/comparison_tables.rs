//! A comparison as tables, for text and for the page.

use std::fmt::{self, Display, Formatter};

use crate::compare::{Comparison, Difference};
use crate::system::{Angle, RECORDS_PER_SECOND, Record};

/// The times in s in the tables of angles.
const TIMES: [f64; 7] = [0.0, 0.5, 1.0, 2.0, 3.0, 4.0, 5.0];

/// A table of formatted values.
pub struct Grid {
    pub title: String,
    /// What the table shows.
    pub note: &'static str,
    pub columns: Vec<String>,
    pub rows: Vec<Vec<String>>,
}

/// The title of a comparison.
pub fn title(comparison: &Comparison) -> String {
    format!("Section {}: {}", comparison.system.label, comparison.system.title)
}

/// The methods and the step of a comparison.
pub fn method(comparison: &Comparison) -> String {
    let Comparison { integrator, step_s, .. } = comparison;
    format!(
        "Generated code: method riccati, {integrator}, step {step_s} s. Reference: Newton–Euler (N–E)"
    )
}

/// The tables of a comparison: the angles of each group, then the accelerations at the start.
pub fn grids(comparison: &Comparison) -> Vec<Grid> {
    let mut first = 0;
    let mut grids = Vec::new();
    for group in comparison.system.angles.chunk_by(|angle, next| angle.group == next.group) {
        grids.push(angles(comparison, group, first));
        first += group.len();
    }
    grids.push(start_accelerations(comparison));
    grids
}

/// The angles of one group. The first angle of the group has the index `first` in the system.
fn angles(comparison: &Comparison, group: &[Angle], first: usize) -> Grid {
    let columns = ["code", "N–E"]
        .iter()
        .flat_map(|method| group.iter().map(move |angle| format!("{} {method}", angle.symbol)));
    let row = |&time: &f64| {
        let method = &comparison.method[(time * f64::from(RECORDS_PER_SECOND)) as usize];
        let independent = comparison.newton_euler.iter().find(|record| record.time_s == time);
        let records = [Some(method), independent].into_iter().flatten();
        let angles = records.flat_map(|record: &Record| &record.angles_rad[first..][..group.len()]);
        // Adding zero removes the sign of a negative zero.
        let cells = angles.map(|angle| format!("{:.10}", angle + 0.0));
        [format!("{time:.1}")].into_iter().chain(cells).collect()
    };
    Grid {
        title: format!("Angles of {} in rad", group[0].group),
        note: "Generated code and Newton–Euler, each with its own integrator.",
        columns: ["t/s".to_owned()].into_iter().chain(columns).collect(),
        rows: TIMES.iter().map(row).collect(),
    }
}

fn start_accelerations(comparison: &Comparison) -> Grid {
    let computed = &comparison.accelerations;
    let known = comparison.system.start.iter().enumerate();
    let row = |(row, known): (usize, &crate::system::KnownAcceleration)| {
        let values = [
            computed.riccati[row],
            computed.transfer[row],
            computed.newton_euler[row],
            known.value,
        ];
        let values = values.iter().map(|value| format!("{:.14}", value + 0.0));
        // The name comes last, because a letter with dots is two characters in one column.
        values.chain([known.name.to_owned()]).collect()
    };
    Grid {
        title: "Accelerations at t = 0 in rad/s²".to_owned(),
        note: "The closed forms follow from the equations of motion by hand.",
        columns: ["riccati", "transfer", "Newton–Euler", "closed form", ""]
            .map(String::from)
            .into(),
        rows: known.map(row).collect(),
    }
}

/// The differences and the energy drift: names and values.
pub fn summary(comparison: &Comparison) -> [(&'static str, String); 3] {
    let difference = |difference: &Difference| {
        let Difference { size_rad, angle, time_s } = difference;
        format!("{size_rad:.1e} rad ({angle}, t = {time_s} s)")
    };
    let drift = &comparison.energy_drift;
    let (size, relative, scale) =
        (drift.largest_j, drift.relative(), drift.largest_kinetic_energy_j);
    let relative = format!("{relative:.1e} of the largest kinetic energy, {scale:.3} J");
    [
        (
            "largest difference, riccati – Newton–Euler",
            difference(&comparison.difference_to_newton_euler),
        ),
        (
            "largest difference, riccati – transfer",
            difference(&comparison.difference_between_methods),
        ),
        ("energy drift, largest |E(t) − E(0)|", format!("{size:.1e} J ({relative})")),
    ]
}

/// The comparison as text.
pub fn text(comparison: &Comparison) -> impl Display + '_ {
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
