//! Prints how a procedure reads its arguments.

use super::closure;
use super::loop_inputs::{LoopInput, pattern};
use super::names::helper;
use super::printer::Printer;
use super::{EmitContext, sealed};
use crate::ids::InputId;
use crate::program::{Argument, ArrayRole, ArraySlice, Given, ValueId};
use proc_macro2::{Ident, TokenStream};
use quote::quote;

/// Prints a load outside of loops.
pub fn load(printer: &Printer, from: &ArraySlice, into: &[Option<ValueId>]) -> TokenStream {
    let cx = printer.cx;
    let array = printer.array(from);
    let ArrayRole::Argument(argument) = array.role else {
        bug!("only arguments are read outside of loops")
    };
    let layout = &array.layout;
    let is_whole = layout.segments.len() == 1;
    let shortened = shortened(printer, into);
    let of_state = |vector: TokenStream| {
        if is_whole {
            return quote!(let [#shortened] = #vector.data.0;);
        }
        let (pattern, copy) =
            (pattern(&names(printer, into)), cx.segment(&vector, &layout.segments[from.segment]));
        quote!(let #pattern = #copy;)
    };
    match argument {
        Argument::Coordinates => of_state(quote!(state_.q)),
        Argument::Rates => of_state(quote!(state_.v)),
        Argument::Given(given) => of_state(self::given(given).1),
        Argument::Parameter(parameter) => {
            let field = &cx.chain.parameters[parameter].name;
            let names = names(printer, into);
            quote!(let #(#names)* = parameters_.#field;)
        }
        Argument::Constants => quote!(let #shortened = *constants_;),
        Argument::ClosureSteps => {
            let field = closure::steps(cx);
            quote!(let #shortened = parameters_.#field;)
        }
        Argument::Input(input) => {
            let name = cx.chain.name_of_input(cx.layout.inputs[input].what);
            let variables = input_variables(printer, input, into);
            cx.read_input(input, &quote!(inputs_.#name), &variables)
        }
        Argument::Slots(_) => {
            let derived = sealed::once(cx, &quote!(self));
            quote!(let #shortened = #derived;)
        }
        // The argument of the generated function has this name already.
        Argument::Step => TokenStream::new(),
        Argument::Time => bug!("no value is read from the time"),
    }
}

/// Prints a load in a loop: the iterator of the loop input, and statements that destructure an item.
pub fn loop_input(
    printer: &Printer,
    (argument, from): (Argument, &ArraySlice),
    into: &[Option<ValueId>],
) -> (LoopInput, TokenStream) {
    let cx = printer.cx;
    let segment = &printer.array(from).layout.segments[from.segment];
    let names = names(printer, into);
    let pattern = pattern(&names);
    let slices = |array: TokenStream| {
        let slices = cx.slices(&array, segment);
        ((quote!(&#pattern), quote!(#slices.iter())), TokenStream::new())
    };
    match argument {
        Argument::Coordinates => slices(quote!(state_.q)),
        Argument::Rates => slices(quote!(state_.v)),
        Argument::Given(given) => slices(self::given(given).1),
        Argument::Slots(Some(part)) => slices(sealed::of_part(cx, &quote!(self), part)),
        Argument::Parameter(parameter) => {
            let field = &cx.chain.parameters[parameter].name;
            ((quote!(&#(#names)*), quote!(parameters_.#field.iter())), TokenStream::new())
        }
        Argument::Input(input) => {
            let name = cx.chain.name_of_input(cx.layout.inputs[input].what);
            let item = helper(&format!("{name}_input"));
            let variables = input_variables(printer, input, into);
            let taken = cx.read_input(input, &quote!(#item), &variables);
            ((quote!(&#item), quote!(inputs_.#name.iter())), taken)
        }
        Argument::Constants
        | Argument::ClosureSteps
        | Argument::Step
        | Argument::Time
        | Argument::Slots(None) => bug!("a loop reads an argument outside of repeated parts"),
    }
}

/// Returns the name of the vector that the caller gives, and the vector.
pub fn given(given: Given) -> (&'static str, TokenStream) {
    match given {
        Given::Accelerations => ("accelerations", quote!((*accelerations_))),
        Given::Vector => ("vector", quote!((*vector_))),
        Given::DynamicParameters => ("parameters", quote!((*parameters_))),
        Given::Place => ("place", quote!((*place_))),
        Given::VirtualRates => bug!("virtual rates are not given"),
        Given::CoordinateDirection => ("direction.coordinates", quote!(direction_.coordinates)),
        Given::RateDirection => ("direction.rates", quote!(direction_.rates)),
        Given::InputDirection => ("direction.inputs", quote!(direction_.inputs)),
        Given::ParameterDirection => ("direction.parameters", quote!(direction_.parameters)),
    }
}

/// Returns the variables of values.
fn names(printer: &Printer, into: &[Option<ValueId>]) -> Vec<Option<Ident>> {
    into.iter().map(|value| value.map(|value| printer.variables.get(value).clone())).collect()
}

/// Returns a pattern of the first entries of an array, up to the last that is read.
fn shortened(printer: &Printer, into: &[Option<ValueId>]) -> TokenStream {
    let count = into.iter().rposition(Option::is_some).map_or(0, |last| last + 1);
    let entries = into[..count].iter().map(|value| match value {
        Some(value) => {
            let name = printer.variables.get(*value);
            quote!(#name)
        }
        None => quote!(_),
    });
    let rest = (count < into.len()).then(|| quote!(, ..));
    quote!([#(#entries),* #rest])
}

/// Returns variables for all values of an input, also for unread ones, since an input is destructured as a whole.
fn input_variables(printer: &Printer, input: InputId, into: &[Option<ValueId>]) -> Vec<Ident> {
    let own = printer.cx.input_variables(input);
    let variable = |(value, own): (&Option<ValueId>, Ident)| match value {
        Some(value) => printer.variables.get(*value).clone(),
        None => own,
    };
    into.iter().zip(own).map(variable).collect()
}

impl EmitContext<'_> {
    /// Returns the variables for all values of an input.
    pub fn input_variables(&self, input: InputId) -> Vec<Ident> {
        let symbols = self.compiled.unknowns.of(Argument::Input(input)).into_iter();
        symbols.map(|symbol| self.unknowns[symbol].clone()).collect()
    }
}
