//! Prints a procedure as Rust statements.

use super::arrays::usize_literal;
use super::columns::Varying;
use super::names::{Variables, helper};
use super::printer::{Destination, Printer};
use super::{EmitContext, arguments, checks, loops};
use crate::program::{
    Array, ArrayId, ArrayRole, ArraySlice, Failure, Operand, OutputId, Procedure, Step,
};
use proc_macro2::{Delimiter, Group, Ident, TokenStream};
use quote::{ToTokens, format_ident, quote};

/// The largest number of statements with one `let` each. Longer procedures declare many names at once, before they compute
/// them.
///
/// One `let` per line is easier to read. But every `let` opens a scope inside the previous one, and rustc walks nested
/// scopes recursively when it writes debug information: some thousands of them overflow its stack.
const NESTED_SCOPES: usize = 1000;

impl EmitContext<'_> {
    /// Returns the statements of a procedure whose results are written to their `destination`, or replaced by `fresh` ones
    /// after a failure.
    pub fn procedure(
        &self,
        procedure: &Procedure,
        fresh: &TokenStream,
        destination: impl Fn(OutputId) -> Destination,
    ) -> TokenStream {
        self.typed(procedure, Varying::none(procedure), fresh, destination).print()
    }

    /// Returns the statements of a procedure for a product, with several factors in the type `C` of columns: first those
    /// that do not depend on the factor, then those that do.
    pub fn procedure_of_columns(
        &self,
        procedure: &Procedure,
        destination: impl Fn(OutputId) -> Destination,
    ) -> [TokenStream; 2] {
        let varying = Varying::of(procedure);
        let bodies = varying.split(&procedure.body);
        let printer = self.typed(procedure, varying, &TokenStream::new(), destination);
        let [once, columns] = &bodies;
        // The caller of the second part keeps its results back.
        let columns = Printer { body: columns, keeps_back: false, ..printer.clone() };
        [Printer { body: once, ..printer }, columns].map(|part| part.print())
    }

    /// Returns the statements of a procedure with limbs side by side, in the type `C` of packs.
    pub fn procedure_of_packs(
        &self,
        procedure: &Procedure,
        fresh: &TokenStream,
        destination: impl Fn(OutputId) -> Destination,
    ) -> TokenStream {
        self.typed(procedure, Varying::packs(procedure), fresh, destination).print()
    }

    fn typed<'a>(
        &'a self,
        procedure: &'a Procedure,
        varying: Varying,
        fresh: &TokenStream,
        destination: impl Fn(OutputId) -> Destination,
    ) -> Printer<'a> {
        let of_array = |array: &Array| match array.role {
            ArrayRole::Result(id) => Some(destination(id)),
            ArrayRole::Argument(_) | ArrayRole::Local(_) => None,
        };
        let mstmm = &self.mstmm;
        let reset = quote!(#mstmm::generated::reset(at_, || #fresh););
        let statements = procedure.sections().map(|section| section.statements.len());
        let has_finish = procedure.body.iter().any(|step| matches!(step, Step::CheckResults(_)));
        Printer {
            cx: self,
            procedure,
            body: &procedure.body,
            variables: Variables::of(&procedure.values),
            varying,
            destinations: procedure.arrays.iter().map(of_array).collect(),
            on_failure: (procedure.failure == Failure::Reset).then_some(reset),
            keeps_back: procedure.failure == Failure::Untouched && has_finish,
            looped: procedure.body.iter().any(|step| matches!(step, Step::Loop(_))),
            flat: statements.sum::<usize>() > NESTED_SCOPES,
        }
    }
}

