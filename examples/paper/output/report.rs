//! All results of a run on one page without scripts, with links to the pages of motions.

mod numbering;
mod style;
mod typeset;

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

use maud::{DOCTYPE, Markup, PreEscaped, html};

use self::numbering::{Entry, Numbering};
use self::typeset::typeset;
use super::comparison_tables::{self, Grid};
use super::motion_page;
use super::result_table::{ResultTable, Row, formatted};
use super::summary;
use crate::compare::Comparison;
use crate::section::{Measurement, Results, Section, SectionResult};
use crate::verdict::{Check, Verdict};

/// Writes the page to `folder` and returns the file.
pub fn write(folder: &Path, results: &Results, tolerance: f64) -> Result<PathBuf, Box<dyn Error>> {
    let path = folder.join("report.html");
    fs::write(&path, page(results, tolerance)?.into_string())?;
    Ok(path)
}

fn page(results: &Results, tolerance: f64) -> Result<Markup, Box<dyn Error>> {
    let mut numbering = Numbering::default();
    let mut sections = Vec::new();
    for (section, result) in results {
        sections.push(of_section(*section, result, tolerance, &mut numbering)?);
    }
    Ok(html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                meta name="color-scheme" content="light dark";
                title { "Transfer matrix method: examples and claims, computed again" }
                style { (PreEscaped(style::STYLE)) }
            }
            body {
                (introduction())
                (verdicts(results, tolerance, &numbering))
                (mechanisms(results))
                (contents(results, &numbering))
                @for section in &sections { (section) }
            }
        }
    })
}

fn introduction() -> Markup {
    html! {
        h1 { "A new version of transfer matrix method for multibody systems: examples and claims, computed again" }
        p {
            "The paper: X. Rui, D. Bestle, J. Zhang, Q. Zhou, "
            em { "A new version of transfer matrix method for multibody systems" }
            ", Multibody System Dynamics 38 (2016). The code that "
            code { "mstmm_chain!" }
            " generates computes its examples (sections 4.1 to 4.4) and its claims. In the same run, each result \
             is compared with an independent solution."
        }
    }
}

/// The verdicts as a table, with links to figures.
fn verdicts(results: &Results, tolerance: f64, numbering: &Numbering) -> Markup {
    let all = || results.iter().flat_map(|(_, result)| SectionResult::verdicts(result));
    let passed = all().filter(|verdict| verdict.passes(tolerance)).count();
    let link = |figure: Option<&str>| {
        let entry = figure.and_then(|file_name| numbering.figure(file_name));
        html! {
            @if let Some(Entry { id, label, .. }) = entry { a href={ "#" (id) } { (label) } }
        }
    };
    html! {
        h2 id="verdicts" { "Verdicts" }
        p {
            strong { (passed) " of " (all().count()) " verdicts passed." }
            " A verdict passes if each of its differences is at most its bound. The table shows the difference \
             that is nearest to its bound."
        }
        div.scroll {
            table.verdicts {
                thead {
                    tr {
                        th { "Compared" } th { "Largest difference" } th { "Bound" } th { "Verdict" } th { "Figure" }
                    }
                }
                @for (section, result) in results {
                    tbody {
                        tr.section {
                            th colspan="5" {
                                a href={ "#" (anchor(*section)) } { (heading(*section)) }
                            }
                        }
                        @for verdict in result.verdicts() {
                            tr {
                                td { (verdict.compared) }
                                @match verdict.decisive(tolerance) {
                                    Some(check) => {
                                        td.number { (size(check)) }
                                        td.number.bound { (number(check.bound.value(tolerance))) }
                                    }
                                    None => { td {} td {} }
                                }
                                td { (badge(verdict.passes(tolerance))) }
                                td { (link(verdict.figure)) }
                            }
                        }
                        @for Measurement { text, figure } in &result.measurements {
                            tr {
                                td colspan="3" { (typeset(text)) }
                                td { span.measured { "measured" } }
                                td { (link(*figure)) }
                            }
                        }
                    }
                }
            }
        }
    }
}

fn badge(passes: bool) -> Markup {
    match passes {
        true => html! { span.passed { "passed" } },
        false => html! { span.failed { "FAILED" } },
    }
}

/// A drawing of each mechanism of the computed sections.
fn mechanisms(results: &Results) -> Markup {
    let drawings = results
        .iter()
        .flat_map(|(section, result)| result.drawings.iter().map(|drawing| (*section, drawing)));
    html! {
        h2 id="mechanisms" { "Mechanisms" }
        p { "Each mechanism in its starting position, to scale: x to the right, y upwards, z towards the reader, unless \
             the drawing shows other axes. Dots are centres of mass." }
        div.drawings {
            @for (section, drawing) in drawings {
                figure {
                    (PreEscaped(&drawing.svg))
                    figcaption {
                        strong { a href={ "#" (anchor(section)) } { (drawing.title) } ". " }
                        (drawing.caption)
                    }
                }
            }
        }
    }
}

fn contents(results: &Results, numbering: &Numbering) -> Markup {
    html! {
        nav {
            h2 { "Contents" }
            ol {
                @for (section, _) in results {
                    li {
                        a href={ "#" (anchor(*section)) } { (heading(*section)) }
                        ul {
                            @for Entry { id, label, title, .. } in numbering.of_section(*section) {
                                li { a href={ "#" (id) } { (label) } ": " (typeset(&capitalised(title))) }
                            }
                        }
                    }
                }
            }
        }
    }
}

