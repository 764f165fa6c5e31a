//! A program as statements.

use super::Plan;
use super::closure;
use super::delivery::Deliveries;
use super::looped::{self, Masks, Target};
use super::names::{Variables, helper};
use super::sealed;
use super::spread::Spread;
use super::statement::Writer;
use crate::compile::groups;
use crate::program::{Loop, Operand, Program, Section, Statement};
use proc_macro2::{Delimiter, Group, TokenStream};
use quote::{ToTokens, quote};
use std::ops::Range;

/// The statements of a program and its results.
pub struct Results {
    /// What its values are.
    pub variables: Variables,
    /// All statements, reading the unknowns first.
    pub statements: TokenStream,
    /// The groups of results, those of repeated parts left out.
    pub outputs: Vec<Vec<TokenStream>>,
    /// The groups of results as arrays.
    pub arrays: Vec<TokenStream>,
    /// Whether the program has loops.
    pub looped: bool,
    /// The pivots of repeated parts.
    pub masks: Masks,
}

/// Programs of more statements than this declare names, many at once, before they compute them.
///
/// Small ones read better with one `let` a line. But every `let` opens a scope inside the one
/// before, and rustc walks nested scopes recursively where it writes debug information: some
/// thousands of them overflow its stack.
const NESTED_SCOPES: usize = 1000;

