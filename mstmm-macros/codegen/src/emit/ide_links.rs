//! Lets an editor follow names in a description to their definitions.

use super::EmitContext;
use crate::syntax::References;
use proc_macro2::TokenStream;
use quote::quote;

/// Returns code without effect that uses names with the spans of the description.
pub fn emit(cx: &EmitContext) -> TokenStream {
    let (mstmm, workspace) = (cx.mstmm, &cx.names.workspace);
    let References { elements, types, uses_of_types } = &cx.passthrough.references;
    let elements = (!elements.is_empty()).then(|| {
        quote! {
            const _: () = {
                #[allow(dead_code)]
                fn elements<T: #mstmm::Scalar>() {
                    #(let _ = #workspace::<T>::#elements;)*
                }
            };
        }
    });
    quote! {
        #elements
        #[allow(dead_code, non_camel_case_types, clippy::all)]
        const _: () = {
            #(struct #types;)*
            #(const _: #uses_of_types = #uses_of_types;)*
        };
    }
}
