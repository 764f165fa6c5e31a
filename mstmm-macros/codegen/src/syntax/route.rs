//! The route: route items joined by arrows.

use proc_macro2::{Delimiter, Span};
use syn::{Error, Result};

use super::cursor::Cursor;
use super::number::count;
use super::recover::{self, after_error};
use super::route_item::route_item;
use super::separators::Separators;
use super::tree::{RepeatSyntax, RouteItemSyntax, RouteSyntax};
use super::{branch, lookahead};
use crate::diag::Diagnostics;

/// Parses a route including its `;`. After an error it continues with the next statement.
pub(super) fn route(input: &mut Cursor, diagnostics: &mut Diagnostics) -> RouteSyntax {
    let mut route =
        RouteSyntax { items: Vec::new(), repeats: Vec::new(), complete: true, further: Vec::new() };
    let mut separators = Separators::default();
    loop {
        let before = *input;
        let word = input.word("repeat").or_else(|| recover::misspelt_repeat(input, diagnostics));
        let read = if let Some(at) = word {
            repeat(at, input, &mut route, &mut separators, diagnostics)
        } else if let Some(group) = branch::group(input) {
            branch::branches(group, &mut route, diagnostics)
        } else {
            route_item(input, diagnostics).map(|item| route.items.push(item))
        };
        if let Err(error) = read {
            diagnostics.push(error);
            // The unexpected token may be the `;`.
            *input = before;
            recover::rest(input, &mut route);
            return route;
        }
        if input.punct(';').is_some() {
            return route;
        }
        if lookahead::begins_item(input) || input.is_empty() {
            diagnostics.error(input.last().first, "expected `;` after this");
            return route;
        }
        let joined = separators.read(input, diagnostics);
        route.complete &= !separators.branches;
        if !joined {
            diagnostics.push(input.unexpected("`->` or `;`"));
            // The error may be the last item or the token after it.
            if let Some(RouteItemSyntax::Element { after_error, .. }) = route.items.last_mut() {
                *after_error = true;
            }
            recover::rest(input, &mut route);
            return route;
        }
    }
}

/// Parses the rest of a repeated part after `repeat`. Errors in its count or in its items are
/// reported, and the route continues after it.
fn repeat(
    at: Span,
    input: &mut Cursor,
    route: &mut RouteSyntax,
    separators: &mut Separators,
    diagnostics: &mut Diagnostics,
) -> Result<()> {
    let count = count("a repeat count", input)?;
    let (inside, braces) = input.group(Delimiter::Brace).ok_or_else(|| input.unexpected("`{`"))?;
    let start = route.items.len();
    let read = if inside.is_empty() {
        let message = format!("this `repeat` is empty: {}", RepeatSyntax::EXAMPLE);
        Err(Error::new_spanned(braces, message))
    } else {
        contents(inside, route, separators, diagnostics)
    };
    match (count, read) {
        (Ok(count), Ok(())) => {
            route.repeats.push(RepeatSyntax {
                at,
                count: Some(count),
                items: start..route.items.len(),
            });
        }
        (count, read) => {
            let times = count.as_ref().ok().copied();
            for error in [count.err(), read.err()].into_iter().flatten() {
                diagnostics.push(error);
            }
            route.complete = false;
            let items = start..route.items.len();
            if !items.is_empty() {
                route.repeats.push(RepeatSyntax { at, count: times, items });
            }
        }
    }
    Ok(())
}

/// Parses the items in the braces of a `repeat`.
fn contents(
    mut inside: Cursor,
    route: &mut RouteSyntax,
    separators: &mut Separators,
    diagnostics: &mut Diagnostics,
) -> Result<()> {
    loop {
        if let Some(at) = inside.word("repeat") {
            return Err(Error::new(at, "`repeat` blocks cannot be nested"));
        }
        route.items.push(route_item(&mut inside, diagnostics)?);
        if inside.is_empty() {
            return Ok(());
        }
        if !separators.read(&mut inside, diagnostics) {
            let error = inside.unexpected("`->` or `}`");
            while !inside.is_empty() {
                after_error(&mut inside, route);
            }
            return Err(error);
        }
    }
}
