//! Programs whose values are kept in memory until they are needed again.
//!
//! They read the unknowns when they are needed, too, and again rather than keep them: by other references,
//! of which the compiler does not know that they lead to the same.

use super::Plan;
use super::block::{Results, reads};
use super::looped::usize_literal;
use super::names::{Variables, helper};
use super::sealed;
use super::statement::{Around, Writer};
use crate::model::{Driven, Input};
use crate::program::{Move, Name, Operand, Program, Spills};
use proc_macro2::{Delimiter, Ident, Literal, TokenStream};
use quote::{format_ident, quote};
use std::collections::HashMap;

/// From where unknowns and values known since setup are read.
#[derive(Default)]
struct Sources {
    symbols: HashMap<u32, Source>,
    slots: HashMap<Name, Source>,
    /// References to arrays and numbers, each with another for reading again.
    references: Vec<[Ident; 2]>,
    /// Statements that make the references.
    borrowed: TokenStream,
    /// The same of references for reading again.
    borrowed_again: TokenStream,
}

/// From where a number is read.
struct Source {
    /// The number of the reference.
    reference: usize,
    /// The place in an array; none of a reference to the number itself.
    place: Option<usize>,
    /// Whether it has been read.
    is_read: bool,
}

impl Plan<'_> {
    /// A program of the step whose values move so.
    pub fn spilling(&self, program: &Program, spills: &Spills) -> Results {
        let mut sources = Sources::default();
        self.borrow_slots(program, &mut sources);
        self.borrow_state(program, &mut sources);
        self.borrow_inputs(program, &mut sources);
        let room = self.room(spills, &sources);
        let mut results = self.results(program, Variables::of(program), room);
        let mut writer = Writer::after(self, &results.variables, results.statements);
        let mut moves = spills.moves.iter();
        let mut mover = Mover { plan: self, program, variables: &results.variables, sources };
        let mut around = |writer: &mut Writer, around: Around| {
            if let Around::Before = around {
                moves.next().into_iter().flatten().for_each(|it| mover.write(it, writer));
            }
        };
        writer.sections_with(program.sections(), false, &mut around);
        moves.flatten().for_each(|it| mover.write(it, &mut writer));
        results.statements = writer.finish();
        results
    }

    /// Places in memory, and references.
    fn room(&self, spills: &Spills, sources: &Sources) -> TokenStream {
        let mstmm = self.mstmm;
        let count = usize_literal(spills.places);
        let places = (0..spills.places).map(place);
        let Sources { borrowed, borrowed_again, .. } = sources;
        quote! {
            #borrowed
            /// Room for values until they are needed again, and references to read unknowns again.
            let mut room_ = #mstmm::generated::room::<T, #count>();
            let (room_, self_again_, state_again_, inputs_again_) =
                #mstmm::generated::in_memory::<T, _>((&mut room_, self, state_, inputs_));
            let [#(#places),*] = room_;
            #borrowed_again
        }
    }

    fn borrow_slots(&self, program: &Program, sources: &mut Sources) {
        if program.slots.is_empty() {
            return;
        }
        let reference = sources.borrow("derived", |name, again| {
            let owner = if again { quote!(self_again_) } else { quote!(self) };
            let derived = sealed::once(self, &owner);
            quote!(let #name = &#derived;)
        });
        for slot in &program.slots {
            sources.slots.insert(slot.name, Source::new(reference, Some(slot.index)));
        }
    }

    fn borrow_state(&self, program: &Program, sources: &mut Sources) {
        let symbols = &self.programs.symbols;
        for (range, vector) in [(symbols.q(), "q"), (symbols.v(), "v")] {
            let start = range.start;
            let read: Vec<usize> = range.filter(|&number| reads(program, number)).collect();
            if read.is_empty() {
                continue;
            }
            let field = format_ident!("{vector}");
            let reference = sources.borrow(vector, |name, again| {
                let state = if again { quote!(state_again_) } else { quote!(state_) };
                quote!(let [#name] = &#state.#field.data.0;)
            });
            for number in read {
                let source = Source::new(reference, Some(number - start));
                sources.symbols.insert(number as u32, source);
            }
        }
    }

    /// Borrows inputs, but for prescribed motions, which are taken apart.
    fn borrow_inputs(&self, program: &Program, sources: &mut Sources) {
        for input in self.needed_inputs(program) {
            if let Driven::Motion(_) = input.what {
                sources.borrowed.extend(self.read_whole_input(input));
            } else {
                self.borrow_input(input, sources);
            }
        }
    }

    fn borrow_input(&self, input: &Input, sources: &mut Sources) {
        let field = self.chain.name_of_input(input.what);
        let one = input.range.len() == 1;
        let reference = sources.borrow(&format!("{field}_input"), |name, again| {
            let inputs = if again { quote!(inputs_again_) } else { quote!(inputs_) };
            if one {
                quote!(let #name = &#inputs.#field;)
            } else {
                quote!(let [#name] = &#inputs.#field.data.0;)
            }
        });
        let first = self.programs.symbols.inputs().start + input.range.start;
        for place in 0..input.range.len() {
            let source = Source::new(reference, (!one).then_some(place));
            sources.symbols.insert((first + place) as u32, source);
        }
    }
}

/// Writes moves.
struct Mover<'a> {
    plan: &'a Plan<'a>,
    program: &'a Program,
    variables: &'a Variables,
    sources: Sources,
}

impl Mover<'_> {
    fn write(&mut self, it: &Move, writer: &mut Writer) {
        match it {
            Move::Read(operand) => self.read(operand, writer),
            Move::Spill(operand, number) => {
                let Some(spilled) = self.spilled(operand) else { return };
                writer.assign(&spilled, |writer| {
                    writer.generated("spill");
                    writer.group(Delimiter::Parenthesis, |arguments| {
                        arguments.variable(&place(*number));
                        arguments.sign(',');
                        arguments.operand(operand);
                    });
                });
            }
            Move::Reload(operand) => {
                let (variable, spilled) = (self.variable(operand), self.spilled(operand));
                let (Some(variable), Some(spilled)) = (variable, spilled) else { return };
                writer.assign(variable, |writer| {
                    writer.sign('*');
                    writer.variable(&spilled);
                });
            }
        }
    }

    /// Reads a number.
    fn read(&mut self, operand: &Operand, writer: &mut Writer) {
        let Sources { symbols, slots, references, .. } = &mut self.sources;
        let source = match operand {
            Operand::Symbol(number) => symbols.get_mut(number),
            operand => operand.name().and_then(|name| slots.get_mut(&name)),
        };
        let Some(Source { reference, place, is_read }) = source else { return };
        let [first, again] = &references[*reference];
        let reference = if std::mem::replace(is_read, true) { again } else { first }.clone();
        let place = *place;
        let Some(variable) = self.variable(operand) else { return };
        writer.assign(variable, |writer| match place {
            Some(place) => {
                writer.variable(&reference);
                writer.group(Delimiter::Bracket, |index| {
                    index.literal(Literal::usize_unsuffixed(place));
                });
            }
            None => {
                writer.sign('*');
                writer.variable(&reference);
            }
        });
    }

    /// The variable of an unknown or a value.
    fn variable(&self, operand: &Operand) -> Option<&Ident> {
        match operand {
            Operand::Symbol(number) => self.plan.unknowns.get(*number as usize),
            operand => Some(self.variables.get(operand.name()?)),
        }
    }

    /// The variable of a value in memory.
    fn spilled(&self, operand: &Operand) -> Option<Ident> {
        let text = match operand {
            Operand::Symbol(number) => &self.plan.programs.symbols.names()[*number as usize],
            operand => self.program.names.text(operand.name()?),
        };
        Some(helper(&format!("{text}_spilled")))
    }
}

impl Source {
    fn new(reference: usize, place: Option<usize>) -> Self {
        Source { reference, place, is_read: false }
    }
}

impl Sources {
    /// Makes a reference of this name, and one for reading again; returns their number.
    fn borrow(&mut self, name: &str, borrowed: impl Fn(&Ident, bool) -> TokenStream) -> usize {
        let references = [helper(name), helper(&format!("{name}_again"))];
        self.borrowed.extend(borrowed(&references[0], false));
        self.borrowed_again.extend(borrowed(&references[1], true));
        self.references.push(references);
        self.references.len() - 1
    }
}

/// A place in memory.
fn place(number: usize) -> Ident {
    helper(&format!("place{number}"))
}