impl Plan<'_> {
    /// A program of the step: it reads `state`, `inputs` and what the chain keeps. Where parts are repeated
    /// its results go into arrays as `targets` say, and its second and third groups are pivots and
    /// scales if `pivoted`.
    pub fn step(&self, program: &Program, targets: &[Target], pivoted: bool) -> Results {
        self.finished(self.opened(program, pivoted), program, targets)
    }

    /// The same without statements, but for those that read the unknowns.
    pub fn opened(&self, program: &Program, pivoted: bool) -> Results {
        let looped = !self.chain.repeats.is_empty();
        let variables = Variables::of(program);
        let reading = if looped {
            let once = self.read_once(program);
            let (slots, inputs) =
                (read_slots(self, program, &variables), self.read_inputs(program));
            quote!(#slots #once #inputs)
        } else {
            let coordinates =
                self.read(program, self.programs.symbols.q(), quote!(state_.q.data.0));
            let rates = self.read(program, self.programs.symbols.v(), quote!(state_.v.data.0));
            let (slots, inputs) =
                (read_slots(self, program, &variables), self.read_inputs(program));
            quote!(#slots #coordinates #rates #inputs)
        };
        let masks: Masks = if pivoted {
            let is_repeated =
                |group: usize, k: usize| program.outputs[group][k] == Operand::Repeated;
            let all = 0..program.outputs[groups::PIVOTS].len();
            let repeated =
                all.filter(|&k| is_repeated(groups::PIVOTS, k) || is_repeated(groups::SCALES, k));
            repeated.map(|k| (k, helper(&format!("regular{k}")))).collect()
        } else {
            Masks::new()
        };
        Results { masks, ..self.results(program, variables, reading) }
    }

    /// What reads the unknowns, the statements, and what is written in between.
    pub fn delivering(
        &self,
        opened: Results,
        program: &Program,
        mut deliveries: Deliveries,
    ) -> TokenStream {
        let mut writer = Writer::after(self, &opened.variables, opened.statements);
        writer.add(deliveries.at_once());
        writer.sections_with(program.sections(), is_long(program), &mut |writer, statement| {
            writer.add(deliveries.after(statement));
        });
        writer.finish()
    }

    /// The program of the setup: it reads `parameters`, the steps of a closure among them, and `constants`.
    pub fn setup_block(&self, program: &Program, targets: &[Target]) -> Results {
        let parameters = self.chain.parameters.iter().zip(self.programs.symbols.parameters());
        let parameters =
            parameters.filter(|(_, number)| reads(program, *number)).map(|(parameter, number)| {
                let (name, field) = (&self.unknowns[number], &parameter.name);
                quote!(let #name = parameters_.#field;)
            });
        let constants =
            self.read_array(program, self.programs.symbols.constants(), quote!(*constants_));
        let (steps, field) = (self.programs.symbols.closure_steps(), closure::steps(self));
        let steps = self.read_array(program, steps, quote!(parameters_.#field));
        let reading = quote!(#(#parameters)* #constants #steps);
        let results = self.results(program, Variables::of(program), reading);
        self.finished(results, program, targets)
    }

    /// Results with the statements of a program that may have loops.
    fn finished(&self, mut results: Results, program: &Program, targets: &[Target]) -> Results {
        if self.chain.repeats.is_empty() {
            let mut writer = Writer::after(self, &results.variables, results.statements);
            writer.sections(program.sections(), is_long(program));
            results.statements = writer.finish();
            return results;
        }
        results.looped = true;
        let looped = self.looped(program, targets, &results);
        results.statements.extend(looped);
        for target in targets {
            results.arrays[target.group] = looped::array(target.group).to_token_stream();
        }
        results
    }

    /// The results of a program whose statements are still to come.
    pub(super) fn results(
        &self,
        program: &Program,
        variables: Variables,
        reading: TokenStream,
    ) -> Results {
        let operands = |group: &Vec<Operand>| -> Vec<TokenStream> {
            group.iter().map(|operand| self.operand(&variables, operand)).collect()
        };
        let outputs: Vec<Vec<TokenStream>> = program.outputs.iter().map(operands).collect();
        let arrays = outputs.iter().map(|group| quote!([#(#group),*])).collect();
        let constant = uses_numbers(program).then(|| {
            let c = helper("c");
            quote!(let #c = T::constant;)
        });
        let statements = quote!(#constant #reading);
        Results { variables, statements, outputs, arrays, looped: false, masks: Masks::new() }
    }

    /// Some sections.
    pub fn sections(&self, variables: &Variables, sections: &[Section], flat: bool) -> TokenStream {
        let mut writer = Writer::new(self, variables);
        writer.sections(sections, flat);
        writer.finish()
    }

    /// Takes the unknowns that stand once out of arrays that hold those of repeated parts as well.
    fn read_once(&self, program: &Program) -> TokenStream {
        let mstmm = &self.mstmm;
        let symbols = &self.programs.symbols;
        let both = [
            (symbols.q(), Spread::coordinates(self), quote!(state_.q)),
            (symbols.v(), Spread::freedoms(self), quote!(state_.v)),
        ];
        let mut reading = TokenStream::new();
        for (range, spread, from) in both {
            for piece in spread.pieces.iter().filter(|piece| piece.repeat.is_none()) {
                let first = range.start + piece.first;
                if let Some(pattern) = self.whole_pattern(program, first..first + piece.count) {
                    let [count, place] = [piece.count, piece.place].map(looped::usize_literal);
                    reading.extend(quote! {
                        let #pattern =
                            #mstmm::generated::piece::<T, #count>(#from.as_slice(), #place);
                    });
                }
            }
        }
        reading
    }

    /// A pattern of all unknowns in `range`, naming those that the program reads.
    fn whole_pattern(&self, program: &Program, range: Range<usize>) -> Option<TokenStream> {
        let any = range.clone().any(|number| reads(program, number));
        let entries = range.map(|number| {
            let name = &self.unknowns[number];
            if reads(program, number) { quote!(#name) } else { quote!(_) }
        });
        any.then(|| quote!([#(#entries),*]))
    }

    /// An operand of a program with these variables.
    pub fn operand(&self, variables: &Variables, operand: &Operand) -> TokenStream {
        let mut writer = Writer::new(self, variables);
        writer.operand(operand);
        writer.finish()
    }

    /// Takes the unknowns in `range` out of the only column of a vector.
    fn read(&self, program: &Program, range: Range<usize>, from: TokenStream) -> TokenStream {
        let pattern = self.pattern(program, range);
        pattern.map_or_else(TokenStream::new, |pattern| quote!(let [#pattern] = #from;))
    }

    fn read_array(&self, program: &Program, range: Range<usize>, from: TokenStream) -> TokenStream {
        let pattern = self.pattern(program, range);
        pattern.map_or_else(TokenStream::new, |pattern| quote!(let #pattern = #from;))
    }

    /// A pattern that names the unknowns in `range` that the program reads.
    fn pattern(&self, program: &Program, range: Range<usize>) -> Option<TokenStream> {
        let last = range.clone().rev().find(|&number| reads(program, number))?;
        let entries = (range.start..=last).map(|number| {
            let name = &self.unknowns[number];
            if reads(program, number) { quote!(#name) } else { quote!(_) }
        });
        let rest = (last + 1 < range.end).then(|| quote!(, ..));
        Some(quote!([#(#entries),* #rest]))
    }
}

/// The body of a function: statements, and what follows them. As a group it is put into `quote!`
/// without a copy of every token.
pub fn body(mut statements: TokenStream, rest: TokenStream) -> Group {
    statements.extend(rest);
    Group::new(Delimiter::Brace, statements)
}

/// Whether a program has more statements than may open a scope each.
pub fn is_long(program: &Program) -> bool {
    program.sections().map(|section| section.statements.len()).sum::<usize>() > NESTED_SCOPES
}

pub(super) fn reads(program: &Program, number: usize) -> bool {
    program.symbols.binary_search(&(number as u32)).is_ok()
}

/// Takes the slots that the program reads out of what the chain keeps.
fn read_slots(plan: &Plan, program: &Program, variables: &Variables) -> TokenStream {
    let Some(last) = program.slots.iter().map(|slot| slot.index).max() else {
        return TokenStream::new();
    };
    let entries =
        (0..=last).map(|index| match program.slots.iter().find(|slot| slot.index == index) {
            Some(slot) => {
                let name = variables.get(slot.name);
                quote!(#name)
            }
            None => quote!(_),
        });
    let derived = sealed::once(plan, &quote!(self));
    quote!(let [#(#entries,)* ..] = #derived;)
}

/// Whether a known number stands anywhere in the program.
fn uses_numbers(program: &Program) -> bool {
    fn number(operand: &Operand) -> bool {
        match operand {
            Operand::Number(_) => true,
            Operand::Minus(inner) => number(inner),
            Operand::Symbol(_) | Operand::Named(_) | Operand::Repeated => false,
        }
    }
    let in_statement = |statement: &Statement| statement.operands().any(number);
    let carried = |turn: &Loop| turn.carries.iter().any(|c| number(&c.first) || number(&c.next));
    let written = |turn: &Loop| turn.outputs.iter().any(|(_, _, value)| number(value));
    program.sections().flat_map(|section| &section.statements).any(in_statement)
        || program.outputs.iter().flatten().any(number)
        || program.loops().any(|turn| carried(turn) || written(turn))
}
