//! `name = value;` and what can be a value.

use proc_macro2::{Delimiter, Ident};
use syn::{Error, Result};

use super::cursor::Cursor;
use super::tree::{Expr, ExprKind, Field, Form, List, Turn, Written};
use super::{attribute, chain, number, unit};
use crate::diag::Diagnostics;

/// What stands in the braces of a block.
pub(super) struct Content {
    /// `name = value;`
    pub fields: Vec<Field>,
    /// `point name = value;`
    pub points: Vec<Field>,
    /// Whether each of them had a name at least.
    pub whole: bool,
}

/// All that stands in a block. Behind a mistake it goes on with the next field.
pub(super) fn content(mut inside: Cursor, diagnostics: &mut Diagnostics) -> Content {
    let mut content = Content { fields: Vec::new(), points: Vec::new(), whole: true };
    while !inside.is_empty() {
        if let Err(error) = attribute::docs(&mut inside) {
            diagnostics.push(error);
        }
        if let Some(name) = point(&mut inside) {
            content.points.push(field(name, &mut inside, diagnostics));
        } else if let Some(name) = inside.ident() {
            content.fields.push(field(name, &mut inside, diagnostics));
        } else if !inside.is_empty() {
            diagnostics.push(inside.unexpected("a field"));
            inside.skip_statement();
            content.whole = false;
        }
    }
    content
}

/// The name of a point, if one is next: `point name`.
fn point(input: &mut Cursor) -> Option<Ident> {
    let mut ahead = *input;
    ahead.word("point")?;
    let name = ahead.ident()?;
    *input = ahead;
    Some(name)
}

/// What stands behind the name of a field, up to and with its `;`.
pub(super) fn field(name: Ident, input: &mut Cursor, diagnostics: &mut Diagnostics) -> Field {
    let value = if input.punct('=').is_some() { written(input) } else { Err(no_value(input)) };
    match value {
        Ok(value) => {
            let value = semicolon(input, diagnostics).then_some(value);
            Field { name, value }
        }
        Err(error) => {
            diagnostics.push(error);
            input.skip_statement();
            Field { name, value: None }
        }
    }
}

fn no_value(input: &Cursor) -> Error {
    input.unexpected("`=`")
}

/// Whether the value ends here. Where only the `;` is missing in front of what comes next, neither
/// is lost.
fn semicolon(input: &mut Cursor, diagnostics: &mut Diagnostics) -> bool {
    if input.punct(';').is_some() {
        return true;
    }
    let mut ahead = *input;
    let next_field = point(&mut ahead).or_else(|| ahead.ident()).is_some() && ahead.peek_punct('=');
    if next_field || input.is_empty() || chain::begins_item(input) {
        diagnostics.error(input.last().first, "expected `;` after this");
        return true;
    }
    diagnostics.push(input.unexpected("`;`"));
    input.skip_statement();
    false
}

/// Anything that can stand behind `=`.
pub(super) fn written(input: &mut Cursor) -> Result<Written> {
    if is_form(input) {
        return form(input).map(Written::Form);
    }
    let position = position(input)?;
    if let Some(turn) = turned(input)? {
        return Ok(Written::Turned(position.into(), turn));
    }
    Ok(match (position, about(input)?) {
        (Written::Number(expr), Some(point)) => Written::About(expr, point),
        (_, Some(point)) => {
            return Err(Error::new(point.span(), "only an inertia is about a point"));
        }
        (position, None) => position,
    })
}

/// A vector, or a number in its place.
pub(super) fn position(input: &mut Cursor) -> Result<Written> {
    if input.peek_group(Delimiter::Bracket) {
        return vector(input).map(Written::Vector);
    }
    number::number(input).map(Written::Number)
}

/// `[a, b, c] unit`
fn vector(input: &mut Cursor) -> Result<List> {
    let (inside, extent) =
        input.group(Delimiter::Bracket).ok_or_else(|| input.unexpected("a vector `[x, y, z]`"))?;
    let entries = number::list(inside)?;
    Ok(List { entries, unit: unit::optional(input)?, extent })
}

/// `turned orientation`, if it is there.
pub(super) fn turned(input: &mut Cursor) -> Result<Option<Turn>> {
    if input.word("turned").is_none() {
        return Ok(None);
    }
    if is_form(input) {
        return form(input).map(Turn::Form).map(Some);
    }
    number::number(input).map(Turn::Angle).map(Some)
}

/// `about word`, if it is there.
fn about(input: &mut Cursor) -> Result<Option<Ident>> {
    match input.word("about") {
        None => Ok(None),
        Some(_) => Ok(Some(input.ident().ok_or_else(|| input.unexpected("`input` or `com`"))?)),
    }
}

/// `word(…)`, where the word is no function of numbers.
fn is_form(input: &Cursor) -> bool {
    let mut ahead = *input;
    ahead.ident().is_some_and(|word| number::FUNCTIONS.iter().all(|function| word != function))
        && ahead.peek_group(Delimiter::Parenthesis)
}

fn form(input: &mut Cursor) -> Result<Form> {
    let word = input.ident().ok_or_else(|| input.unexpected("a word"))?;
    let (inside, extent) =
        input.group(Delimiter::Parenthesis).ok_or_else(|| input.unexpected("`(`"))?;
    let list = List { entries: number::list(inside)?, unit: unit::optional(input)?, extent };
    Ok(Form { word, list, about: about(input)? })
}

impl Written {
    /// The single word that it is, such as `input`.
    pub fn word(&self) -> Option<&Ident> {
        match self {
            Written::Number(Expr { kind: ExprKind::Name(word), .. }) => Some(word),
            _ => None,
        }
    }
}
