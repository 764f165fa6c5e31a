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

/// Zips several loop inputs into one.
pub fn zipped(inputs: Vec<LoopInput>, times: &Literal, inward: bool) -> LoopInput {
    let mut inputs = inputs.into_iter();
    let (mut pattern, mut iterator) = inputs.next().unwrap_or((quote!(_), quote!((0..#times))));
    for (next_pattern, next_iterator) in inputs {
        pattern = quote!((#pattern, #next_pattern));
        iterator = quote!(::core::iter::zip(#iterator, #next_iterator));
    }
    if inward {
        iterator = quote!(::core::iter::Iterator::rev(#iterator));
    }
    (pattern, iterator)
}
