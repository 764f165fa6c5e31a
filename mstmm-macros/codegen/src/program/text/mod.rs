//! Prints a program as readable text, in the order of its equations.
//!
//! Values that are used once are written inside their user. Values without a name are numbered within their section:
//! `elbow_riccati_t3` if only the section reads the value, `elbow_riccati_x3` if other sections read it, so that an added
//! value renames nothing in other sections. In a loop, `carry a = b, then c` means that `a` is `b` in the first repetition
//! and the previous repetition's `c` in all others; after the loop `a` is the last repetition's `c`.

mod formula;
mod items;
mod layout;
mod uses;

use super::{Block, CarriedValue, LoopBlock, Operand, Program, ValueId};
use formula::Formula;
use items::{Item, ItemSection, items};
use std::collections::HashMap;
use uses::Uses;

/// The heading of results.
const RESULTS: &str = "Results";

/// Longer formulas get a separate line.
const MAX_INLINED: usize = 160;

/// The names of a program's loops and results.
#[derive(Clone, Debug)]
pub struct Labels {
    /// The name of one repetition of each repeated part, and the number of repetitions.
    pub repeats: Vec<(String, usize)>,
    /// The results, each with its number of entries.
    pub outputs: Vec<(String, usize)>,
}

/// Returns the text of a program.
pub fn text(function: &str, program: &Program, labels: &Labels) -> String {
    let blocks: Vec<Vec<ItemSection>> = program.blocks.iter().map(items).collect();
    let uses = Uses::of(program, &blocks);
    let mut printer = TextPrinter {
        program,
        labels,
        names: uses.names(program, &blocks),
        uses,
        inlined: HashMap::new(),
        counts: HashMap::new(),
        lines: Vec::new(),
        heading: String::new(),
        depth: 0,
    };
    printer.line(&format!("fn {function}() {{"));
    printer.depth += 1;
    for (block, sections) in program.blocks.iter().zip(&blocks) {
        match block {
            Block::Once(_) => printer.sections(sections),
            Block::Loop(loop_) => printer.print_loop(loop_, sections),
        }
    }
    printer.under(RESULTS, "", TextPrinter::results);
    printer.depth -= 1;
    printer.line("}");
    printer.lines.join("\n") + "\n"
}

struct TextPrinter<'a> {
    program: &'a Program,
    labels: &'a Labels,
    uses: Uses<'a>,
    /// The names of values, as far as they are assigned, by value.
    names: Vec<Option<String>>,
    /// The values that are written inside their user.
    inlined: HashMap<ValueId, Formula>,
    /// For each section, by its prefix: the number of unnamed values that no other section reads.
    counts: HashMap<String, usize>,
    lines: Vec<String>,
    /// The last heading that was written in the block.
    heading: String,
    depth: usize,
}

