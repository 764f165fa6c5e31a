//! The route: stops joined by arrows.

use proc_macro2::{Delimiter, Ident, Span, TokenTree};
use syn::{Error, Result};

use super::cursor::Cursor;
use super::recover::{self, doubtful};
use super::tree::{Arguments, Repeat, Route, Stop, Written};
use super::{branch, chain, field};
use crate::diag::Diagnostics;

/// The largest count of a `repeat`.
const MOST_TIMES: usize = 10_000_000;

/// All stops up to and with the `;`. Behind a mistake it goes on with the next statement.
pub(super) fn route(input: &mut Cursor, diagnostics: &mut Diagnostics) -> Route {
    let mut route =
        Route { stops: Vec::new(), repeats: Vec::new(), whole: true, further: Vec::new() };
    let mut joints = Joints::default();
    loop {
        let before = *input;
        let word = input.word("repeat").or_else(|| recover::slip_of_repeat(input, diagnostics));
        let read = if let Some(at) = word {
            repeat(at, input, &mut route, &mut joints, diagnostics)
        } else if let Some(group) = branch::group(input) {
            branch::branches(group, &mut route, diagnostics)
        } else {
            stop(input, diagnostics).map(|stop| route.stops.push(stop))
        };
        if let Err(error) = read {
            diagnostics.push(error);
            // A `;` may be just what was found in place of a stop.
            *input = before;
            recover::rest(input, &mut route);
            return route;
        }
        if input.punct(';').is_some() {
            return route;
        }
        if chain::begins_item(input) || input.is_empty() {
            diagnostics.error(input.last().first, "expected `;` after this");
            return route;
        }
        let joined = joints.read(input, diagnostics);
        route.whole &= !joints.branches;
        if !joined {
            diagnostics.push(input.unexpected("`->` or `;`"));
            // The last stop is as likely the mistake as what stands behind it.
            if let Some(Stop::Element { doubtful, .. }) = route.stops.last_mut() {
                *doubtful = true;
            }
            recover::rest(input, &mut route);
            return route;
        }
    }
}

/// Words that belong in parentheses behind the kind of a hinge.
const AXES: &[&str] = &["x", "y", "z"];

/// What joins stops. Where it is written otherwise all along, that is reported once.
#[derive(Default)]
pub(super) struct Joints {
    reported: bool,
    /// Whether an arrow was read: then what stands in place of one may begin a branch.
    has_arrow: bool,
    /// Whether it did.
    branches: bool,
}

impl Joints {
    /// Between stops that are reported as a whole.
    pub fn reported() -> Self {
        Joints { reported: true, ..Joints::default() }
    }

    /// Reads a `->`, or what stands in its place.
    pub fn read(&mut self, input: &mut Cursor, diagnostics: &mut Diagnostics) -> bool {
        if input.pair('-', '>').is_some() {
            self.has_arrow = true;
            return true;
        }
        let (at, before) = (input.next_span(), *input);
        let branches = self.has_arrow && [',', '|', '&'].iter().any(|&sign| input.peek_punct(sign));
        let mut signs = 0;
        while ['-', '=', '<', '>', ',', '|', '&'].iter().any(|&sign| input.punct(sign).is_some()) {
            signs += 1;
        }
        if input.peek_ident().is_none() {
            // No stop stands behind it.
            *input = before;
            return false;
        }
        if signs > 0 && !self.reported {
            let more = if branches { format!("; {}", branch::BRANCHES) } else { String::new() };
            diagnostics.error(at, format!("stops are joined by `->`{more}"));
            self.reported = true;
            self.branches |= branches;
        }
        signs > 0
    }
}

