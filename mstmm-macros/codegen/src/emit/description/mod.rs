//! The description of a chain at run time: the implementation of `Described`.

mod answers;
mod elements;
mod geometry;
mod inertia;
mod quantities;
mod results;
mod row;
mod shapes;
mod values;

pub use answers::frames;
pub use elements::point_names;
pub use quantities::{InputRow, QuantityKind, input_rows};
pub use row::{described_hinges, indexed};

use super::EmitContext;
use super::arrays::usize_literal;
use super::docs;
use crate::model::{Input, Parameter};
use proc_macro2::TokenStream;
use quote::quote;
use row::{runs, table};

/// Returns the implementations of `Described` and of the formats of states, inputs and parameters.
pub fn emit(cx: &EmitContext) -> TokenStream {
    let (mstmm, name) = (&cx.mstmm, &cx.names.chain);
    let chain = name.to_string();
    let text = docs::written(&cx.passthrough.attributes).join("\n");
    let dimensions = usize_literal(cx.chain.dimension.translations().len());
    let (kinds, hinges) = elements::hinges(cx);
    let (inertias, bodies) = inertia::bodies(cx);
    let tables = [
        ("hinged", hinges),
        ("bodied", bodies),
        ("sprung", geometry::springs(cx)),
        ("connected", elements::points(cx)),
        ("driven", quantities::inputs(cx)),
        ("changed", quantities::parameters(cx)),
    ];
    let repeated = (!cx.chain.repeats.is_empty()).then(|| {
        let runs = tables.iter().map(|(_, rows)| runs(rows));
        quote!(.repeated([#(&[#runs]),*]))
    });
    let tables = tables.iter().map(|(method, rows)| table(method, rows));
    let answers = elements::answers(cx);
    let by_name = answers::emit(cx);
    let change = inertia::changes(cx);
    let moved = geometry::changes(cx);
    let results = results::emit(cx);
    let (rows, formats) = (values::parameter_rows(cx), formats(cx));
    let [copy, parameters] = [values::inputs(cx), values::parameters(cx)];
    quote! {
        #[allow(clippy::all)]
        impl<T: #mstmm::Scalar> #mstmm::Described for #name<T> {
            const DESCRIPTION: &'static #mstmm::Description = &{
                use #mstmm::generated::description::*;
                #kinds
                #inertias
                describe_(#chain, #text, #dimensions) #(#tables)* #repeated #answers
            };
            #results
            #change
            #moved
            #copy
            #parameters
        }
        #by_name
        #rows
        #formats
    }
}

/// Returns the call of the macro that implements the formats of the features that are on.
fn formats(cx: &EmitContext) -> TokenStream {
    let mstmm = &cx.mstmm;
    let (chain, state) = (&cx.names.chain, &cx.names.state);
    let (inputs, parameters) = (&cx.names.inputs, &cx.names.parameters);
    let of_parameter = |parameter: &Parameter| parameter.repetitions.unwrap_or(1);
    let of_input = |input: &Input| {
        let repeat = cx.chain.repeat_of_input(input.what);
        input.range.len() * repeat.map_or(1, |repeat| cx.chain.repeats[repeat].count)
    };
    let counts = [
        cx.coordinates().total + cx.rates().total + 1,
        cx.layout.inputs.iter().map(of_input).sum(),
        cx.chain.parameters.iter().map(of_parameter).sum(),
    ];
    let [of_state, of_inputs, of_parameters] = counts.map(usize_literal);
    quote! {
        #mstmm::formats_of_chain_! {
            #chain #state #of_state #inputs #of_inputs #parameters #of_parameters
        }
    }
}
