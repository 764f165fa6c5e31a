//! Routes: steps joined by arrows.

use proc_macro2::{Delimiter, Span};
use syn::{Error, Result};

use super::cursor::Cursor;
use super::lookahead::{self, has_arrow};
use super::number::count;
use super::path::{block_head, path_of_several};
use super::recover::{self, after_error};
use super::route_item::route_item;
use super::route_tree::{RepeatSyntax, RouteItemSyntax, RouteSyntax, SeedSyntax, StepSyntax};
use super::separators::{BRANCHES, Separators};
use super::tree::{PathSyntax, SpanRange};
use crate::diag::Diagnostics;

/// Parses a route including its `;`. After an error it continues with the next statement.
pub(super) fn route(input: &mut Cursor, diagnostics: &mut Diagnostics) -> RouteSyntax {
    let mut route = RouteSyntax::at(input.next_span());
    let mut separators = Separators::default();
    match start(input) {
        Ok(start) => route.start = start,
        Err((start, error)) => {
            diagnostics.push(error);
            route.start = Some(start);
            recover::rest(input, &mut route);
            return route;
        }
    }
    loop {
        let before = *input;
        if let Err(error) = step(input, &mut route, &mut separators, diagnostics) {
            diagnostics.push(error);
            // The unexpected token may be the `;`.
            *input = before;
            recover::rest(input, &mut route);
            return route;
        }
        if input.punct(';').is_some() {
            return route;
        }
        if lookahead::is_last_end(input) {
            diagnostics.push(input.unexpected("`->`"));
            continue;
        }
        if lookahead::begins_item(input) || input.is_empty() {
            diagnostics.error(input.last().first, "expected `;` after this");
            return route;
        }
        if !joined(input, &mut route, &mut separators, diagnostics) {
            diagnostics.push(input.unexpected("`->` or `;`"));
            mark_error(&mut route);
            recover::rest(input, &mut route);
            return route;
        }
    }
}

/// Reads a separator.
fn joined(
    input: &mut Cursor,
    route: &mut RouteSyntax,
    separators: &mut Separators,
    diagnostics: &mut Diagnostics,
) -> bool {
    let joined = separators.read(input, diagnostics);
    route.complete &= !separators.branches;
    joined
}

/// Notes that a token beside the last item is wrong: the error may be this item.
fn mark_error(route: &mut RouteSyntax) {
    if let Some(StepSyntax::Item(RouteItemSyntax::Element { after_error, .. })) =
        route.steps.last_mut()
    {
        *after_error = true;
    }
}

/// Parses a step: an item, a repeated part, or items in brackets, which are an error.
fn step(
    input: &mut Cursor,
    route: &mut RouteSyntax,
    separators: &mut Separators,
    diagnostics: &mut Diagnostics,
) -> Result<()> {
    let word = input.word("repeat").or_else(|| recover::misspelt_repeat(input, diagnostics));
    if let Some(at) = word {
        repeat(at, input, route, separators, diagnostics)
    } else if let Some(group) = group_of_items(input) {
        branches(group, route, diagnostics)
    } else {
        let item = route_item(input, diagnostics)?;
        route.steps.push(StepSyntax::Item(item));
        if separators.is_lost {
            mark_error(route);
        }
        Ok(())
    }
}

/// Reads the place at which a route begins, and the arrow after it. The error has the place.
fn start(input: &mut Cursor) -> std::result::Result<Option<PathSyntax>, (PathSyntax, Error)> {
    let Some(path) = path_of_several(input) else { return Ok(None) };
    if input.pair('-', '>').is_none() {
        return Err((path, input.unexpected("`->`")));
    }
    Ok(Some(path))
}

/// Parses the rest of a repeated part after `repeat`. Errors in it are reported, and the route
/// continues after it.
fn repeat(
    at: Span,
    input: &mut Cursor,
    route: &mut RouteSyntax,
    separators: &mut Separators,
    diagnostics: &mut Diagnostics,
) -> Result<()> {
    let count = count("a repeat count", input)?;
    let seeds = seeds(input)?;
    let (inside, braces) = input.group(Delimiter::Brace).ok_or_else(|| input.unexpected("`{`"))?;
    let mut routes = Vec::new();
    if inside.is_empty() {
        let message = format!("this `repeat` is empty: {}", RepeatSyntax::EXAMPLE);
        diagnostics.push(Error::new_spanned(braces, message));
    } else {
        routes = repeated_routes(inside, separators, diagnostics);
    }
    if let Some(place) = routes.first().and_then(|first| first.start.as_ref()) {
        let message = format!(
            "the first route in a `repeat` continues the route around it: remove `{place} ->`, or \
             write a branch after the first route"
        );
        diagnostics.error_over(place.extent(), message);
        route.complete = false;
    }
    let count = count.map_err(|error| {
        diagnostics.push(error);
        route.complete = false;
    });
    let count = count.ok();
    if routes.iter().any(|route| !route.steps.is_empty()) {
        route.steps.push(StepSyntax::Repeat(RepeatSyntax { at, count, seeds, routes }));
    } else {
        // Without it, the route may have no body.
        route.complete = false;
    }
    Ok(())
}