/// What stands behind `repeat`. A mistake in its count or in its stops is reported, and the route
/// goes on behind it.
fn repeat(
    at: Span,
    input: &mut Cursor,
    route: &mut Route,
    joints: &mut Joints,
    diagnostics: &mut Diagnostics,
) -> Result<()> {
    let count = count("how many times", input)?;
    let (inside, braces) = input.group(Delimiter::Brace).ok_or_else(|| input.unexpected("`{`"))?;
    let start = route.stops.len();
    let read = if inside.is_empty() {
        let message = format!("nothing is repeated here: {}", Repeat::EXAMPLE);
        Err(Error::new_spanned(braces, message))
    } else {
        contents(inside, route, joints, diagnostics)
    };
    match (count, read) {
        (Ok(count), Ok(())) => {
            route.repeats.push(Repeat { at, count: Some(count), stops: start..route.stops.len() });
        }
        (count, read) => {
            let times = count.as_ref().ok().copied();
            for error in [count.err(), read.err()].into_iter().flatten() {
                diagnostics.push(error);
            }
            route.whole = false;
            let stops = start..route.stops.len();
            if !stops.is_empty() {
                route.repeats.push(Repeat { at, count: times, stops });
            }
        }
    }
    Ok(())
}

/// How many there are of what is asked for: what is no number in its place is an error, a wrong
/// number only the other one.
pub(super) fn count(asked: &str, input: &mut Cursor) -> Result<Result<usize>> {
    let number = || input.unexpected(&format!("{asked}, a number"));
    let Some(literal) = input.clone().literal() else { return Err(number()) };
    input.any();
    let count = literal.to_string().replace('_', "").parse::<usize>();
    let known = count.ok().filter(|count| (1..=MOST_TIMES).contains(count));
    Ok(known.ok_or_else(|| {
        let message = format!("{asked} is a whole number from 1 to {MOST_TIMES}");
        Error::new(literal.span(), message)
    }))
}

/// The stops in the braces of a `repeat`.
fn contents(
    mut inside: Cursor,
    route: &mut Route,
    joints: &mut Joints,
    diagnostics: &mut Diagnostics,
) -> Result<()> {
    loop {
        if let Some(at) = inside.word("repeat") {
            return Err(Error::new(at, "`repeat` cannot stand within `repeat`"));
        }
        route.stops.push(stop(&mut inside, diagnostics)?);
        if inside.is_empty() {
            return Ok(());
        }
        if !joints.read(&mut inside, diagnostics) {
            let error = inside.unexpected("`->` or `}`");
            while !inside.is_empty() {
                doubtful(&mut inside, route);
            }
            return Err(error);
        }
    }
}

pub(super) fn stop(input: &mut Cursor, diagnostics: &mut Diagnostics) -> Result<Stop> {
    if let Some(at) = input.word("ground") {
        let position =
            if input.word("at").is_some() { Some(field::position(input)?.into()) } else { None };
        return Ok(Stop::Ground { at, position, turned: field::turned(input)?.map(Box::new) });
    }
    if let Some(at) = input.word("moving") {
        let place = |word: &Ident| word == "at" || word == "turned";
        let name =
            if input.peek_ident().is_some_and(|word| place(&word)) { None } else { name(input) };
        no_place(input, diagnostics)?;
        return Ok(Stop::Moving { at, name });
    }
    let word = input.ident().ok_or_else(|| input.unexpected("a hinge, a body or `ground`"))?;
    let mut arguments = arguments(input)?;
    if arguments.is_none() && begins_hinge(&word) && is_misplaced(input) {
        return misplaced(&word, input, diagnostics);
    }
    // A place may follow on the name, or on a body that is called by its type or its name only.
    let place = branch::place(input);
    let name = if place.is_some() { None } else { name(input) };
    let place = place.or_else(|| branch::place(input));
    if arguments.is_none()
        && let Some(axis) = name.as_ref().filter(|name| AXES.iter().any(|axis| name == axis))
        && let Some(own) = self::name(input)
    {
        diagnostics.error(axis.span(), format!("write `{word}({axis}) {own}`"));
        return Ok(Stop::Unread { name: Some(own) });
    }
    let written = inside(input);
    let at = input.next_span();
    if let (None, Some(name), Some(behind)) = (&arguments, &name, self::arguments(input)?) {
        diagnostics.error(at, format!("write `{word}({written}) {name}`"));
        arguments = Some(behind);
    }
    Ok(Stop::Element { word, arguments, name, place, doubtful: false })
}