impl TextPrinter<'_> {
    fn line(&mut self, text: &str) {
        self.lines.extend(layout::broken(text, self.depth));
    }

    /// Writes the output of `write` under a heading, if there is any. The heading is not repeated if it is the same as
    /// the last one.
    fn under(&mut self, title: &str, source: &str, write: impl FnOnce(&mut Self)) {
        let first = self.lines.len();
        write(self);
        let lines = self.lines.split_off(first);
        if lines.is_empty() {
            return;
        }
        let source = if source.is_empty() { String::new() } else { format!(", {source}") };
        let heading = format!("// {title}{source}.");
        if self.heading != heading {
            self.gap();
            self.line(&heading);
            self.heading = heading;
        }
        self.lines.extend(lines);
    }

    /// Writes an empty line, except at the start of a block.
    fn gap(&mut self) {
        if !self.lines.last().is_some_and(|line| line.ends_with('{')) {
            self.lines.push(String::new());
        }
    }

    fn sections(&mut self, sections: &[ItemSection]) {
        for ItemSection { prefix, title, source, items } in sections {
            self.under(title, source, |printer| {
                items.iter().for_each(|item| printer.item(prefix, item));
            });
        }
    }

    fn item(&mut self, prefix: &str, item: &Item) {
        match item {
            Item::Let(name, operation) => {
                let formula = Formula::of(operation, &|operand| self.operand(operand));
                self.state(prefix, *name, formula);
            }
            Item::Angle { sine: Some(sine), cosine: Some(cosine), angle } => {
                let angle = self.operand(angle).text;
                let [sine, cosine] = [sine, cosine].map(|name| self.name(prefix, *name));
                self.line(&format!("let ({sine}, {cosine}) = sin_cos({angle});"));
            }
            Item::Angle { sine, cosine, angle } => {
                let angle = self.operand(angle).text;
                for (function, name) in [("sin", sine), ("cos", cosine)] {
                    if let Some(name) = name {
                        let formula = Formula::call(function, &[&angle]);
                        self.state(prefix, *name, formula);
                    }
                }
            }
        }
    }

    /// Writes a value, or keeps its formula for its only user.
    fn state(&mut self, prefix: &str, name: ValueId, formula: Formula) {
        let numbered = self.program.names.is_numbered(name);
        if numbered && self.uses.is_once(name) && formula.text.len() <= MAX_INLINED {
            self.inlined.insert(name, formula);
            return;
        }
        let name = self.name(prefix, name);
        self.line(&format!("let {name} = {};", formula.text));
    }

    /// Returns the name of a value; an unnamed value gets the next number of its section.
    fn name(&mut self, prefix: &str, name: ValueId) -> String {
        if let Some(known) = &self.names[name.index()] {
            return known.clone();
        }
        let count = self.counts.entry(prefix.to_owned()).or_default();
        *count += 1;
        let text = format!("{prefix}_t{count}");
        self.names[name.index()] = Some(text.clone());
        text
    }

    fn value(&self, value: ValueId) -> Formula {
        let name = || match &self.names[value.index()] {
            Some(name) => Formula::atom(name.clone()),
            None => bug!("a value is read before it is computed"),
        };
        self.inlined.get(&value).cloned().unwrap_or_else(name)
    }

    fn operand(&self, operand: &Operand) -> Formula {
        match operand {
            Operand::Number(value) => Formula::number(*value),
            Operand::Value(name) => self.value(*name),
            Operand::Minus(name) => self.value(*name).negated(),
        }
    }

    fn print_loop(&mut self, loop_: &LoopBlock, sections: &[ItemSection]) {
        let (item, count) = &self.labels.repeats[loop_.repeat.index()];
        let range = match loop_.inward {
            true => format!("(0..{count}).rev()"),
            false => format!("0..{count}"),
        };
        self.gap();
        self.line(&format!("for {item} in {range} {{"));
        self.heading.clear();
        self.depth += 1;
        let before = self.lines.len();
        self.sections(sections);
        self.under(RESULTS, "", |printer| printer.loop_results(loop_));
        // The loop-carried values have their names only now.
        let body = self.lines.split_off(before);
        loop_.carries.iter().for_each(|carried| self.carry(carried));
        if !loop_.carries.is_empty() {
            self.gap();
        }
        self.lines.extend(body);
        self.depth -= 1;
        self.line("}");
        self.heading.clear();
    }

    fn carry(&mut self, CarriedValue { phi, init, next, .. }: &CarriedValue) {
        let name = self.operand(&Operand::Value(*phi)).text;
        let [init, next] = [init, next].map(|operand| self.operand(operand).text);
        self.line(&format!("carry {name} = {init}, then {next};"));
    }

    fn loop_results(&mut self, loop_: &LoopBlock) {
        for (number, operand) in &loop_.results {
            let value = self.operand(operand).text;
            let (output, entry) = self.labels.entry(*number);
            self.line(&format!("{output}[{entry}] = {value};"));
        }
        for (number, value, scale) in &loop_.pivots {
            self.pivot(*number, value, scale);
        }
    }

    fn results(&mut self) {
        let (program, labels) = (self.program, self.labels);
        let mut start = 0;
        for (output, count) in &labels.outputs {
            let operands = &program.results[start..start + count];
            start += count;
            let values = operands.iter().enumerate();
            let values: Vec<(usize, String)> = values
                .filter_map(|(entry, value)| Some((entry, self.operand(value.as_ref()?).text)))
                .collect();
            if !values.is_empty() && values.len() == *count {
                let values: Vec<String> = values.into_iter().map(|(_, text)| text).collect();
                self.line(&format!("{output} = [{}];", values.join(", ")));
            } else {
                let line = |(entry, value)| format!("{output}[{entry}] = {value};");
                values.into_iter().map(line).for_each(|line| self.line(&line));
            }
        }
        for (number, pivot) in program.pivots.iter().enumerate() {
            if let Some((value, scale)) = pivot {
                self.pivot(number, value, scale);
            }
        }
    }

    fn pivot(&mut self, number: usize, value: &Operand, scale: &Operand) {
        let [value, scale] = [value, scale].map(|operand| self.operand(operand).text);
        self.line(&format!("pivots[{number}] = {value}, of the size of {scale};"));
    }
}

impl Labels {
    /// Returns the result that an index belongs to, and the entry of that result.
    fn entry(&self, number: usize) -> (&str, usize) {
        let mut start = 0;
        for (output, count) in &self.outputs {
            if number < start + count {
                return (output, number - start);
            }
            start += count;
        }
        bug!("a result belongs to no output")
    }
}
