//! The description of a chain at run time: the implementation of `Described`.

mod answers;
mod elements;
mod inertia;
mod quantities;
mod results;
mod row;
mod shapes;
mod values;

use super::EmitContext;
use super::arrays::usize_literal;
use super::docs;
use proc_macro2::TokenStream;
use quote::quote;
use row::{runs, table};

/// Returns the implementation of `Described`.
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
        ("sprung", elements::springs(cx)),
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
    let results = results::emit(cx);
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
            #copy
            #parameters
        }
        #by_name
    }
}