fn of_section(
    section: Section,
    result: &SectionResult,
    tolerance: f64,
    numbering: &mut Numbering,
) -> Result<Markup, Box<dyn Error>> {
    let mut figures = Vec::new();
    for figure in &result.figures {
        let entry = numbering.add_figure(section, figure.file_name, figure.title);
        figures.push(of_figure(entry, &figure.svg()?, figure.title, figure.caption));
    }
    for figure in &result.log_figures {
        let entry = numbering.add_figure(section, figure.file_name, figure.title);
        figures.push(of_figure(entry, &figure.svg()?, figure.title, figure.caption));
    }
    Ok(html! {
        section id=(anchor(section)) {
            h2 { (heading(section)) }
            p { (section.about()) }
            @for figure in figures { (figure) }
            @for comparison in &result.comparisons {
                (of_comparison(section, comparison, tolerance, numbering))
            }
            @for table in &result.tables { (of_table(section, table, tolerance, numbering)) }
            p.top { a href="#verdicts" { "Back to the verdicts" } }
        }
    })
}

/// A figure in the colours of the page.
fn of_figure(entry: &Entry, svg: &str, title: &str, caption: &str) -> Markup {
    let svg = svg.replace("#000000", "currentColor").replace("#FFFFFF", "var(--page)").replacen(
        "<svg ",
        &format!("<svg role=\"img\" aria-label=\"{title}\" "),
        1,
    );
    html! {
        figure id=(entry.id) {
            div.scroll.plot { (PreEscaped(svg)) }
            figcaption { strong { (entry.label) ". " } (title) ". " (typeset(caption)) }
        }
    }
}

fn of_comparison(
    section: Section,
    comparison: &Comparison,
    tolerance: f64,
    numbering: &mut Numbering,
) -> Markup {
    html! {
        h3 { (comparison.system.label) ": " (comparison.system.title) }
        p {
            (comparison_tables::method(comparison)) ". "
            a href=(motion_page::file_name(&comparison.system)) { "The motion with all forces" }
            " is a page to play, with plots of all quantities."
        }
        @for Grid { title, note, columns, rows } in comparison_tables::grids(comparison) {
            @let entry = numbering.add_table(section, &format!("{} ({})", title, comparison.system.label));
            figure id=(entry.id) {
                figcaption { strong { (entry.label) ". " } (title) ". " (note) }
                div.scroll {
                    table {
                        thead { tr { @for column in columns { th { (typeset(&column)) } } } }
                        tbody {
                            @for row in rows { tr { @for text in row { td.number { (typeset(&text)) } } } }
                        }
                    }
                }
            }
        }
        ul {
            @for (what, value) in comparison_tables::summary(comparison) {
                li { (what) ": " (typeset(&value)) }
            }
        }
        (checks(&comparison.verdicts, tolerance))
    }
}

fn of_table(
    section: Section,
    table: &ResultTable,
    tolerance: f64,
    numbering: &mut Numbering,
) -> Markup {
    let entry = numbering.add_table(section, table.title);
    html! {
        figure id=(entry.id) {
            figcaption { strong { (entry.label) ". " } (typeset(&capitalised(table.title))) ". " (typeset(table.note)) }
            div.scroll {
                table {
                    thead {
                        tr {
                            th {}
                            @for column in &table.columns { th { (typeset(column)) } }
                        }
                    }
                    tbody {
                        @for Row { name, values } in &table.rows {
                            tr {
                                th { (typeset(name)) }
                                @for &value in values { td.number { (cell(value)) } }
                            }
                        }
                    }
                }
            }
        }
        (checks(&table.verdicts, tolerance))
    }
}

/// The checks of some verdicts, folded if there are many.
fn checks(verdicts: &[Verdict], tolerance: f64) -> Markup {
    let checks = || verdicts.iter().flat_map(|verdict| &verdict.checks);
    let passed = checks().filter(|check| check.passes(tolerance)).count();
    html! {
        @if checks().next().is_some() {
            details {
                summary { (passed) " of " (checks().count()) " checks passed" }
                ul {
                    @for check in checks() {
                        li {
                            (typeset(&check.what)) ": " (size(check)) ", bound " (number(check.bound.value(tolerance))) " – "
                            (badge(check.passes(tolerance)))
                        }
                    }
                }
            }
        }
    }
}

fn size(check: &Check) -> Markup {
    html! { (number(check.size)) @if !check.unit.is_empty() { " " (check.unit) } }
}

fn number(value: f64) -> Markup {
    typeset(&summary::number(value))
}

/// A value of a table with at least three digits, without an exponent if that is short.
fn cell(value: f64) -> Markup {
    match value.abs() {
        size if size < 1e6 && value.fract() == 0.0 => typeset(&format!("{}", value + 0.0)),
        0.1..10.0 => typeset(&format!("{value:.3}")),
        10.0..1e4 => typeset(&format!("{value:.1}")),
        _ => typeset(&formatted(value)),
    }
}

fn capitalised(text: &str) -> String {
    let mut letters = text.chars();
    let first = letters.next().map(char::to_uppercase);
    first.into_iter().flatten().chain(letters).collect()
}

/// The heading of a section: the number in the paper and the title.
fn heading(section: Section) -> String {
    let (label, title) = (section.label(), section.title());
    match section.is_claim() {
        true => title.to_owned(),
        false => format!("Section {label}: {title}"),
    }
}

fn anchor(section: Section) -> String {
    format!("section-{}", section.label().replace('.', "-"))
}
