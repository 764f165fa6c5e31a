//! Lets an editor follow names in a description to their definitions.

use super::EmitContext;
use crate::syntax::{KeywordUses, References};
use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;

/// Returns code without effect that uses names with the spans of the description.
pub fn emit(cx: &EmitContext) -> TokenStream {
    let (mstmm, workspace) = (cx.mstmm, &cx.names.workspace);
    let References { elements, types, uses_of_types, parameters, keywords } =
        &cx.passthrough.references;
    let chain_parameters = &cx.names.parameters;
    let methods = (!elements.is_empty() || !parameters.is_empty()).then(|| {
        quote! {
            const _: () = {
                #[allow(dead_code)]
                fn methods<T: #mstmm::Scalar>() {
                    #(let _ = #workspace::<T>::#elements;)*
                    #(let _ = #chain_parameters::<T>::#parameters;)*
                }
            };
        }
    });
    let keywords = keyword_types(keywords, types, mstmm);
    quote! {
        #methods
        #[allow(dead_code, non_camel_case_types, clippy::all)]
        const _: () = {
            #(struct #types;)*
            #(const _: #uses_of_types = #uses_of_types;)*
            #keywords
        };
    }
}

/// Returns types that contain a type for each use of a keyword: of all forms without warnings this is
/// the cheapest for rustc, 3 µs for each use. No type of the description has their name.
fn keyword_types(uses: &[KeywordUses], types: &[Ident], mstmm: &TokenStream) -> TokenStream {
    let mut name = "Keywords_".to_owned();
    while types.iter().any(|of_body| *of_body == name) {
        name.push('_');
    }
    let name = Ident::new(&name, Span::call_site());
    let words = |uses: &[&KeywordUses]| uses.iter().flat_map(|uses| uses.words.clone()).collect();
    let (unique, others): (Vec<_>, Vec<_>) =
        uses.iter().partition(|uses| uses.group.has_unique_names());
    let unique: Vec<Ident> = words(&unique);
    let unique = (!unique.is_empty()).then(|| {
        quote! {
            use #mstmm::keywords::unique::*;
            type #name = (#(#unique,)*);
        }
    });
    let others = others.iter().map(|KeywordUses { group, words }| {
        let module = Ident::new(group.module(), Span::call_site());
        quote! {
            const _: () = {
                use #mstmm::keywords::#module::*;
                type #name = (#(#words,)*);
            };
        }
    });
    quote! {
        #unique
        #(#others)*
    }
}
