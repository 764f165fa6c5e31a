//! The inputs of loops: iterators, and the patterns that destructure their items.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

/// A pattern, and the iterator whose items it destructures.
pub type LoopInput = (TokenStream, TokenStream);

/// Returns a pattern of an array's entries.
pub fn pattern(names: &[Option<Ident>]) -> TokenStream {
    let names = names.iter().map(|name| match name {
        Some(name) => quote!(#name),
        None => quote!(_),
    });
    quote!([#(#names),*])
}

/// Zips several loop inputs into one. Inward, each is reversed: the end of zipped iterators is a panic unless the compiler
/// finds that they are equally long.
pub fn zipped(inputs: Vec<LoopInput>, times: &Literal, inward: bool) -> LoopInput {
    let directed = |(pattern, iterator): LoopInput| match inward {
        true => (pattern, quote!(::core::iter::Iterator::rev(#iterator))),
        false => (pattern, iterator),
    };
    let mut inputs = inputs.into_iter().map(directed);
    let first = inputs.next().unwrap_or_else(|| directed((quote!(_), quote!((0..#times)))));
    inputs.fold(first, |(pattern, iterator), (next_pattern, next_iterator)| {
        let pattern = quote!((#pattern, #next_pattern));
        (pattern, quote!(::core::iter::zip(#iterator, #next_iterator)))
    })
}
