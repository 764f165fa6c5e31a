//! The route: stops joined by arrows.

use proc_macro2::{Delimiter, Ident, Span};
use syn::{Error, Result};

use super::cursor::Cursor;
use super::tree::{Arguments, Repeat, Route, Stop, Written};
use super::{chain, field};
use crate::diag::Diagnostics;

/// The largest count of a `repeat`.
const MOST_TIMES: usize = 10_000_000;

/// All stops up to and with the `;`. Behind a mistake it goes on with the next statement.
pub(super) fn route(input: &mut Cursor, diagnostics: &mut Diagnostics) -> Route {
    let mut route = Route { stops: Vec::new(), repeats: Vec::new(), whole: true };
    loop {
        let before = *input;
        let read = match input.word("repeat") {
            Some(at) => repeat(at, input, &mut route, diagnostics),
            None => stop(input).map(|stop| route.stops.push(stop)),
        };
        if let Err(error) = read {
            diagnostics.push(error);
            // A `;` may be just what was found in place of a stop.
            *input = before;
            input.skip_statement();
            route.whole = false;
            return route;
        }
        if input.punct(';').is_some() {
            return route;
        }
        if chain::begins_item(input) || input.is_empty() {
            diagnostics.error(input.last().first, "expected `;` after this");
            return route;
        }
        if input.pair('-', '>').is_none() {
            diagnostics.push(input.unexpected("`->` or `;`"));
            input.skip_statement();
            // The last stop is as likely the mistake as what stands behind it.
            route.stops.pop();
            route.whole = false;
            return route;
        }
    }
}

/// What stands behind `repeat`. A mistake in its count or in its stops is reported, and the route
/// goes on behind it.
fn repeat(
    at: Span,
    input: &mut Cursor,
    route: &mut Route,
    diagnostics: &mut Diagnostics,
) -> Result<()> {
    let count = count(input)?;
    let (inside, braces) = input.group(Delimiter::Brace).ok_or_else(|| input.unexpected("`{`"))?;
    let start = route.stops.len();
    let read = if inside.is_empty() {
        let message = format!("nothing is repeated here: {}", Repeat::EXAMPLE);
        Err(Error::new_spanned(braces, message))
    } else {
        contents(inside, &mut route.stops)
    };
    match (count, read) {
        (Ok(count), Ok(())) => {
            route.repeats.push(Repeat { at, count, stops: start..route.stops.len() });
        }
        (count, read) => {
            for error in [count.err(), read.err()].into_iter().flatten() {
                diagnostics.push(error);
            }
            route.whole = false;
        }
    }
    Ok(())
}

/// How many times: what is no number in its place is an error, a wrong number only the other one.
pub(super) fn count(input: &mut Cursor) -> Result<Result<usize>> {
    let literal = input.literal().ok_or_else(|| input.unexpected("how many times, a number"))?;
    let count = literal.to_string().replace('_', "").parse::<usize>();
    let known = count.ok().filter(|count| (1..=MOST_TIMES).contains(count));
    Ok(known.ok_or_else(|| {
        let message = format!("how many times is a whole number from 1 to {MOST_TIMES}");
        Error::new(literal.span(), message)
    }))
}

/// The stops in the braces of a `repeat`.
fn contents(mut inside: Cursor, stops: &mut Vec<Stop>) -> Result<()> {
    loop {
        if let Some(at) = inside.word("repeat") {
            return Err(Error::new(at, "`repeat` cannot stand within `repeat`"));
        }
        stops.push(stop(&mut inside)?);
        if inside.is_empty() {
            return Ok(());
        }
        if inside.pair('-', '>').is_none() {
            return Err(inside.unexpected("`->` or `}`"));
        }
    }
}

fn stop(input: &mut Cursor) -> Result<Stop> {
    if let Some(at) = input.word("ground") {
        let position =
            if input.word("at").is_some() { Some(field::position(input)?.into()) } else { None };
        return Ok(Stop::Ground { at, position, turned: field::turned(input)?.map(Box::new) });
    }
    if let Some(at) = input.word("moving") {
        return Ok(Stop::Moving { at, name: name(input) });
    }
    let word = input.ident().ok_or_else(|| input.unexpected("a hinge, a body or `ground`"))?;
    let arguments = match input.group(Delimiter::Parenthesis) {
        None => None,
        Some((inside, extent)) => Some(Arguments { values: values(inside)?, extent }),
    };
    Ok(Stop::Element { word, arguments, name: name(input) })
}

/// The name of a stop, if it has one.
fn name(input: &mut Cursor) -> Option<Ident> {
    if chain::begins_item(input) { None } else { input.ident() }
}

fn values(mut inside: Cursor) -> Result<Vec<Written>> {
    let mut values = Vec::new();
    while !inside.is_empty() {
        values.push(field::written(&mut inside)?);
        if inside.punct(',').is_none() {
            inside.check_empty("`,`")?;
        }
    }
    Ok(values)
}

/// Whether a statement that begins here looks like a route rather than like a misspelt item.
pub(super) fn is_route(input: &Cursor) -> bool {
    let mut ahead = *input;
    let ground = ahead.word("ground").is_some() || ahead.word("repeat").is_some();
    ground || stop(&mut ahead).is_ok_and(|_| ahead.peek_pair('-', '>') || ahead.peek_punct(';'))
}

/// A route that stands where one is already.
pub(super) fn second(at: Span) -> Error {
    Error::new(at, "a second route; a chain has one")
}
