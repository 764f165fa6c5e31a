//! What is left of a route behind an error, and words that are close to those of the language: read for
//! the names in it.

use proc_macro2::{Delimiter, Span};

use super::cursor::Cursor;
use super::tree::{RepeatSyntax, RouteItemSyntax, RouteSyntax};
use super::{lookahead, number, route_item};
use crate::diag::{Diagnostics, nearest};

/// Reads what is left of a route behind an error, for the names in it: nothing more is reported.
pub(super) fn rest(input: &mut Cursor, read: &mut RouteSyntax) {
    read.complete = false;
    let mut inside = *input;
    input.skip_statement();
    while !inside.is_empty() && inside.punct(';').is_none() && !lookahead::begins_block(&inside) {
        match repeated(&mut inside) {
            Some((at, count, mut part)) => {
                let start = read.items.len();
                while !part.is_empty() {
                    after_error(&mut part, read);
                }
                if read.items.len() > start {
                    read.repeats.push(RepeatSyntax { at, count, items: start..read.items.len() });
                }
            }
            None => after_error(&mut inside, read),
        }
    }
}

/// A repeated part, whatever is in the place of its count and of its braces.
fn repeated<'a>(input: &mut Cursor<'a>) -> Option<(Span, Option<usize>, Cursor<'a>)> {
    let mut ahead = *input;
    let at = ahead.word("repeat")?;
    let mut number = ahead;
    let count = number::count("", &mut number).ok().and_then(Result::ok);
    while !ahead.is_empty() && !ahead.peek_punct(';') && !ahead.peek_pair('-', '>') {
        let is_part = [Delimiter::Brace, Delimiter::Parenthesis, Delimiter::Bracket];
        if let Some((part, _)) = is_part.into_iter().find_map(|group| ahead.group(group)) {
            *input = ahead;
            return Some((at, count, part));
        }
        ahead.any();
    }
    None
}

/// A stop behind an error, or a token that begins none.
pub(super) fn after_error(input: &mut Cursor, read: &mut RouteSyntax) {
    let mut ahead = *input;
    match route_item::route_item(&mut ahead, &mut Diagnostics::default()) {
        Ok(mut item) => {
            if let RouteItemSyntax::Element { after_error, .. } = &mut item {
                *after_error = true;
            }
            read.items.push(item);
            *input = ahead;
        }
        Err(_) => _ = input.any(),
    }
}

/// A word that is close to `repeat` with a count and braces behind it, which is reported.
pub(super) fn misspelt_repeat(input: &mut Cursor, diagnostics: &mut Diagnostics) -> Option<Span> {
    let mut ahead = *input;
    let word = ahead.ident()?;
    nearest(&word.to_string(), ["repeat"])?;
    let mut behind = ahead;
    behind.literal()?;
    behind.group(Delimiter::Brace)?;
    diagnostics.error(word.span(), format!("unknown route item `{word}`; did you mean `repeat`?"));
    *input = ahead;
    Some(word.span())
}
