//! All of a run as one page that needs nothing else.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

use maud::{DOCTYPE, Markup, PreEscaped, html};

use crate::compare::Comparison;
use crate::output::exhibit::{Exhibit, Row, shown};
use crate::output::table::{self, Grid};
use crate::section::Outcome;

const STYLE: &str = "
    body { font: 16px/1.5 sans-serif; max-width: 60rem; margin: 2rem auto; padding: 0 1rem; }
    pre, table { font-size: 14px; overflow-x: auto; display: block; }
    td, th { padding: 0.1rem 0.8rem; text-align: right; white-space: nowrap; }
    td:first-child { text-align: left; }
    tr:nth-child(even) { background: #f4f4f4; }
    svg { max-width: 100%; height: auto; }
    figure { margin: 2rem 0; }
    figcaption { color: #444; }
";

/// Writes the page to `folder` and returns the file.
pub fn write(folder: &Path, outcome: &Outcome) -> Result<PathBuf, Box<dyn Error>> {
    let path = folder.join("report.html");
    fs::write(&path, page(outcome)?.into_string())?;
    Ok(path)
}

fn page(outcome: &Outcome) -> Result<Markup, Box<dyn Error>> {
    let mut figures = Vec::new();
    for figure in &outcome.figures {
        figures.push((figure.svg()?, figure.says));
    }
    for figure in &outcome.log_figures {
        figures.push((figure.svg()?, figure.says));
    }
    Ok(html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                title { "The examples of the paper" }
                style { (PreEscaped(STYLE)) }
            }
            body {
                h1 { "The examples of the paper" }
                p {
                    "X. Rui, D. Bestle, J. Zhang, Q. Zhou, "
                    em { "A new version of transfer matrix method for multibody systems" }
                    ", Multibody System Dynamics 38 (2016), computed by the code that "
                    code { "mstmm_chain!" }
                    " generates, and in the same run by the ways that it is compared with."
                }
                h2 { "Figures" }
                @for (svg, says) in &figures {
                    figure { (PreEscaped(svg)) figcaption { (says) } }
                }
                h2 { "Tables" }
                @for exhibit in &outcome.exhibits { (of_exhibit(exhibit)) }
                @for comparison in &outcome.comparisons { (of_comparison(comparison)) }
            }
        }
    })
}

fn of_comparison(comparison: &Comparison) -> Markup {
    html! {
        h3 { (table::title(comparison)) }
        p { (table::method(comparison)) "." }
        @for Grid { title, says, columns, rows } in table::grids(comparison) {
            h4 { (title) }
            table {
                tr { @for column in columns { th { (column) } } }
                @for row in rows {
                    tr { @for cell in row { td { (cell) } } }
                }
            }
            p { (says) }
        }
        ul {
            @for (what, value) in table::summary(comparison) {
                li { (what) ": " (value) }
            }
        }
    }
}

fn of_exhibit(exhibit: &Exhibit) -> Markup {
    html! {
        h3 { (exhibit.section) ": " (exhibit.title) }
        table {
            tr {
                th {}
                @for column in &exhibit.columns { th { (column) } }
            }
            @for Row { name, values } in &exhibit.rows {
                tr {
                    td { (name) }
                    @for value in values { td { (shown(*value)) } }
                }
            }
        }
        @for difference in &exhibit.differences {
            p { (difference.what) ": " (format!("{:.1e}", difference.size)) " " (difference.unit) }
        }
        p { (exhibit.says.join(" ")) }
    }
}