impl Printer<'_> {
    fn print(&self) -> TokenStream {
        let steps = self.body;
        let given = steps.iter().take_while(|step| matches!(step, Step::CheckArguments(_))).count();
        let (given, steps) = steps.split_at(given);
        let mut writer = self.writer();
        given.iter().for_each(|step| writer.add(self.step(step)));
        writer.add(self.declared_results());
        if uses_numbers(self.body) {
            let c = helper("c");
            writer.add(quote!(let #c = T::constant;));
        }
        writer.add(loops::declarations(self));
        self.write_steps(&mut writer, steps, |step| self.step(step));
        writer.add(self.copied_results());
        writer.finish()
    }

    fn step(&self, step: &Step) -> TokenStream {
        match step {
            Step::CheckArguments(arrays) => checks::arguments(self, arrays),
            Step::TestBounds(bounds) => checks::bounds(self, bounds),
            Step::Load { from, into } => arguments::load(self, from, into),
            Step::Store { to, values } => self.store(to, values),
            Step::Loop(loop_) => loops::print(self, loop_),
            Step::CheckResults(check) => checks::results(self, check),
            Step::Compute(_) | Step::CheckPivot { .. } => {
                bug!("statements and pivot tests are printed with their loop")
            }
        }
    }

    /// Iterates over the results that are printed: those that these steps write, and empty ones.
    fn result_arrays(&self) -> impl Iterator<Item = (ArrayId, &Array)> {
        let all = self.procedure.arrays.enumerate();
        let results = all.filter(|(_, array)| matches!(array.role, ArrayRole::Result(_)));
        let writes = |steps: &[Step], id| steps.iter().any(|step| step.stores_into(id));
        results.filter(move |(id, _)| writes(self.body, *id) || !writes(&self.procedure.body, *id))
    }

    /// Declares the variables through which results are written: arrays that loops fill, and references to entries that are
    /// written one by one.
    fn declared_results(&self) -> TokenStream {
        let mut statements = TokenStream::new();
        for (id, array) in self.result_arrays() {
            if self.is_filled(id) {
                let (name, total) = (self.result(id), usize_literal(array.layout.total));
                let scalar = self.scalar(id);
                statements.extend(match self.destination(id) {
                    Destination::Array(_) | Destination::Vector(_) if self.keeps_back => {
                        quote!(let mut #name = [#scalar::constant(0.0); #total];)
                    }
                    Destination::Array(place) | Destination::Vector(place) => {
                        quote!(let #name = &mut #place;)
                    }
                    _ => quote!(let mut #name = [#scalar::constant(0.0); #total];),
                });
            } else if let Some(names) = self.entries(id) {
                statements.extend(match self.destination(id) {
                    Destination::Array(place) => quote!(let [#(#names),*] = &mut #place;),
                    Destination::Matrix(place, rows) => {
                        let columns = names.chunks(*rows).map(|column| quote!([#(#column),*]));
                        quote!(let [#(#columns),*] = &mut #place.data.0;)
                    }
                    _ => TokenStream::new(),
                });
            }
        }
        statements
    }

    /// Returns the patterns of the entries of an array that are written one by one, if there are any.
    fn entries(&self, id: ArrayId) -> Option<Vec<TokenStream>> {
        let mut names = vec![quote!(_); self.procedure.arrays[id].layout.entries()];
        let mut any = false;
        for step in self.body {
            if let Step::Store { to, values } = step
                && to.array == id
                && !self.is_whole(to, values)
            {
                let name = entry(to);
                (names[to.first], any) = (name.to_token_stream(), true);
            }
        }
        any.then_some(names)
    }

    /// Returns whether a store writes a whole array.
    fn is_whole(&self, to: &ArraySlice, values: &[Option<Operand>]) -> bool {
        values.len() == self.array(to).layout.total
    }

    fn store(&self, to: &ArraySlice, values: &[Option<Operand>]) -> TokenStream {
        if self.is_filled(to.array) {
            return loops::fill(self, to, values);
        }
        let operand = |value: &Option<Operand>| match value {
            Some(value) => self.stored(to.array, value),
            None => bug!("a result outside of repeated parts is missing"),
        };
        let operands: Vec<TokenStream> = values.iter().map(operand).collect();
        match self.destination(to.array) {
            Destination::Array(place) if self.is_whole(to, values) => {
                quote!(#place = [#(#operands),*];)
            }
            Destination::Matrix(place, rows) if self.is_whole(to, values) => {
                let columns = operands.chunks(*rows).map(|column| quote!([#(#column),*]));
                quote!(#place.data.0 = [#(#columns),*];)
            }
            Destination::Array(_) | Destination::Matrix(..) => {
                let name = entry(to);
                quote!(*#name = #(#operands)*;)
            }
            Destination::Vector(place) => quote!(#place.data.0 = [[#(#operands),*]];),
            Destination::Fields(places) => {
                let places = &places[to.first..to.first + values.len()];
                quote!(#(#places = #operands;)*)
            }
            Destination::New(name) => quote!(let #name = [#(#operands),*];),
            Destination::Closure => {
                let mstmm = &self.cx.mstmm;
                let wrenches = operands.chunks(6).map(|wrench| quote!([#(#wrench),*]));
                quote!(at_.closure = #mstmm::generated::loop_closure([#(#wrenches),*]);)
            }
        }
    }

    /// Copies results that were kept back to their destination.
    fn copied_results(&self) -> TokenStream {
        let mut statements = TokenStream::new();
        for (id, _) in self.result_arrays().filter(|(id, _)| self.is_filled(*id)) {
            let name = self.result(id);
            if self.keeps_back {
                statements.extend(match self.destination(id) {
                    Destination::Vector(place) => quote!(#place.data.0 = [#name];),
                    Destination::Array(place) => quote!(#place = #name;),
                    Destination::New(_) => TokenStream::new(),
                    Destination::Matrix(..) | Destination::Fields(_) | Destination::Closure => {
                        bug!("a result that is not filled is kept back")
                    }
                });
            }
        }
        // No step writes an empty array.
        let is_stored =
            |id| self.is_filled(id) || self.body.iter().any(|step| step.stores_into(id));
        for (id, _) in self.result_arrays().filter(|(id, _)| !is_stored(*id)) {
            if let Destination::New(name) = self.destination(id) {
                let scalar = self.scalar(id);
                statements.extend(quote!(let #name: [#scalar; 0] = [];));
            }
        }
        statements
    }
}

/// Returns the variable of an entry that is written separately; its name is unique among all arrays.
fn entry(to: &ArraySlice) -> Ident {
    helper(&format!("n{}_{}", to.array.index(), to.first))
}

/// Returns the body of a function that consists of these parts. It is a group so that `quote!` need not copy every token.
pub fn body<const N: usize>(parts: [TokenStream; N]) -> Group {
    Group::new(Delimiter::Brace, parts.into_iter().collect())
}

/// Returns whether some steps contain a known number.
fn uses_numbers(steps: &[Step]) -> bool {
    let number = |operand: &Operand| operand.is_known();
    steps.iter().any(|step| match step {
        Step::CheckArguments(_) | Step::TestBounds(_) | Step::Load { .. } => false,
        Step::Compute(section) => {
            section.statements.iter().any(|statement| statement.operands().any(number))
        }
        Step::Store { values, .. } => values.iter().flatten().any(number),
        Step::CheckPivot { value, scale, .. } => number(value) || number(scale),
        Step::CheckResults(check) => check.operands().any(number),
        Step::Loop(loop_) => {
            let carried =
                loop_.carries.iter().any(|carry| number(&carry.init) || number(&carry.next));
            carried || uses_numbers(&loop_.body)
        }
    })
}

/// Returns a field of the workspace.
pub fn field(name: &str) -> TokenStream {
    let name = format_ident!("{name}");
    quote!(at_.#name)
}
