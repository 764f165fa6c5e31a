//! The type of variations: directions in which the arguments of forward dynamics change, and gradients with
//! respect to them.

use super::EmitContext;
use super::arrays::usize_literal;
use crate::compile::layouts;
use crate::ids::InputId;
use crate::model::{Answer, InputKind};
use proc_macro2::TokenStream;
use quote::quote;

/// Returns `struct ChainVariation<T>`, if a requested function needs it.
pub fn emit(cx: &EmitContext) -> TokenStream {
    let answers = [Answer::Push, Answer::Pull, Answer::EffortsChange];
    if answers.into_iter().all(|answer| cx.compiled.find(answer).is_none()) {
        return TokenStream::new();
    }
    let mstmm = &cx.mstmm;
    let (name, chain) = (&cx.names.variation, &cx.names.chain);
    let visibility = &cx.passthrough.visibility;
    let rates = usize_literal(cx.rates().total);
    let inputs = usize_literal(layouts::inputs(cx.chain, cx.layout).total);
    let parameters = usize_literal(layouts::parameters(cx.chain).total);
    let doc = format!(
        " A small change of all that the accelerations of [`{chain}`] depend on, in SI units, or a gradient with respect to it."
    );
    let (of_inputs, of_parameters) = (input_entries(cx), parameter_entries(cx));
    quote! {
        #[doc = #doc]
        #[derive(Clone, Copy, Debug, PartialEq)]
        #[allow(dead_code, non_snake_case)]
        #visibility struct #name<T> {
            /// Along the coordinates: the small displacement `δ` along the rates, in the order of `v`: `dq = N(q) δ` with
            /// the `N(q)` of `q̇ = N(q) v`.
            #visibility coordinates: #mstmm::nalgebra::SVector<T, #rates>,
            /// Along the rates `v`.
            #visibility rates: #mstmm::nalgebra::SVector<T, #rates>,
            #(#[doc = #of_inputs])*
            #visibility inputs: #mstmm::nalgebra::SVector<T, #inputs>,
            #(#[doc = #of_parameters])*
            #visibility parameters: #mstmm::nalgebra::SVector<T, #parameters>,
        }
        impl<T: #mstmm::Scalar> ::core::default::Default for #name<T> {
            #[inline]
            fn default() -> Self {
                Self {
                    coordinates: #mstmm::generated::vector([T::constant(0.0); #rates]),
                    rates: #mstmm::generated::vector([T::constant(0.0); #rates]),
                    inputs: #mstmm::generated::vector([T::constant(0.0); #inputs]),
                    parameters: #mstmm::generated::vector([T::constant(0.0); #parameters]),
                }
            }
        }
    }
}

/// Returns the docs of the entries along the inputs.
pub fn input_entries(cx: &EmitContext) -> Vec<String> {
    let layout = layouts::inputs(cx.chain, cx.layout);
    let inputs: Vec<(String, usize)> =
        cx.layout.inputs.enumerate().map(|it| entries_of(cx, it)).collect();
    documented(" Along the inputs", &inputs, &layout)
}

/// Returns the docs of the entries along the parameters.
pub fn parameter_entries(cx: &EmitContext) -> Vec<String> {
    let parameters = cx.chain.parameters.iter();
    let parameters: Vec<(String, usize)> =
        parameters.map(|parameter| (format!("`{}`", parameter.name), 1)).collect();
    documented(" Along the parameters", &parameters, &layouts::parameters(cx.chain))
}

/// Returns the name of an input with its entries in words, and their number.
fn entries_of(cx: &EmitContext, (id, input): (InputId, &crate::model::Input)) -> (String, usize) {
    let name = cx.chain.name_of_input(input.what);
    let count = cx.layout.inputs[id].range.len();
    let what = match input.what {
        InputKind::Motion(_) => format!("`{name}`: position, rate, acceleration"),
        _ => format!("`{name}`"),
    };
    (what, count)
}

/// Returns one line for each item with the indices of its entries.
pub fn documented(
    head: &str,
    items: &[(String, usize)],
    layout: &crate::program::ArrayLayout,
) -> Vec<String> {
    if items.is_empty() {
        return vec![format!("{head}: none.")];
    }
    let mut lines = vec![format!("{head}:"), " ".to_owned()];
    let mut first = 0;
    for (name, count) in items.iter().filter(|(_, count)| *count > 0) {
        let segment = layout.segment_of(first);
        let start = segment.offset + first - segment.first;
        let range = match count {
            1 => format!("{start}"),
            _ => format!("{start} to {}", start + count - 1),
        };
        lines.push(match segment.repeat {
            None => format!(" - {range}: {name}"),
            Some(_) => format!(
                " - {range}: {name} of the first repetition; each further one is {} later",
                segment.count
            ),
        });
        first += count;
    }
    lines
}
