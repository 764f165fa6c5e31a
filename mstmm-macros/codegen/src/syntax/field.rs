//! `name = value;` and what can be a value.

use proc_macro2::{Delimiter, Ident};
use syn::{Error, Result};

use super::cursor::Cursor;
use super::tree::{Expr, ExprKind, Field, Form, List, Written};
use super::{attribute, chain, number, unit};
use crate::diag::Diagnostics;

/// All fields of a block, and whether each had a name at least. Behind a mistake it goes on with
/// the next field.
pub(super) fn fields(mut inside: Cursor, diagnostics: &mut Diagnostics) -> (Vec<Field>, bool) {
    let mut fields = Vec::new();
    let mut whole = true;
    while !inside.is_empty() {
        if let Err(error) = attribute::docs(&mut inside) {
            diagnostics.push(error);
        }
        let Some(name) = inside.ident() else {
            if !inside.is_empty() {
                diagnostics.push(inside.unexpected("a field"));
                inside.skip_statement();
                whole = false;
            }
            continue;
        };
        fields.push(field(name, &mut inside, diagnostics));
    }
    (fields, whole)
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
    let next_field = ahead.ident().is_some() && ahead.peek_punct('=');
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
    if input.peek_group(Delimiter::Bracket) {
        let position = vector(input)?;
        return Ok(match turned(input)? {
            None => Written::Vector(position),
            Some(orientation) => Written::Placement(position, orientation),
        });
    }
    if is_form(input) {
        return form(input).map(Written::Form);
    }
    number::number(input).map(Written::Number)
}

/// `[a, b, c] unit`
pub(super) fn vector(input: &mut Cursor) -> Result<List> {
    let (inside, extent) =
        input.group(Delimiter::Bracket).ok_or_else(|| input.unexpected("a vector `[x, y, z]`"))?;
    let entries = number::list(inside)?;
    Ok(List { entries, unit: unit::optional(input)?, extent })
}

/// `turned orientation`, if it is there.
pub(super) fn turned(input: &mut Cursor) -> Result<Option<Form>> {
    match input.word("turned") {
        None => Ok(None),
        Some(_) if is_form(input) => form(input).map(Some),
        Some(_) => Err(input.unexpected("`rpy(roll, pitch, yaw)` or `quaternion(w, x, y, z)`")),
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
    let about = match input.word("about") {
        None => None,
        Some(_) => Some(input.ident().ok_or_else(|| input.unexpected("`input` or `com`"))?),
    };
    Ok(Form { word, list, about })
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
