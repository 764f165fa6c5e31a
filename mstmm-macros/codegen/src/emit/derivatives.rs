//! The types of derivatives: names for types of the runtime, with the sizes of the chain.

use super::EmitContext;
use super::arrays::usize_literal;
use super::variation::{input_entries, parameter_entries};
use crate::compile::layouts;
use crate::model::Request;
use proc_macro2::TokenStream;
use quote::quote;

/// Returns `ChainInverseDynamicsDerivatives<T>` and `ChainLinearization<T>`, if they are requested.
pub fn emit(cx: &EmitContext) -> TokenStream {
    let (mstmm, chain) = (&cx.mstmm, &cx.names.chain);
    let visibility = &cx.passthrough.visibility;
    let count = cx.rates().total;
    let (rates, twice) = (usize_literal(count), usize_literal(2 * count));
    let mut types = TokenStream::new();
    if cx.chain.requests.contains(&Request::Derivatives) {
        let name = &cx.names.derivatives;
        let doc = format!(" The derivatives of the inverse dynamics of [`{chain}`].");
        types.extend(quote! {
            #[doc = #doc]
            #[allow(dead_code)]
            #visibility type #name<T = ::core::primitive::f64> = #mstmm::InverseDynamicsDerivatives<T, #rates>;
        });
    }
    if cx.chain.requests.contains(&Request::Linearize) {
        let name = &cx.names.linearization;
        let doc = format!(" The accelerations of [`{chain}`] and their derivatives.");
        let inputs = usize_literal(layouts::inputs(cx.chain, cx.layout).total);
        let parameters = usize_literal(layouts::parameters(cx.chain).total);
        let (of_inputs, of_parameters) = (input_entries(cx), parameter_entries(cx));
        types.extend(quote! {
            #[doc = #doc]
            ///
            /// The columns of `by_inputs` and `by_parameters`:
            ///
            #(#[doc = #of_inputs])*
            ///
            #(#[doc = #of_parameters])*
            #[allow(dead_code)]
            #visibility type #name<T = ::core::primitive::f64> =
                #mstmm::Linearization<T, #rates, #twice, #inputs, #parameters>;
        });
    }
    types
}
