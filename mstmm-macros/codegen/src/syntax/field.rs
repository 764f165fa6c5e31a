//! `name = value;` and what can be a value.

use proc_macro2::{Delimiter, Ident};
use syn::{Error, Result};

use super::cursor::Cursor;
use super::tree::{Expr, ExprKind, Extent, Field, Form, List, Turn, Written};
use super::{attribute, branch, chain, number, route, unit};
use crate::diag::{Diagnostics, nearest};

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
    let mut ends = Ends::default();
    while !inside.is_empty() {
        if let Err(error) = attribute::docs(&mut inside) {
            diagnostics.push(error);
        }
        let name = point(&mut inside).or_else(|| slip_of_point(&mut inside, diagnostics));
        if let Some(name) = name {
            content.points.push(ends.field(name, &mut inside, diagnostics));
        } else if let Some(name) = inside.ident() {
            content.fields.push(ends.field(name, &mut inside, diagnostics));
        } else if !inside.is_empty() {
            if !ends.lost {
                diagnostics.push(inside.unexpected("a field"));
            }
            inside.skip_statement();
            content.whole = false;
        }
    }
    content.whole &= !ends.skipped;
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

/// The name of a point behind a word that is close to `point`, which is reported.
fn slip_of_point(input: &mut Cursor, diagnostics: &mut Diagnostics) -> Option<Ident> {
    let mut ahead = *input;
    let word = ahead.ident()?;
    nearest(&word.to_string(), ["point"])?;
    let name = ahead.ident().filter(|_| ahead.peek_punct('='))?;
    diagnostics.error(word.span(), format!("unknown word `{word}`; did you mean `point`?"));
    *input = ahead;
    Some(name)
}

/// What stands behind the name of a field, up to and with its `;`.
pub(super) fn field(name: Ident, input: &mut Cursor, diagnostics: &mut Diagnostics) -> Field {
    Ends::default().field(name, input, diagnostics)
}

/// How the fields of a block end.
#[derive(Default)]
struct Ends {
    /// Whether it is reported that they end with commas, which is a mistake once.
    reported: bool,
    /// Whether words were skipped behind a mistake, which may have been a field.
    skipped: bool,
    /// Whether a `;` is in the place of the last field's `=`: the next tokens are its value.
    lost: bool,
}

impl Ends {
    fn field(&mut self, name: Ident, input: &mut Cursor, diagnostics: &mut Diagnostics) -> Field {
        let sign = if input.punct('=').is_some() { Ok(()) } else { Err(input.unexpected("`=`")) };
        let colon = sign.is_err() && input.punct(':').is_some();
        let has_sign = sign.is_ok();
        let value = match sign {
            Ok(()) => written(input).map(Some),
            // The value may follow all the same, or a type.
            Err(error) if colon => {
                diagnostics.push(error);
                Ok(written(input).ok().filter(|_| self.is_end(input)))
            }
            Err(error) => Err(error),
        };
        match value {
            Ok(Some(value)) => {
                let value = self.end(&value, input, diagnostics).then_some(value);
                self.lost = false;
                return Field { name, value };
            }
            Err(error) if has_sign || !self.lost => diagnostics.push(error),
            _ => {}
        }
        self.lost = !has_sign && !self.lost && input.peek_punct(';');
        self.skip(input);
        Field { name, value: None }
    }

    fn is_end(&self, input: &Cursor) -> bool {
        input.is_empty() || input.peek_punct(';') || input.peek_punct(',')
    }

    /// Whether the value ends here. Where only the `;` is missing in front of what comes next,
    /// neither is lost.
    fn end(&mut self, value: &Written, input: &mut Cursor, diagnostics: &mut Diagnostics) -> bool {
        if input.punct(';').is_some() {
            return true;
        }
        let item = chain::begins_item(input) || route::is_route_of_stops(input);
        if begins_field(input) || input.is_empty() || item {
            if !self.reported {
                diagnostics.error(input.last().first, "expected `;` after this");
            }
            return true;
        }
        let mut behind = *input;
        if let Some(at) = behind.punct(',') {
            if behind.literal().is_some() && is_literal(value) {
                diagnostics.error(at, "decimals are written with a point");
                self.skip(input);
                return false;
            }
            if begins_field(&behind) || behind.is_empty() {
                if !self.reported {
                    diagnostics.error(at, "fields end with `;`");
                }
                self.reported = true;
                *input = behind;
                return true;
            }
        }
        diagnostics.push(input.unexpected("`;`"));
        self.skip(input);
        false
    }

    /// Reads on to the end of a field in which a mistake was found: behind its `;`, or to the next
    /// field or item.
    fn skip(&mut self, input: &mut Cursor) {
        while !input.is_empty() && !begins_field(input) && !chain::begins_item(input) {
            if input.punct(';').is_some() {
                return;
            }
            if input.word("let").is_some() {
                input.ident();
            } else if input.ident().is_some() {
                // The end of a unit is none.
                let ends = ['*', '/', '^', ';'].iter().any(|&sign| input.peek_punct(sign));
                self.skipped |= !ends && !input.is_empty();
            } else {
                input.any();
            }
        }
    }
}

