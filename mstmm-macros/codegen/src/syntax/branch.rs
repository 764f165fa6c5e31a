//! What is written where a route branches or names a place on a body. The language has neither: it is
//! read so that the message names the way round, and so that the names in it are known.

use proc_macro2::{Delimiter, Ident, Span};
use syn::Result;

use super::cursor::Cursor;
use super::route::{self, Joints};
use super::tree::{Extent, Route};
use super::{field, unit};
use crate::diag::Diagnostics;

/// What is said where a route branches.
pub(super) const BRANCHES: &str = "a chain has no branches: write a branch as a separate chain, \
                                   and couple the two by a `load` with `force = input` in each";

/// Words that an item for a branch or for a loop may begin with, and what is said of it.
const ITEMS: &[(&str, &str)] = &[
    ("branch", BRANCHES),
    ("fork", BRANCHES),
    ("tree", BRANCHES),
    ("close", LOOPS),
    ("closure", LOOPS),
    ("constraint", LOOPS),
    ("loop", LOOPS),
];

/// What is said where a loop is to close otherwise than the language can.
const LOOPS: &str = "a chain closes by a route that ends as it began, `ground -> … -> ground at \
                     […]`: a loop over a body is held by two loads with `force = input`";

/// What is said of an item that begins with this word.
pub(super) fn item(word: &Ident) -> Option<&'static str> {
    ITEMS.iter().find(|(known, _)| word == known).map(|&(_, message)| message)
}

/// A place on what was just named: `.lug`, `at lug` or `at [x, y, z]`. Where it begins.
pub(super) fn place(input: &mut Cursor) -> Option<Span> {
    let mut ahead = *input;
    let at = if ahead.punct('.').is_some() {
        let at = ahead.next_span();
        ahead.ident()?;
        at
    } else {
        let at = ahead.word("at")?;
        if ahead.ident().is_none() {
            ahead.group(Delimiter::Bracket)?;
            // All of it is wrong, so that nothing is said of its parts.
            let _unit = unit::optional(&mut ahead);
            let _turn = field::turned(&mut ahead);
        }
        at
    };
    *input = ahead;
    Some(at)
}

/// A group in the place of a stop that holds stops: a branch, or several.
pub(super) fn group<'a>(input: &mut Cursor<'a>) -> Option<(Cursor<'a>, Extent)> {
    let groups = [Delimiter::Brace, Delimiter::Bracket, Delimiter::Parenthesis];
    let mut ahead = *input;
    let (inside, extent) = groups.into_iter().find_map(|delimiter| ahead.group(delimiter))?;
    if !route::has_arrow(inside) {
        return None;
    }
    *input = ahead;
    Some((inside, extent))
}

/// Reports branches and reads the stops on them.
pub(super) fn branches(
    (mut inside, extent): (Cursor, Extent),
    route: &mut Route,
    diagnostics: &mut Diagnostics,
) -> Result<()> {
    diagnostics.error(extent.first, BRANCHES);
    route.whole = false;
    let mut joints = Joints::reported();
    while !inside.is_empty() {
        route.stops.push(route::stop(&mut inside, diagnostics)?);
        let joined = inside.punct(';').is_some() || joints.read(&mut inside, diagnostics);
        if !joined {
            inside.check_empty("`->` or `,`")?;
        }
    }
    Ok(())
}
