//! The property of the compiler that must hold for every text; the fuzz target tests the same.

use mstmm_codegen::Expansion;
use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};
use quote::quote;

/// Expands a text. The expansion must not panic, the code must parse, and every error must have a message. Returns whether the
/// text is valid; none if it cannot be split into Rust tokens.
pub fn check(text: &str) -> Option<bool> {
    let tokens = without_brackets(text.parse().ok()?);
    let Expansion { items, errors, .. } = mstmm_codegen::expand(tokens, &quote!(::mstmm));
    let parsed = syn::parse2::<syn::File>(items);
    let file = parsed.unwrap_or_else(|error| panic!("the code does not parse: {error}"));
    let Some(errors) = errors else {
        assert!(!file.items.is_empty(), "neither code nor errors");
        return Some(true);
    };
    let messages: Vec<String> = errors.into_iter().map(|error| error.to_string()).collect();
    assert!(!messages.is_empty(), "errors without a message");
    assert!(messages.iter().all(|message| !message.trim().is_empty()), "{messages:?}");
    Some(false)
}

/// Replaces `invisible(…)` by a group without brackets. A `macro_rules!` passes an expression as such a group, which no text
/// can contain.
fn without_brackets(tokens: TokenStream) -> TokenStream {
    let mut all: Vec<TokenTree> = Vec::new();
    for token in tokens {
        let TokenTree::Group(group) = token else {
            all.push(token);
            continue;
        };
        let mut delimiter = group.delimiter();
        let is_word = |token: &mut TokenTree| token.to_string() == "invisible";
        if delimiter == Delimiter::Parenthesis && all.pop_if(is_word).is_some() {
            delimiter = Delimiter::None;
        }
        all.push(Group::new(delimiter, without_brackets(group.stream())).into());
    }
    all.into_iter().collect()
}
