//! The functions of a chain as readable text.

use super::pipeline::readable;
use super::{CompiledFunction, compile, specs};
use crate::examine::Findings;
use crate::function::Function;
use crate::ids::RepeatId;
use crate::model::{Chain, Layout};
use crate::passes::SetupSlots;
use crate::program::text::{Labels, text};
use crate::program::{OutputId, Procedure, Program, Section, SectionCost, by_heading};

/// Returns the text of all functions of a chain, or of one function, in the order of the equations. A table of the operation
/// counts of the final code by section follows each function.
///
/// # Errors
///
/// Returns the names of the functions if the chain has no function of this name.
pub fn chain_text(
    chain: &Chain,
    findings: &Findings,
    function: Option<&str>,
) -> Result<String, Vec<&'static str>> {
    let layout = Layout::of(chain);
    let compiled = compile(chain, findings, &layout);
    let mut setup = SetupSlots::default();
    let programs = specs(chain, findings, &layout, |compiler, specs| {
        let mut all: Vec<(Program, Labels)> = Vec::new();
        for spec in specs {
            let function = (spec.trace)(compiler).function;
            all.push(readable_program(chain, function, &mut setup));
        }
        let function = compiler.setup(&setup, &compiled.checks);
        all.insert(0, readable_program(chain, function, &mut SetupSlots::default()));
        all
    });
    let functions = std::iter::once(&compiled.setup).chain(&compiled.functions);
    let all: Vec<(&CompiledFunction, _)> = functions.zip(&programs).collect();
    let wanted =
        all.iter().filter(|(compiled, _)| function.is_none_or(|name| name == compiled.name()));
    let texts = wanted.map(|(compiled, (program, labels))| {
        text(compiled.name(), program, labels) + "\n" + &table(&compiled.procedure, program)
    });
    let texts: Vec<String> = texts.collect();
    if texts.is_empty() {
        return Err(all.iter().map(|(compiled, _)| compiled.name()).collect());
    }
    Ok(texts.join("\n"))
}

/// Returns the program of a function in the order of its equations, and the names for its loops and results.
fn readable_program(
    chain: &Chain,
    function: Function,
    setup: &mut SetupSlots,
) -> (Program, Labels) {
    let repeats = chain.repeats.iter().map(|repeat| {
        let name = chain.hinges[repeat.hinges.first()].name.to_string();
        (name, repeat.count)
    });
    let repeats: Vec<(String, usize)> = repeats.collect();
    let label = |id: OutputId| match id.part {
        Some(RepeatId(part)) => format!("{}_of_{}", id.name, repeats[part].0),
        None => id.name.to_owned(),
    };
    let outputs = function.outputs.iter().map(|output| (label(output.id), output.values.len()));
    let labels = Labels { outputs: outputs.collect(), repeats: repeats.clone() };
    (readable(function, setup), labels)
}

/// Returns the table of a procedure's operation counts by section, in the order of the readable program.
fn table(procedure: &Procedure, readable: &Program) -> String {
    let order: Vec<(&str, &str)> = readable.sections().map(Section::heading).collect();
    let mut sections = by_heading(procedure.sections());
    sections
        .sort_by_key(|cost| order.iter().position(|heading| *heading == (cost.title, cost.source)));
    let row = |SectionCost { title, cost, .. }: &SectionCost| {
        let [mul, add, recip] = [cost.mul, cost.add, cost.recip];
        let [sqrt, trig] = [cost.sqrt, cost.trig];
        format!("{mul:>5} {add:>5} {recip:>6} {sqrt:>5} {trig:>5}   {title}\n")
    };
    let total = SectionCost { title: "all", source: "", cost: procedure.cost() };
    let head = "  mul   add  recip  sqrt  trig   operations of the final code\n";
    let rows: String = sections.iter().chain([&total]).map(row).collect();
    format!("{head}{rows}")
}
