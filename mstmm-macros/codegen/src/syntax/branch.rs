//! Branches of a route. The language has none; they are parsed so that the message can suggest what
//! to write instead, and so that the names in them are known.

use proc_macro2::{Delimiter, Ident};
use syn::Result;

use super::cursor::Cursor;
use super::lookahead::has_arrow;
use super::route_item::route_item;
use super::separators::{BRANCHES, Separators};
use super::tree::{RouteSyntax, SpanRange};
use crate::diag::Diagnostics;

/// Words with which users may begin an item for a branch or for a loop, each with its message.
const ITEMS: &[(&str, &str)] = &[
    ("branch", BRANCHES),
    ("fork", BRANCHES),
    ("tree", BRANCHES),
    ("close", LOOPS),
    ("closure", LOOPS),
    ("constraint", LOOPS),
    ("loop", LOOPS),
];

/// The message for a loop between two bodies.
const LOOPS: &str = "a closed chain is a route that ends as it began, `ground -> … -> ground at \
                     […]`; for a loop between two bodies write two loads with `force = input`";

/// Returns the message for an item that begins with `word`.
pub(super) fn item(word: &Ident) -> Option<&'static str> {
    ITEMS.iter().find(|(known, _)| word == known).map(|&(_, message)| message)
}

/// Reads a group that contains route items: one branch or several.
pub(super) fn group<'a>(input: &mut Cursor<'a>) -> Option<(Cursor<'a>, SpanRange)> {
    let groups = [Delimiter::Brace, Delimiter::Bracket, Delimiter::Parenthesis];
    let mut ahead = *input;
    let (inside, extent) = groups.into_iter().find_map(|delimiter| ahead.group(delimiter))?;
    if !has_arrow(inside) {
        return None;
    }
    *input = ahead;
    Some((inside, extent))
}

/// Reports branches and reads the route items in them.
pub(super) fn branches(
    (mut inside, extent): (Cursor, SpanRange),
    route: &mut RouteSyntax,
    diagnostics: &mut Diagnostics,
) -> Result<()> {
    diagnostics.error(extent.first, BRANCHES);
    route.complete = false;
    let mut separators = Separators::reported();
    while !inside.is_empty() {
        route.items.push(route_item(&mut inside, diagnostics)?);
        let joined = inside.punct(';').is_some() || separators.read(&mut inside, diagnostics);
        if !joined {
            inside.check_empty("`->` or `,`")?;
        }
    }
    Ok(())
}
