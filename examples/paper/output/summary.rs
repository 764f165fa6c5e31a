//! The verdicts and measurements of a run on one screen.

use std::io::{self, Write};

use super::{Files, output_folder};
use crate::section::{Measurement, Results, SectionResult};
use crate::verdict::Verdict;

/// Prints the verdicts section by section, the number that passed, and the files.
pub fn print(
    out: &mut impl Write,
    results: &Results,
    files: &Files,
    tolerance: f64,
) -> Result<(), io::Error> {
    writeln!(out, "Rui, Bestle, Zhang, Zhou (2016): generated code against independent solutions")?;
    writeln!(out, "{:>72}  {:>7}  figure", "largest difference", "bound")?;
    for (section, result) in results {
        writeln!(out, "{:<11} {}", section.label(), section.title())?;
        for verdict in result.verdicts() {
            writeln!(out, "{}", verdict_line(verdict, tolerance))?;
        }
        for Measurement { text, figure } in &result.measurements {
            let line = format!(" measured {text:<71}  {}", figure.unwrap_or_default());
            writeln!(out, "{}", line.trim_end())?;
        }
    }
    let verdicts = || results.iter().flat_map(|(_, result)| SectionResult::verdicts(result));
    let passed = verdicts().filter(|verdict| verdict.passes(tolerance)).count();
    writeln!(out, "\n{passed} of {} verdicts passed.", verdicts().count())?;
    if let Some(page) = files.results.last() {
        writeln!(out, "Page:    {}", output_folder::shown(page).display())?;
        let folder = page.parent().unwrap_or(page);
        writeln!(out, "Figures: {}/*.svg", output_folder::shown(folder).display())?;
        writeln!(out, "Motions: {}/*.csv", output_folder::shown(folder).display())?;
    }
    writeln!(out, "Tables:  {} (or: -- --tables)", output_folder::shown(&files.tables).display())
}

fn verdict_line(verdict: &Verdict, tolerance: f64) -> String {
    let Verdict { compared, figure, .. } = verdict;
    let word = if verdict.passes(tolerance) { "passed" } else { "FAILED" };
    let [size, unit, bound] = match verdict.decisive(tolerance) {
        Some(check) => [
            number(check.size),
            // Of "rad or rad/s", the first unit is enough here.
            check.unit.split(" or ").next().unwrap_or_default().to_owned(),
            number(check.bound.value(tolerance)),
        ],
        None => [const { String::new() }; 3],
    };
    let figure = figure.unwrap_or_default();
    let line = format!(" {word:<8} {compared:<47} {size:>7} {unit:<6}  {bound:>7}  {figure}");
    line.trim_end().to_owned()
}

/// Formats a difference or a bound with two digits.
pub fn number(value: f64) -> String {
    let text = format!("{value:.1e}");
    match text.parse::<f64>() {
        // Without an exponent if that is as short.
        Ok(rounded) if rounded == 0.0 || (1e-3..1e3).contains(&rounded) => rounded.to_string(),
        _ => text.replace(".0e", "e"),
    }
}
