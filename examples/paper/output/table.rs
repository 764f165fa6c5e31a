//! A comparison as text.

use std::fmt::{self, Display, Formatter};

use crate::compare::{Comparison, Difference};
use crate::system::{Angle, RECORDS_PER_SECOND};

/// The times in s at which angles are printed.
const TIMES: [f64; 7] = [0.0, 0.5, 1.0, 2.0, 3.0, 4.0, 5.0];

/// The comparison as it is printed, several tables one below the other.
pub fn of(comparison: &Comparison) -> impl Display + '_ {
    Table(comparison)
}

struct Table<'a>(&'a Comparison);

impl Display for Table<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let Table(comparison) = self;
        let system = &comparison.system;
        writeln!(f, "Section {}: {}", system.label, system.title)?;
        writeln!(
            f,
            "  method: riccati, {}, step {} s; beside it Newton–Euler (N–E)",
            comparison.integrator, comparison.step_s
        )?;
        let mut first = 0;
        for group in system.angles.chunk_by(|one, next| one.group == next.group) {
            angles(f, comparison, group, first)?;
            first += group.len();
        }
        start_accelerations(f, comparison)?;
        summary(f, comparison)
    }
}

/// A table of the angles of one group, whose first one is the system's angle `first`.
fn angles(
    f: &mut Formatter<'_>,
    comparison: &Comparison,
    group: &[Angle],
    first: usize,
) -> fmt::Result {
    let columns = first..first + group.len();
    let name = group[0].group;
    write!(f, "\n  Angles of {name} in rad\n   t/s")?;
    for way in ["method", "N–E"] {
        for angle in group {
            write!(f, " {:>14}", format!("{} {way}", angle.symbol))?;
        }
    }
    writeln!(f)?;
    for time in TIMES {
        let method = &comparison.method[(time * f64::from(RECORDS_PER_SECOND)) as usize];
        let independent = comparison.newton_euler.iter().find(|record| record.time_s == time);
        write!(f, "{time:>6.1}")?;
        for record in [Some(method), independent].into_iter().flatten() {
            for angle in &record.angles_rad[columns.clone()] {
                // Adding zero takes the sign from a negative zero.
                write!(f, " {:>14.10}", angle + 0.0)?;
            }
        }
        writeln!(f)?;
    }
    Ok(())
}

fn start_accelerations(f: &mut Formatter<'_>, comparison: &Comparison) -> fmt::Result {
    let found = &comparison.accelerations;
    writeln!(f, "\n  Accelerations at t = 0 in rad/s²")?;
    for title in ["riccati", "transfer", "Newton–Euler", "closed form"] {
        write!(f, "  {title:>18}")?;
    }
    writeln!(f)?;
    for (row, known) in comparison.system.start.iter().enumerate() {
        let ways = [found.riccati[row], found.transfer[row], found.newton_euler[row], known.value];
        for value in ways {
            write!(f, "  {:>18.14}", value + 0.0)?;
        }
        // The name comes last, since a letter with dots is two characters of one column's width.
        writeln!(f, "  {}", known.name)?;
    }
    Ok(())
}

fn summary(f: &mut Formatter<'_>, comparison: &Comparison) -> fmt::Result {
    let line = |f: &mut Formatter<'_>, what: &str, difference: &Difference| {
        let Difference { size_rad, angle, time_s } = difference;
        writeln!(f, "  {what:<45} {size_rad:.1e} rad ({angle}, t = {time_s} s)")
    };
    writeln!(f)?;
    let to_newton_euler = &comparison.difference_to_newton_euler;
    line(f, "largest difference, riccati to Newton–Euler", to_newton_euler)?;
    let between_methods = &comparison.difference_between_methods;
    line(f, "largest difference, riccati to transfer", between_methods)?;
    let drift = &comparison.energy_drift;
    writeln!(
        f,
        "  {:<45} {:.1e} J ({:.1e} of the largest kinetic energy, {:.3} J)",
        "energy drift, largest |E(t) − E(0)|",
        drift.largest_j,
        drift.relative(),
        drift.largest_kinetic_energy_j
    )
}