/// Whether `name =` is next, or `point name =`.
pub(super) fn begins_field(input: &Cursor) -> bool {
    let mut ahead = *input;
    point(&mut ahead).or_else(|| ahead.ident()).is_some() && ahead.peek_punct('=')
}

/// Whether this is a number without anything else.
fn is_literal(value: &Written) -> bool {
    matches!(value, Written::Number(Expr { kind: ExprKind::Number(_), .. }))
}

/// Anything that can stand behind `=`.
pub(super) fn written(input: &mut Cursor) -> Result<Written> {
    if input.is_empty() || input.peek_punct(';') {
        return Err(input.unexpected("a value"));
    }
    if is_form(input) {
        return form(input).map(Written::Form);
    }
    let start = Extent::token(input.next_span());
    let position = position(input)?;
    if let Written::Number(Expr { kind: ExprKind::Name(body), .. }) = &position
        && branch::place(input).is_some()
    {
        return Ok(Written::PlaceOn(body.clone(), start.to(input.last())));
    }
    if let Some(turn) = turned(input)? {
        return Ok(Written::Turned(position.into(), turn));
    }
    Ok(match (position, about(input)?) {
        (Written::Number(expr), Some(point)) => Written::About(expr, point),
        (Written::Vector(list), Some(_)) => {
            let message = "an inertia is `diag(xx, yy, zz)`, with round parentheses";
            return Err(Error::new(list.extent.first, message));
        }
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
    if inside.peek_group(Delimiter::Bracket) {
        return Err(Error::new(extent.first, format!("a matrix is written `{MATRIX}`")));
    }
    let entries = number::list(inside)?;
    let list = List { entries, unit: unit::optional(input)?, extent };
    if ['*', '/', '+'].iter().any(|&sign| input.peek_punct(sign)) {
        return Err(Error::new(input.next_span(), number::INSIDE));
    }
    Ok(list)
}

/// `turned orientation`, if it is there.
pub(super) fn turned(input: &mut Cursor) -> Result<Option<Turn>> {
    if input.word("turned").is_none() {
        return Ok(None);
    }
    if is_form(input) {
        return form(input).map(Turn::Form).map(Some);
    }
    if input.peek_group(Delimiter::Bracket) {
        return Err(input.unexpected("`rpy(roll, pitch, yaw)` or `quaternion(w, x, y, z)`"));
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

/// The words that forms begin with.
pub const FORMS: &[&str] = &["rpy", "quaternion", "diag", "tensor", "matrix"];

/// How a matrix is written.
const MATRIX: &str = "matrix([xx, xy, xz], [yx, yy, yz], [zx, zy, zz])";

/// `word(…)`, where the word is no function of numbers, or one of a form in other brackets.
fn is_form(input: &Cursor) -> bool {
    let mut ahead = *input;
    let Some(word) = ahead.ident() else { return false };
    if FORMS.iter().any(|form| word == form) {
        return ahead.peek_group(Delimiter::Parenthesis) || ahead.peek_group(Delimiter::Bracket);
    }
    let is_function = number::FUNCTIONS.iter().any(|function| word == function);
    let is_group = ahead.group(Delimiter::Parenthesis).is_some();
    is_group && !is_function && !number::is_operator_next(&ahead)
}

fn form(input: &mut Cursor) -> Result<Form> {
    let word = input.ident().ok_or_else(|| input.unexpected("a word"))?;
    if input.peek_group(Delimiter::Bracket) {
        let message = format!("write `{word}(…)`, with round parentheses");
        return Err(Error::new(input.next_span(), message));
    }
    let (inside, extent) =
        input.group(Delimiter::Parenthesis).ok_or_else(|| input.unexpected("`(`"))?;
    let entries = if word == "matrix" { rows(inside, extent)? } else { number::list(inside)? };
    let list = List { entries, unit: unit::optional(input)?, extent };
    if number::is_operator_next(input) {
        return Err(Error::new(input.next_span(), number::INSIDE));
    }
    Ok(Form { word, list, about: about(input)? })
}

/// The entries of a matrix, row by row.
fn rows(mut inside: Cursor, extent: Extent) -> Result<Vec<Expr>> {
    let shape = |at: Extent| Error::new_spanned(at, format!("a matrix is written `{MATRIX}`"));
    let mut entries = Vec::new();
    while let Some((row, brackets)) = inside.group(Delimiter::Bracket) {
        let row = number::list(row)?;
        if row.len() != 3 {
            return Err(shape(brackets));
        }
        entries.extend(row);
        if inside.punct(',').is_none() {
            break;
        }
    }
    if entries.len() != 9 || !inside.is_empty() {
        return Err(shape(extent));
    }
    Ok(entries)
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
