//! The results of springs in a workspace.

use super::EmitContext;
use super::names::helper;
use crate::compile::layouts;
use crate::model::Spring;
use crate::program::{ArrayLayout, Segment};
use proc_macro2::TokenStream;
use quote::quote;

/// Returns a method for the results of each spring.
pub fn methods(cx: &EmitContext) -> TokenStream {
    let layout = layouts::springs(cx.chain);
    let springs = cx.chain.springs.iter().enumerate();
    springs.map(|(index, spring)| method(cx, &layout, index, spring)).collect()
}

/// Returns the method for the results of a spring.
fn method(cx: &EmitContext, layout: &ArrayLayout, index: usize, spring: &Spring) -> TokenStream {
    let mstmm = &cx.mstmm;
    let (name, path, visibility) = (&spring.name, &spring.path, &cx.passthrough.visibility);
    let translations = cx.chain.dimension.translations().len();
    let count = 3 + translations;
    let segment = layout.segment_of(index * count);
    let values = values(segment, index * count, count);
    let force = (0..translations).map(|k| helper(&format!("force{k}")));
    let force = match translations {
        1 => quote!(#(#force)*),
        _ => quote!(#mstmm::generated::vector([#(#force),*])),
    };
    let [length, rate, tension] = ["length", "rate", "tension"].map(helper);
    let ty = cx.numbers_type(translations);
    let ty = quote!(#mstmm::SpringResult<T, #ty>);
    let result = quote!(#mstmm::SpringResult::new(#length, #rate, #tension, #force));
    let results = "length, rate of the length, tension and force";
    if segment.repeat.is_none() {
        let doc = format!(" Returns {results} of spring `{path}`.");
        let springs = cx.segment(&quote!(self.springs), segment);
        return quote! {
            #[doc = #doc]
            #[inline]
            #visibility fn #name(&self) -> #ty {
                let [#(#values),*] = #springs;
                #result
            }
        };
    }
    let doc = format!(
        " Returns {results} of spring `{path}` in repetition `index` of {}.",
        segment.repetitions
    );
    let springs = cx.slices(&quote!(self.springs), segment);
    quote! {
        #[doc = #doc]
        #[inline]
        #visibility fn #name(
            &self,
            index_: ::core::primitive::usize,
        ) -> ::core::option::Option<#ty> {
            let &[#(#values),*] = #springs.get(index_)?;
            ::core::option::Option::Some(#result)
        }
    }
}

/// Returns the pattern of a segment's entries, in which the entries of a spring have names.
fn values(segment: &Segment, first: usize, count: usize) -> Vec<TokenStream> {
    let pattern = segment.entries().map(|entry| {
        let name = match entry.checked_sub(first) {
            Some(0) => helper("length"),
            Some(1) => helper("rate"),
            Some(2) => helper("tension"),
            Some(other) if other < count => helper(&format!("force{}", other - 3)),
            _ => return quote!(_),
        };
        quote!(#name)
    });
    pattern.collect()
}
