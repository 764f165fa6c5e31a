//! Programs whose values are kept in memory until they are needed again.
//!
//! They read the unknowns when they are needed, too, and again rather than keep them: by other references,
//! of which the compiler does not know that they lead to the same.

use super::Plan;
use super::block::{Results, reads};
use super::looped::usize_literal;
use super::names::local;
use super::statement::{Around, Writer};
use crate::model::{Driven, Input};
use crate::program::{Move, Operand, Program, Spills};
use proc_macro2::{Delimiter, Ident, Literal, TokenStream};
use quote::{format_ident, quote};
use std::collections::{HashMap, HashSet};

/// From where unknowns and values known since setup are read.
#[derive(Default)]
struct Sources<'a> {
    /// The name of a reference to an array, and the place in it; without one, of a reference to a number.
    of: HashMap<&'a str, (String, Option<usize>)>,
    /// Statements that make the references.
    borrowed: TokenStream,
    /// The same of references for reading again.
    borrowed_again: TokenStream,
    /// What has been read.
    read: HashSet<String>,
}

impl Plan<'_> {
    /// A program of the step whose values move so.
    pub fn spilling(&self, program: &Program, spills: &Spills) -> Results {
        let mut sources = Sources::default();
        self.borrow_slots(program, &mut sources);
        self.borrow_state(program, &mut sources);
        self.borrow_inputs(program, &mut sources);
        let mut results = self.results(program, self.room(spills, &sources));
        let mut writer = Writer::after(self, results.statements);
        let mut moves = spills.moves.iter();
        let mut around = |writer: &mut Writer, around: Around| {
            if let Around::Before = around {
                let moves = moves.next().into_iter().flatten();
                moves.for_each(|it| self.moved(it, &mut sources, writer));
            }
        };
        writer.sections_with(program.sections(), false, &mut around);
        moves.flatten().for_each(|it| self.moved(it, &mut sources, &mut writer));
        results.statements = writer.finish();
        results
    }

    /// Places in memory, and references.
    fn room(&self, spills: &Spills, sources: &Sources) -> TokenStream {
        let mstmm = self.mstmm;
        let count = usize_literal(spills.places);
        let places = (0..spills.places).map(|number| local(&place(number)));
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

    fn borrow_slots<'b>(&self, program: &'b Program, sources: &mut Sources<'b>) {
        for slot in &program.slots {
            sources.of.insert(&slot.name, ("derived".to_owned(), Some(slot.index)));
        }
        if !program.slots.is_empty() {
            sources.borrow("derived", |name, again| {
                let owner = if again { quote!(self_again_) } else { quote!(self) };
                quote!(let #name = &#owner.derived;)
            });
        }
    }

    fn borrow_state<'b>(&'b self, program: &Program, sources: &mut Sources<'b>) {
        let symbols = &self.programs.symbols;
        for (range, vector) in [(symbols.q(), "q"), (symbols.v(), "v")] {
            let read: Vec<usize> = range.clone().filter(|&number| reads(program, number)).collect();
            for &number in &read {
                let source = (vector.to_owned(), Some(number - range.start));
                sources.of.insert(&symbols.names()[number], source);
            }
            if !read.is_empty() {
                let field = format_ident!("{vector}");
                sources.borrow(vector, |name, again| {
                    let state = if again { quote!(state_again_) } else { quote!(state_) };
                    quote!(let [#name] = &#state.#field.data.0;)
                });
            }
        }
    }

    /// Borrows inputs, but for prescribed motions, which are taken apart.
    fn borrow_inputs<'b>(&'b self, program: &Program, sources: &mut Sources<'b>) {
        for input in self.needed_inputs(program) {
            if let Driven::Motion(_) = input.what {
                sources.borrowed.extend(self.read_whole_input(input));
            } else {
                self.borrow_input(input, sources);
            }
        }
    }

    fn borrow_input<'b>(&'b self, input: &Input, sources: &mut Sources<'b>) {
        let symbols = &self.programs.symbols;
        let field = self.chain.name_of_input(input.what);
        // No value is called so, whatever its hinge is called: behind a hinge stands what it is.
        let name = format!("{field}_input");
        let first = symbols.inputs().start + input.range.start;
        let one = input.range.len() == 1;
        for (place, symbol) in symbols.names()[first..][..input.range.len()].iter().enumerate() {
            sources.of.insert(symbol, (name.clone(), (!one).then_some(place)));
        }
        sources.borrow(&name, |name, again| {
            let inputs = if again { quote!(inputs_again_) } else { quote!(inputs_) };
            if one {
                quote!(let #name = &#inputs.#field;)
            } else {
                quote!(let [#name] = &#inputs.#field.data.0;)
            }
        });
    }

    /// Writes a move.
    fn moved(&self, it: &Move, sources: &mut Sources, writer: &mut Writer) {
        let name = |operand: &Operand| match operand {
            Operand::Symbol(number) => self.programs.symbols.names()[*number as usize].clone(),
            operand => operand.name().unwrap_or_default().to_owned(),
        };
        match it {
            Move::Read(operand) => sources.read(name(operand), writer),
            Move::Spill(operand, number) => {
                let name = name(operand);
                writer.assign(&spilled(&name), |writer| {
                    writer.generated("spill");
                    writer.group(Delimiter::Parenthesis, |arguments| {
                        arguments.local(&place(*number));
                        arguments.sign(',');
                        arguments.local(&name);
                    });
                });
            }
            Move::Reload(operand) => {
                let name = name(operand);
                writer.assign(&name, |writer| {
                    writer.sign('*');
                    writer.local(&spilled(&name));
                });
            }
        }
    }
}

impl Sources<'_> {
    /// Makes a reference of this name, and one for reading again.
    fn borrow(&mut self, name: &str, borrowed: impl Fn(Ident, bool) -> TokenStream) {
        self.borrowed.extend(borrowed(local(name), false));
        self.borrowed_again.extend(borrowed(local(&again(name)), true));
    }

    /// Reads a number.
    fn read(&mut self, name: String, writer: &mut Writer) {
        let Some((source, place)) = self.of.get(name.as_str()) else { return };
        let is_first = self.read.insert(name.clone());
        let source = if is_first { source.clone() } else { again(source) };
        writer.assign(&name, |writer| match *place {
            Some(place) => {
                writer.local(&source);
                writer.group(Delimiter::Bracket, |index| {
                    index.literal(Literal::usize_unsuffixed(place));
                });
            }
            None => {
                writer.sign('*');
                writer.local(&source);
            }
        });
    }
}

/// The name of a place in memory.
fn place(number: usize) -> String {
    format!("place{number}")
}

/// The name of a value in memory.
fn spilled(name: &str) -> String {
    format!("{name}_spilled")
}

/// The name of a reference for reading again.
fn again(name: &str) -> String {
    format!("{name}_again")
}