/// `from place = place, …`
fn seeds(input: &mut Cursor) -> Result<Vec<SeedSyntax>> {
    let mut seeds = Vec::new();
    if input.word("from").is_none() {
        return Ok(seeds);
    }
    loop {
        let place = path_of_several(input).ok_or_else(|| input.unexpected("`body.place`"))?;
        input.punct('=').ok_or_else(|| input.unexpected("`=`"))?;
        let first = path_of_several(input).ok_or_else(|| input.unexpected("`body.place`"))?;
        seeds.push(SeedSyntax { place, first });
        if input.punct(',').is_none() {
            return Ok(seeds);
        }
    }
}

/// Parses the routes in the braces of a `repeat`.
fn repeated_routes(
    mut inside: Cursor,
    separators: &mut Separators,
    diagnostics: &mut Diagnostics,
) -> Vec<RouteSyntax> {
    let mut routes = Vec::new();
    while !inside.is_empty() {
        if block(&mut inside, diagnostics) {
            continue;
        }
        let mut route = RouteSyntax::at(inside.next_span());
        if let Err(error) = repeated_route(&mut inside, &mut route, separators, diagnostics) {
            diagnostics.push(error);
            route.complete = false;
            while !inside.is_empty() && inside.punct(';').is_none() {
                after_error(&mut inside, &mut route);
            }
        }
        routes.push(route);
    }
    routes
}

/// Reports a block in a `repeat` and skips it. Returns whether there is one.
fn block(inside: &mut Cursor, diagnostics: &mut Diagnostics) -> bool {
    let mut ahead = *inside;
    let Some(word) = ahead.ident() else { return false };
    let is_item = lookahead::ITEMS.iter().any(|item| word == item);
    if !is_item || block_head(&mut ahead, &mut Diagnostics::default()).is_err() {
        return false;
    }
    let place = if word == "body" { "before the first route" } else { "after the route" };
    let message = format!(
        "a `repeat` contains routes only: write this block {place}; it applies to each repetition"
    );
    diagnostics.error(word.span(), message);
    ahead.punct(';');
    *inside = ahead;
    true
}

/// Parses one of the routes in the braces of a `repeat`.
fn repeated_route(
    inside: &mut Cursor,
    route: &mut RouteSyntax,
    separators: &mut Separators,
    diagnostics: &mut Diagnostics,
) -> Result<()> {
    route.start = start(inside).map_err(|(_, error)| error)?;
    loop {
        if let Some(at) = inside.word("repeat") {
            return Err(Error::new(at, "`repeat` blocks cannot be nested"));
        }
        let item = route_item(inside, diagnostics)?;
        route.steps.push(StepSyntax::Item(item));
        if inside.is_empty() || inside.punct(';').is_some() {
            return Ok(());
        }
        if !joined(inside, route, separators, diagnostics) {
            return Err(inside.unexpected("`->`, `;` or `}`"));
        }
    }
}

/// Reads a group that contains route items: in other languages, branches.
fn group_of_items<'a>(input: &mut Cursor<'a>) -> Option<(Cursor<'a>, SpanRange)> {
    let groups = [Delimiter::Brace, Delimiter::Bracket, Delimiter::Parenthesis];
    let mut ahead = *input;
    let (inside, extent) = groups.into_iter().find_map(|delimiter| ahead.group(delimiter))?;
    if !has_arrow(inside) {
        return None;
    }
    *input = ahead;
    Some((inside, extent))
}

/// Reports items in brackets and reads them, so that their names are known.
fn branches(
    (mut inside, extent): (Cursor, SpanRange),
    route: &mut RouteSyntax,
    diagnostics: &mut Diagnostics,
) -> Result<()> {
    diagnostics.error(extent.first, BRANCHES);
    route.complete = false;
    let mut separators = Separators::reported();
    while !inside.is_empty() {
        if inside.peek_ident().is_some_and(|word| word == "repeat") {
            recover::names(inside, route);
            return Ok(());
        }
        let item = route_item(&mut inside, diagnostics)?;
        route.steps.push(StepSyntax::Item(item));
        let joined = inside.punct(';').is_some() || separators.read(&mut inside, diagnostics);
        if !joined {
            inside.check_empty("`->` or `,`")?;
        }
    }
    Ok(())
}
