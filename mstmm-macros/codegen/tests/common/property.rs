//! What holds of the compiler on any text; the fuzz target asks for the same.

use mstmm_codegen::Expansion;
use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};
use quote::quote;

/// Expands the text if it is one of Rust's tokens, without a panic, which a `mstmm bug` is too: into code that
/// parses and, where there are mistakes, messages with words. Returns whether it was right, or nothing where it
/// has no tokens.
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

/// What stands in `invisible(…)`, as a group without brackets: so a `macro_rules!` passes on what it
/// took as one expression, which no text can say.
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