/// The name of a stop, if it has one.
fn name(input: &mut Cursor) -> Option<Ident> {
    if chain::begins_block(input) { None } else { input.ident() }
}

/// Refuses a place behind a moving end.
fn no_place(input: &mut Cursor, diagnostics: &mut Diagnostics) -> Result<()> {
    let start = *input;
    let position = input.word("at").map(|_| field::position(input)).transpose()?;
    let turn = field::turned(input)?;
    if position.is_some() || turn.is_some() {
        diagnostics.error(start.next_span(), MOVING_HAS_NO_PLACE);
    }
    Ok(())
}

/// What is said where a moving end gets a place.
pub(super) const MOVING_HAS_NO_PLACE: &str =
    "a moving end has no place: its motion is given at each step";

/// What stands in parentheses, if it is there.
fn arguments(input: &mut Cursor) -> Result<Option<Arguments>> {
    match input.group(Delimiter::Parenthesis) {
        None => Ok(None),
        Some((inside, extent)) => Ok(Some(Arguments { values: values(inside)?, extent })),
    }
}

/// Whether this is the word of a hinge by its looks.
fn begins_hinge(word: &Ident) -> bool {
    word.to_string().starts_with(char::is_lowercase)
}

/// Whether what belongs in parentheses stands in other brackets.
fn is_misplaced(input: &Cursor) -> bool {
    input.peek_group(Delimiter::Bracket)
        || input.peek_group(Delimiter::Brace)
        || input.peek_punct('<')
}

/// A hinge with other brackets than parentheses: nothing but its name can be read.
fn misplaced(word: &Ident, input: &mut Cursor, diagnostics: &mut Diagnostics) -> Result<Stop> {
    let at = input.next_span();
    let mut written = inside(input);
    if input.punct('<').is_some() {
        while !input.is_empty() && !input.peek_punct(';') && input.punct('>').is_none() {
            written.extend(input.any().map(|token| token.to_string()));
        }
    } else {
        input.any();
    }
    let name = name(input);
    let called = name.as_ref().map_or_else(|| "name".to_owned(), ToString::to_string);
    diagnostics.error(at, format!("write `{word}({written}) {called}`"));
    Ok(Stop::Unread { name })
}

/// What stands in the brackets that are next, for a message.
fn inside(input: &Cursor) -> String {
    match input.clone().any() {
        Some(TokenTree::Group(group)) if group.delimiter() != Delimiter::Brace => {
            group.stream().to_string()
        }
        Some(TokenTree::Group(_)) => "…".into(),
        _ => String::new(),
    }
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

/// Whether a statement that begins here looks like a route rather than like a misspelt item: by its
/// first word, by an arrow, or by a body that stands alone.
pub(super) fn is_route(input: &Cursor) -> bool {
    let mut ahead = *input;
    let body = ahead.ident().is_some_and(|word| word.to_string().starts_with(char::is_uppercase));
    let _name = name(&mut ahead);
    let ends = ahead.peek_punct(';') || ahead.is_empty() || chain::begins_block(&ahead);
    (body && ends) || is_route_of_stops(input)
}

/// Whether it begins with a word that only a route begins with, or has an arrow.
pub(super) fn is_route_of_stops(input: &Cursor) -> bool {
    let mut ahead = *input;
    let Some(first) = ahead.ident() else { return false };
    // Brackets in the wrong place.
    ahead.group(Delimiter::Brace);
    first == "ground" || first == "repeat" || has_arrow(ahead)
}

/// Whether an arrow stands in the rest of a statement.
pub(super) fn has_arrow(mut rest: Cursor) -> bool {
    let pairs = [('-', '>'), ('=', '>'), ('<', '-')];
    let is_arrow = |at: &Cursor| pairs.iter().any(|&(first, second)| at.peek_pair(first, second));
    while !rest.is_empty() && !rest.peek_punct(';') && !chain::begins_item(&rest) {
        if is_arrow(&rest) {
            return true;
        }
        if rest.group(Delimiter::Brace).is_some() {
            return is_arrow(&rest);
        }
        rest.any();
    }
    false
}
