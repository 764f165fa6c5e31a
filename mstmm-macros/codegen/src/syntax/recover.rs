//! Error recovery in a route: the rest of it is read for its names, and misspelt keywords are
//! reported.

use proc_macro2::{Delimiter, Span};

use super::cursor::Cursor;
use super::route_tree::{RepeatSyntax, RouteItemSyntax, RouteSyntax, StepSyntax};
use super::{lookahead, number, route_item};
use crate::diag::{Diagnostics, nearest};

/// Reads the rest of a route after an error for its names, without further messages.
pub(super) fn rest(input: &mut Cursor, read: &mut RouteSyntax) {
    read.complete = false;
    let inside = *input;
    input.skip_statement();
    names(inside, read);
}

/// Reads items after an error for their names, to the end of the route.
pub(super) fn names(mut inside: Cursor, read: &mut RouteSyntax) {
    while !inside.is_empty() && inside.punct(';').is_none() && !lookahead::begins_block(&inside) {
        match repeated(&mut inside) {
            Some((at, count, mut part)) => {
                let mut route = RouteSyntax::at(part.next_span());
                while !part.is_empty() {
                    after_error(&mut part, &mut route);
                }
                if !route.steps.is_empty() {
                    let (seeds, routes) = (Vec::new(), vec![route]);
                    let repeat = RepeatSyntax { at, count, seeds, routes };
                    read.steps.push(StepSyntax::Repeat(repeat));
                }
            }
            None => after_error(&mut inside, read),
        }
    }
}

/// Reads a repeated part, even if its count or its braces are wrong.
fn repeated<'a>(input: &mut Cursor<'a>) -> Option<(Span, Option<usize>, Cursor<'a>)> {
    let mut ahead = *input;
    let at = ahead.word("repeat")?;
    let mut number = ahead;
    let count = number::count("", &mut number).ok().and_then(Result::ok);
    let has_seeds = {
        let mut after_count = number;
        after_count.word("from").is_some()
    };
    while !ahead.is_empty() && !ahead.peek_punct(';') && (has_seeds || !ahead.peek_pair('-', '>')) {
        let is_part = [Delimiter::Brace, Delimiter::Parenthesis, Delimiter::Bracket];
        if let Some((part, _)) = is_part.into_iter().find_map(|group| ahead.group(group)) {
            *input = ahead;
            return Some((at, count, part));
        }
        ahead.any();
    }
    None
}

/// Reads a route item after an error, or skips a token.
pub(super) fn after_error(input: &mut Cursor, read: &mut RouteSyntax) {
    let mut ahead = *input;
    match route_item::route_item(&mut ahead, &mut Diagnostics::default()) {
        Ok(mut item) => {
            if let RouteItemSyntax::Element { after_error, .. } = &mut item {
                *after_error = true;
            }
            read.steps.push(StepSyntax::Item(item));
            *input = ahead;
        }
        Err(_) => _ = input.any(),
    }
}

/// Reads and reports a misspelt `repeat` that a count and braces follow.
pub(super) fn misspelt_repeat(input: &mut Cursor, diagnostics: &mut Diagnostics) -> Option<Span> {
    let mut ahead = *input;
    let word = ahead.ident()?;
    nearest(&word.to_string(), ["repeat"])?;
    let mut after = ahead;
    after.literal()?;
    after.group(Delimiter::Brace)?;
    diagnostics.error(word.span(), format!("unknown route item `{word}`; did you mean `repeat`?"));
    *input = ahead;
    Some(word.span())
}
