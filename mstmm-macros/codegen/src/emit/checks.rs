//! Prints the tests of a procedure.

use super::EmitContext;
use super::arrays::usize_literal;
use super::names::helper;
use super::printer::{Printer, flag};
use crate::ids::InputId;
use crate::model::InputKind;
use crate::program::{
    Argument, ArrayId, ArrayRole, PivotTest, PivotValue, ResultCheck, ValueBound, Witness,
};
use proc_macro2::{Literal, TokenStream};
use quote::{ToTokens, quote};

/// Prints the test that arguments are finite. It comes first: after other statements it would be a branch across which the
/// compiler moves some statements and not others.
pub fn arguments(printer: &Printer, arrays: &[ArrayId]) -> TokenStream {
    let cx = printer.cx;
    let mstmm = &cx.mstmm;
    // Scalars share a slice: a loop over many short slices takes longer than some functions.
    let (mut taken, mut scalars, mut slices) = (TokenStream::new(), Vec::new(), Vec::new());
    let mut vectors = TokenStream::new();
    for &array in arrays {
        match printer.procedure.arrays[array].role {
            ArrayRole::Argument(Argument::Input(input)) => {
                let (before, checked) = cx.checked_input(input);
                taken.extend(before);
                match checked {
                    Some(TestedValues::Scalars(values)) => scalars.extend(values),
                    Some(TestedValues::Slice(slice)) => slices.push(slice),
                    None => {}
                }
            }
            ArrayRole::Argument(Argument::Coordinates) => {
                vectors.extend(
                    quote!(#mstmm::generated::check_finite_slice::<Self, T>(state_.q.as_slice(), state_, inputs_)?;),
                );
            }
            ArrayRole::Argument(Argument::Rates) => {
                vectors.extend(
                    quote!(#mstmm::generated::check_finite_slice::<Self, T>(state_.v.as_slice(), state_, inputs_)?;),
                );
            }
            // Unit vectors are finite.
            ArrayRole::Argument(argument) if printer.varying.is_factor(argument) => {}
            ArrayRole::Argument(Argument::Given(given)) => {
                let (name, vector) = super::arguments::given(given);
                vectors.extend(
                    quote!(#mstmm::generated::check_argument::<T>(#name, #vector.as_slice())?;),
                );
            }
            _ => bug!("only inputs, coordinates, rates and given vectors are tested first"),
        }
    }
    if !scalars.is_empty() {
        slices.insert(0, quote!(&[#(#scalars),*]));
    }
    if !slices.is_empty() {
        taken.extend(
            quote!(#mstmm::generated::check_finite::<Self, T>(&[#(#slices),*], state_, inputs_)?;),
        );
    }
    taken.extend(vectors);
    with_reset(printer.on_failure.as_ref(), taken)
}

/// Returns statements that may fail, so that the results are reset after a failure if `reset` is given.
pub fn with_reset(reset: Option<&TokenStream>, statements: TokenStream) -> TokenStream {
    let Some(reset) = reset.filter(|_| !statements.is_empty()) else { return statements };
    quote! {
        let checked_ = (|| {
            #statements
            ::core::result::Result::Ok(())
        })();
        if let ::core::result::Result::Err(error_) = checked_ {
            #reset
            return ::core::result::Result::Err(error_);
        }
    }
}

/// Prints the test whether values are below their bounds.
pub fn bounds(printer: &Printer, bounds: &[ValueBound]) -> TokenStream {
    let mstmm = &printer.cx.mstmm;
    let tests = bounds.iter().map(|bound| {
        let values = bound.values.iter().map(|value| printer.operand(value));
        let square = Literal::f64_unsuffixed(bound.square);
        quote!(#mstmm::generated::are_below::<T, _>([#(#values),*], #square))
    });
    let is_bounded = helper("is_bounded");
    quote!(let #is_bounded = #(#tests)&*;)
}

/// Prints the check of the results.
pub fn results(printer: &Printer, check: &ResultCheck) -> TokenStream {
    let mstmm = &printer.cx.mstmm;
    let TestedPivots { names, values, scales, repeated } = TestedPivots::of(printer, check);
    let TestedResults { numbers, arrays } = TestedResults::of(printer, check);
    let [values, scales] = [values, scales].map(|numbers| quote!([#(#numbers),*]));
    let pivot_error =
        quote!(pivot_error::<Self, _>(&[#(#names),*], #values, #scales, state_, inputs_));
    let error = given(printer).fold(quote!(#mstmm::generated::#pivot_error), |error, (name, vector)| {
        quote!(#mstmm::generated::or_argument::<T>(#error, #name, #vector.as_slice()))
    });
    let fail = match &printer.on_failure {
        None => quote!(return ::core::result::Result::Err(#error);),
        Some(reset) => quote! {
            let error_ = #error;
            #reset
            return ::core::result::Result::Err(error_);
        },
    };
    let reset = printer.on_failure.as_ref();
    let (repeated, arrays) = (with_reset(reset, repeated), with_reset(reset, arrays));
    quote! {
        #repeated
        if !#mstmm::generated::pivots_ok::<T, _, _>(#values, #scales, [#(#numbers),*]) {
            #fail
        }
        #arrays
    }
}

/// The pivots that are tested.
struct TestedPivots<'a> {
    /// The hinges outside of repeated parts.
    names: Vec<&'a String>,
    /// Their pivots.
    values: Vec<TokenStream>,
    /// The magnitudes that the pivots are compared with.
    scales: Vec<TokenStream>,
    /// The statements that test the flags of the pivots in repeated parts.
    repeated: TokenStream,
}

impl<'a> TestedPivots<'a> {
    /// Prints the pivots of a check.
    fn of(printer: &Printer, check: &'a ResultCheck) -> Self {
        let mstmm = &printer.cx.mstmm;
        let (mut names, mut values, mut scales) = (Vec::new(), Vec::new(), Vec::new());
        let mut repeated = TokenStream::new();
        for PivotTest { hinge, pivot } in &check.pivots {
            match pivot {
                PivotValue::Once(value, scale) => {
                    names.push(hinge);
                    values.push(printer.operand(value));
                    scales.push(printer.operand(scale));
                }
                PivotValue::Repeated(check) => {
                    let flag = flag(*check);
                    repeated.extend(quote!(#mstmm::generated::check_pivot(#flag, #hinge)?;));
                }
            }
        }
        TestedPivots { names, values, scales, repeated }
    }
}

/// The values that must be finite.
struct TestedResults {
    /// Those that are tested with the pivots.
    numbers: Vec<TokenStream>,
    /// The statements that test the others.
    arrays: TokenStream,
}

impl TestedResults {
    /// Prints the values of a check that must be finite.
    fn of(printer: &Printer, check: &ResultCheck) -> Self {
        let mstmm = &printer.cx.mstmm;
        let (mut numbers, mut columns, mut arrays) = (Vec::new(), Vec::new(), TokenStream::new());
        let or_given: TokenStream = given(printer)
            .map(|(name, vector)| {
                let or_argument = quote!(or_argument::<T>(error_, #name, #vector.as_slice()));
                quote!(.map_err(|error_| #mstmm::generated::#or_argument))
            })
            .collect();
        // A long array is not passed by value.
        let of_array = |array: &ArrayId, check: TokenStream| {
            let (result, scalar) = (printer.stored_result(*array), printer.scalar(*array));
            quote!(#mstmm::generated::#check::<Self, #scalar>(#result.as_slice(), state_, inputs_) #or_given?;)
        };
        for witness in &check.finite {
            match witness {
                Witness::Value(value) if printer.varying.operand(value) => {
                    columns.push(printer.operand(value));
                }
                Witness::Value(value) => numbers.push(printer.operand(value)),
                Witness::Entry(array, entry) => numbers.push(self::entry(printer, *array, *entry)),
                Witness::Array(array) => {
                    arrays.extend(of_array(array, quote!(check_finite_slice)));
                }
            }
        }
        if !columns.is_empty() {
            let check = quote!(check_finite::<Self, C>(&[&[#(#columns),*]], state_, inputs_));
            arrays.extend(quote!(#mstmm::generated::#check #or_given?;));
        }
        if !check.unless_bounded.is_empty() {
            let is_bounded = helper("is_bounded");
            let stored = check.unless_bounded.iter();
            let results = stored.map(|array| of_array(array, quote!(check_stored)));
            arrays.extend(quote!(if !#is_bounded { #(#results)* }));
        }
        TestedResults { numbers, arrays }
    }
}

/// Returns the vectors that the caller gives, each with its name. Unit vectors are finite.
fn given(printer: &Printer) -> impl Iterator<Item = (&'static str, TokenStream)> {
    printer.procedure.arrays.iter().filter_map(|array| match array.role {
        ArrayRole::Argument(argument) if printer.varying.is_factor(argument) => None,
        ArrayRole::Argument(Argument::Given(given)) => Some(super::arguments::given(given)),
        _ => None,
    })
}

/// Returns an entry of an argument, outside of repeated parts.
fn entry(printer: &Printer, array: ArrayId, entry: usize) -> TokenStream {
    let index = usize_literal(entry);
    match printer.procedure.arrays[array].role {
        ArrayRole::Argument(Argument::Time) => quote!(state_.t),
        ArrayRole::Argument(Argument::Coordinates) => quote!(state_.q.data.0[0][#index]),
        ArrayRole::Argument(Argument::Rates) => quote!(state_.v.data.0[0][#index]),
        _ => bug!("only entries of time, coordinates and rates are tested"),
    }
}

/// The values of an input that are tested.
enum TestedValues {
    Scalars(Vec<TokenStream>),
    Slice(TokenStream),
}

impl EmitContext<'_> {
    /// Returns statements, and the values of an input that are tested after them. There are none for an input of a repeated
    /// part, which the statements test themselves.
    fn checked_input(&self, number: InputId) -> (TokenStream, Option<TestedValues>) {
        let mstmm = &self.mstmm;
        let input = &self.layout.inputs[number];
        let name = self.chain.name_of_input(input.what);
        let checked = |from: &TokenStream| match input.what {
            InputKind::Motion(_) => {
                let variables = self.input_variables(number);
                let taken = self.read_input(number, from, &variables);
                let variables = variables.iter().map(ToTokens::to_token_stream);
                (taken, TestedValues::Scalars(variables.collect()))
            }
            _ if input.range.len() == 1 => {
                (TokenStream::new(), TestedValues::Scalars(vec![from.clone()]))
            }
            _ => (TokenStream::new(), TestedValues::Slice(quote!(#from.as_slice()))),
        };
        if self.chain.repeat_of_input(input.what).is_none() {
            let (taken, checked) = checked(&quote!(inputs_.#name));
            return (taken, Some(checked));
        }
        let (taken, checked) = checked(&quote!(item_));
        let slice = match checked {
            TestedValues::Scalars(values) => quote!(&[#(#values),*]),
            TestedValues::Slice(slice) => slice,
        };
        let each = quote! {
            for &item_ in &inputs_.#name {
                #taken
                #mstmm::generated::check_finite::<Self, T>(&[#slice], state_, inputs_)?;
            }
        };
        (each, None)
    }
}
