//! The state of the printer of a procedure: variables, destinations of results, and how sections are written.

use super::EmitContext;
use super::columns::Varying;
use super::names::{Variables, helper};
use super::statement::Writer;
use crate::program::{Array, ArrayId, ArraySlice, CheckId, Operand, Procedure, Section, Step};
use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens, quote};

/// The destination of a result.
#[derive(Clone, Debug)]
pub enum Destination {
    /// The caller's array.
    Array(TokenStream),
    /// The caller's vector.
    Vector(TokenStream),
    /// The caller's matrix with this number of rows, by columns.
    Matrix(TokenStream, usize),
    /// The caller's fields, one per entry.
    Fields(Vec<TokenStream>),
    /// A new array.
    New(Ident),
    /// The undetermined constraint wrenches of a workspace.
    Closure,
}

/// A procedure that is being printed.
#[derive(Clone)]
pub struct Printer<'a> {
    pub cx: &'a EmitContext<'a>,
    pub procedure: &'a Procedure,
    /// The steps that are printed: all of its steps or some of them.
    pub body: &'a [Step],
    /// The variables of its values.
    pub variables: Variables,
    /// The values that differ between columns, if it computes several columns at a time.
    pub varying: Varying,
    /// The destinations of its results, by array.
    pub destinations: Vec<Option<Destination>>,
    /// Statements that run before it returns an error.
    pub on_failure: Option<TokenStream>,
    /// Whether results must not reach the caller before they are checked.
    pub keeps_back: bool,
    /// Whether it has loops.
    pub looped: bool,
    /// Whether it has too many statements for a separate `let` each.
    pub flat: bool,
}

impl Printer<'_> {
    /// Returns an empty writer for the procedure.
    pub fn writer(&self) -> Writer<'_> {
        Writer::new(self.cx, &self.variables, &self.varying)
    }

    /// Writes steps in order: sections under their headings, other steps by `other`.
    pub fn write_steps(
        &self,
        writer: &mut Writer,
        steps: &[Step],
        other: impl Fn(&Step) -> TokenStream,
    ) {
        let sections: Vec<&Section> = steps.iter().filter_map(computed).collect();
        let mut headings = writer.headings(&sections);
        let (mut number, mut declared, mut stored) = (0, 0, false);
        for step in steps {
            let Step::Compute(section) = step else {
                stored = number > 0 && self.is_kept_in_place(step);
                writer.add(other(step));
                continue;
            };
            if std::mem::take(&mut stored) {
                let mstmm = &self.cx.mstmm;
                writer.add(quote!(#mstmm::generated::store_fence();));
            }
            if self.flat && number == declared {
                declared = writer.declare(&sections, declared, &mut headings);
            }
            let goes_on = number > 0 && sections[number - 1].heading() == section.heading();
            if !self.flat && !goes_on {
                writer.heading_of(section, &mut headings);
            }
            writer.statements(section, !self.flat);
            number += 1;
        }
    }

    /// Returns whether a step must not move past the statements that follow. LLVM delays stores in order to vectorise
    /// neighbouring ones, and the results of all connection points then wait in memory. Entries of matrices may wait: with
    /// fences the mass matrix of three balls takes 1.15 times as long.
    fn is_kept_in_place(&self, step: &Step) -> bool {
        match step {
            Step::Store { to, .. } => {
                !matches!(self.destination(to.array), Destination::Matrix(..))
            }
            Step::CheckResults(_) => true,
            _ => false,
        }
    }

    /// Prints an operand in the type of its value.
    pub fn operand(&self, operand: &Operand) -> TokenStream {
        self.operand_of(operand, self.varying.operand(operand))
    }

    /// Prints an operand, of the type of columns if `varying`.
    pub fn operand_of(&self, operand: &Operand, varying: bool) -> TokenStream {
        let mut writer = self.writer();
        writer.operand(operand, varying);
        writer.finish()
    }

    /// Prints a value that is stored in an array.
    pub fn stored(&self, array: ArrayId, operand: &Operand) -> TokenStream {
        self.operand_of(operand, self.varying.array(array))
    }

    /// Prints the scalar type of an array, `C` for columns.
    pub fn scalar(&self, array: ArrayId) -> TokenStream {
        if self.varying.array(array) { quote!(C) } else { quote!(T) }
    }

    /// Returns the array of a slice.
    pub fn array(&self, slice: &ArraySlice) -> &Array {
        &self.procedure.arrays[slice.array]
    }

    pub fn destination(&self, array: ArrayId) -> &Destination {
        let destination = &self.destinations[array.index()];
        destination.as_ref().unwrap_or_else(|| bug!("an array that is no result is written"))
    }

    /// Returns the variable of a result that loops write: an array or a reference to an array.
    pub fn result(&self, array: ArrayId) -> Ident {
        match self.destination(array) {
            Destination::New(name) => name.clone(),
            _ => helper(&format!("results{}", array.index())),
        }
    }

    /// Returns a place expression for an array that is filled segment by segment.
    pub fn filled(&self, array: ArrayId) -> TokenStream {
        let name = self.result(array);
        match self.destination(array) {
            Destination::Array(_) | Destination::Vector(_) if !self.keeps_back => {
                quote!((*#name))
            }
            _ => quote!(#name),
        }
    }

    /// Returns a result that has been written.
    pub fn stored_result(&self, array: ArrayId) -> TokenStream {
        match self.destination(array) {
            Destination::Array(place) | Destination::Vector(place) if !self.is_filled(array) => {
                place.clone()
            }
            Destination::Matrix(place, _) => place.clone(),
            _ => self.result(array).into_token_stream(),
        }
    }

    /// Returns whether a result is an array that is filled segment by segment: because it has entries of repeated parts, or
    /// because it is kept back until the pivots of loops have been tested.
    pub fn is_filled(&self, array: ArrayId) -> bool {
        let is_array = match self.destination(array) {
            Destination::Array(_) | Destination::Vector(_) | Destination::New(_) => true,
            Destination::Matrix(..) | Destination::Fields(_) | Destination::Closure => false,
        };
        let segments = &self.procedure.arrays[array].layout.segments;
        let has_repeated = segments.iter().any(|segment| segment.repeat.is_some());
        is_array && (has_repeated || self.looped && self.keeps_back)
    }
}

fn computed(step: &Step) -> Option<&Section> {
    match step {
        Step::Compute(section) => Some(section),
        _ => None,
    }
}

/// Returns the flag that no repetition of a pivot vanishes.
pub fn flag(check: CheckId) -> Ident {
    helper(&format!("regular{}", check.index()))
}
