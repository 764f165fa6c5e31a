//! The route: stops joined by arrows.

use proc_macro2::Delimiter;
use syn::{Error, Result};

use super::cursor::Cursor;
use super::tree::{Arguments, Route, Stop, Written};
use super::{chain, field};
use crate::diag::Diagnostics;

/// All stops up to and with the `;`. Behind a mistake it goes on with the next statement.
pub(super) fn route(input: &mut Cursor, diagnostics: &mut Diagnostics) -> Route {
    let mut route = Route { stops: Vec::new(), whole: true };
    loop {
        let before = *input;
        if let Some(at) = input.word("repeat") {
            diagnostics.error(at, "`repeat` is not supported yet");
            route.whole = false;
            input.literal();
            input.group(Delimiter::Brace);
        } else {
            match stop(input) {
                Ok(stop) => route.stops.push(stop),
                Err(error) => {
                    diagnostics.push(error);
                    // A `;` may be just what was found in place of a stop.
                    *input = before;
                    input.skip_statement();
                    route.whole = false;
                    return route;
                }
            }
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

fn stop(input: &mut Cursor) -> Result<Stop> {
    if let Some(at) = input.word("ground") {
        let position = if input.word("at").is_some() { Some(field::vector(input)?) } else { None };
        return Ok(Stop::Ground { at, position, turned: field::turned(input)? });
    }
    let word = input.ident().ok_or_else(|| input.unexpected("a hinge, a body or `ground`"))?;
    let arguments = match input.group(Delimiter::Parenthesis) {
        None => None,
        Some((inside, extent)) => Some(Arguments { values: values(inside)?, extent }),
    };
    let name = if chain::begins_item(input) { None } else { input.ident() };
    Ok(Stop::Element { word, arguments, name })
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
pub(super) fn second(at: proc_macro2::Span) -> Error {
    Error::new(at, "a second route; a chain has one")
}
