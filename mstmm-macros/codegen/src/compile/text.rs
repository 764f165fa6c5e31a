//! The functions of a chain as text for people.

use super::{Programs, programs, readable};
use crate::examine::Findings;
use crate::model::{Chain, Layout};
use crate::program::text::{Labels, text};
use crate::program::{Headed, Program, Section, by_heading};

/// A function: its name, its program, and what its groups of results are called.
struct Function<'a> {
    name: &'static str,
    program: &'a Program,
    groups: &'static [&'static str],
}

/// The results of a solution; accelerations have the first three.
const SOLUTION: &[&str] = &[
    "accelerations",
    "pivots",
    "scales",
    "all_accelerations",
    "efforts",
    "energies",
    "undetermined",
    "points",
    "at_rest",
];

/// The functions of a chain, in the order in which they are compiled, and its setup.
fn functions(programs: &Programs) -> Vec<Function<'_>> {
    let function = |name, program, groups| Function { name, program, groups };
    let always = |name, program, groups| Some(function(name, program, groups));
    let implicit = programs.implicit.as_ref().map(|(program, _)| program);
    let (correction, pivots) = (programs.correction.as_ref(), programs.closure_pivots.as_ref());
    let all = [
        always("setup", &programs.setup, &["slots", "checks"]),
        always("accelerations", &programs.accelerations, &SOLUTION[..3]),
        implicit.map(|program| function("implicit_accelerations", program, &SOLUTION[..3])),
        always("solution", &programs.solution, SOLUTION),
        always("energy", &programs.energy, &["energies"]),
        always("coordinate_rates", &programs.coordinate_rates, &["coordinate_rates"]),
        always("normalized", &programs.normalized, &["coordinates"]),
        correction
            .map(|program| function("correction", program, &["coordinates", "rates", "residuals"])),
        pivots.map(|program| function("closure_pivots", program, &["pivots"])),
        always("start", &programs.start, &["coordinates", "rates"]),
    ];
    all.into_iter().flatten().collect()
}

/// The text of all functions of `chain`, or of one of them, in the order of the equations. Behind each there is a
/// table of the operations of its final code, by section.
///
/// # Errors
///
/// The names that functions have, if none has this one.
pub fn chain_text(
    chain: &Chain,
    findings: &Findings,
    function: Option<&str>,
) -> Result<String, Vec<&'static str>> {
    let layout = Layout::of(chain);
    let (readable, last) = (readable(chain, findings, &layout), programs(chain, findings, &layout));
    let repeats = chain.repeats.iter().map(|repeat| {
        let name = chain.hinges[repeat.hinges.first()].name.to_string();
        (name, repeat.count)
    });
    let repeats: Vec<(String, usize)> = repeats.collect();
    let (functions, last) = (functions(&readable), functions(&last));
    let wanted = functions.iter().zip(&last);
    let wanted = wanted.filter(|(one, _)| function.is_none_or(|name| name == one.name));
    let texts = wanted.map(|(one, last)| {
        let groups = one.groups.iter().map(|&group| group.to_owned());
        let parts = repeats.iter().map(|(name, _)| format!("slots_of_{name}"));
        let groups =
            if one.name == "setup" { groups.chain(parts).collect() } else { groups.collect() };
        let labels =
            Labels { unknowns: readable.symbols.names(), repeats: repeats.clone(), groups };
        text(one.name, one.program, &labels) + "\n" + &table(last.program, one.program)
    });
    let texts: Vec<String> = texts.collect();
    if texts.is_empty() {
        return Err(functions.iter().map(|one| one.name).collect());
    }
    Ok(texts.join("\n"))
}

/// The operations of a program by section, in the order that `readable` has.
fn table(program: &Program, readable: &Program) -> String {
    let order: Vec<(&str, &str)> = readable.sections().map(Section::heading).collect();
    let mut sections = by_heading(program.sections());
    sections.sort_by_key(|one| order.iter().position(|other| *other == (one.title, one.source)));
    let row = |Headed { title, cost, .. }: &Headed| {
        let [mul, add, recip] = [cost.mul, cost.add, cost.recip];
        let [sqrt, trig] = [cost.sqrt, cost.trig];
        format!("{mul:>5} {add:>5} {recip:>6} {sqrt:>5} {trig:>5}   {title}\n")
    };
    let total = Headed { title: "all", source: "", cost: program.cost() };
    let head = "  mul   add  recip  sqrt  trig   operations of the final code\n";
    let rows: String = sections.iter().chain([&total]).map(row).collect();
    format!("{head}{rows}")
}
