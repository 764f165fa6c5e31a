//! Attributes, doc comments and the visibility before an item.

use proc_macro2::{Delimiter, TokenStream};
use syn::parse::Parser;
use syn::{Attribute, Error, Result, Visibility};

use super::cursor::Cursor;
use super::lookahead;

/// Doc comments and attributes.
fn attributes(input: &mut Cursor) -> Result<Vec<Attribute>> {
    let mut tokens = TokenStream::new();
    while input.peek_punct('#') {
        let at = input.next_span();
        tokens.extend(input.any());
        if !input.peek_group(Delimiter::Bracket) {
            return Err(Error::new(at, "a comment begins with `//`"));
        }
        tokens.extend(input.any());
    }
    Attribute::parse_outer.parse2(tokens)
}

/// Reads doc comments; any other attribute is an error.
pub(super) fn docs(input: &mut Cursor) -> Result<Vec<Attribute>> {
    let attributes = attributes(input).inspect_err(|_| skip_comment(input))?;
    match attributes.iter().find(|attribute| !attribute.path().is_ident("doc")) {
        Some(other) => Err(Error::new_spanned(other, "only doc comments are allowed here")),
        None => Ok(attributes),
    }
}

/// Skips to what may be the end of a comment that begins with `#`.
fn skip_comment(input: &mut Cursor) {
    while !input.is_empty() && !lookahead::begins_item(input) && !lookahead::begins_field(input) {
        if input.punct(';').is_some() {
            return;
        }
        input.any();
    }
}

/// Reads the attributes before a chain. `cfg` is an error there: a chain expands to several items,
/// and the condition would apply to the first one only.
pub(super) fn of_chain(input: &mut Cursor) -> Result<Vec<Attribute>> {
    let attributes = attributes(input)?;
    let conditional = |attribute: &&Attribute| {
        attribute.path().is_ident("cfg") || attribute.path().is_ident("cfg_attr")
    };
    match attributes.iter().find(conditional) {
        Some(cfg) => {
            let message = "write the `cfg` before `mstmm_chain!`, not inside";
            Err(Error::new_spanned(cfg, message))
        }
        None => Ok(attributes),
    }
}

/// `pub`, `pub(crate)` or nothing.
pub(super) fn visibility(input: &mut Cursor) -> Result<Visibility> {
    let mut tokens = TokenStream::new();
    if input.peek_ident().is_some_and(|word| word == "pub") {
        tokens.extend(input.any());
        if input.peek_group(Delimiter::Parenthesis) {
            tokens.extend(input.any());
        }
    }
    syn::parse2(tokens)
}
