//! Values: numbers, vectors and forms, with their orientation or their reference point.

use proc_macro2::{Delimiter, Ident, Span};
use syn::{Error, Result};

use super::cursor::Cursor;
use super::lookahead::{self, ORIENTATIONS};
use super::path::path_of_several;
use super::tree::{
    ExprKind, ExprSyntax, FormSyntax, ListSyntax, OrientationSyntax, SpanRange, ValueSyntax,
};
use super::{number, unit};

/// Parses a value that is no field.
pub(super) fn value(input: &mut Cursor) -> Result<ValueSyntax> {
    value_of(None, input)
}

/// Returns whether a field is an inertia, perhaps under a wrong name.
fn is_inertia(field: Option<&Ident>) -> bool {
    field.is_none_or(|field| ["mass", "com", "output"].iter().all(|known| field != known))
}

/// Parses the value of a field.
pub(super) fn value_of(field: Option<&Ident>, input: &mut Cursor) -> Result<ValueSyntax> {
    if input.is_empty() || input.peek_punct(';') {
        return Err(input.unexpected("a value"));
    }
    if input.peek_group(Delimiter::Brace) {
        return Err(Error::new(input.next_span(), number::SQUARE));
    }
    if is_form(input) {
        let form = ValueSyntax::Form(form(input)?);
        let turned = turned(input)?;
        return Ok(match turned {
            Some(orientation) => ValueSyntax::Turned(form.into(), orientation),
            None => form,
        });
    }
    let start = SpanRange::token(input.next_span());
    if let Some(path) = path_of_several(input) {
        number::no_index(input, None)?;
        return Ok(ValueSyntax::Path(path));
    }
    let position = position(input)?;
    if let ValueSyntax::Number(ExprSyntax { kind: ExprKind::Name(body), .. }) = &position
        && place(input).is_some()
    {
        return Ok(ValueSyntax::PlaceOn(body.clone(), start.to(input.last())));
    }
    if let Some(orientation) = turned(input)? {
        return Ok(ValueSyntax::Turned(position.into(), orientation));
    }
    Ok(match (position, about(input)?) {
        (ValueSyntax::Number(expr), Some(point)) => ValueSyntax::About(expr, point),
        (ValueSyntax::Vector(list), Some(_)) if is_inertia(field) => {
            let message = "write an inertia as `diag(xx, yy, zz)`, with round parentheses";
            return Err(Error::new(list.extent.first, message));
        }
        (_, Some(point)) => {
            return Err(Error::new(
                point.span(),
                "only an inertia has a reference point: remove \
                                                 `about …`",
            ));
        }
        (position, None) => position,
    })
}

/// Parses a vector, or a number in its place.
pub(super) fn position(input: &mut Cursor) -> Result<ValueSyntax> {
    if input.peek_group(Delimiter::Bracket) {
        return vector(input).map(ValueSyntax::Vector);
    }
    let mut ahead = *input;
    let turned = ahead
        .ident()
        .filter(|word| word == "turned" || lookahead::meant_after_value(input) == Some("turned"));
    if let Some(turned) = turned.filter(|_| lookahead::is_orientation(&ahead)) {
        let message = "write a position before `turned`: zeros if the frame is only rotated";
        return Err(Error::new(turned.span(), message));
    }
    number::number(input).map(ValueSyntax::Number)
}

/// `[a, b, c] unit`
fn vector(input: &mut Cursor) -> Result<ListSyntax> {
    let (inside, extent) =
        input.group(Delimiter::Bracket).ok_or_else(|| input.unexpected("a vector `[x, y, z]`"))?;
    if let Some((row, _)) = inside.clone().group(Delimiter::Bracket) {
        let message = match number::list(row) {
            Ok(row) if row.len() < 3 => "expected numbers in these brackets, found a list".into(),
            _ => format!("write a matrix as `{MATRIX}`"),
        };
        return Err(Error::new(extent.first, message));
    }
    let entries = number::list(inside)?;
    let list = ListSyntax { entries, unit: unit::optional(input)?, extent };
    if ['*', '/', '+'].iter().any(|&sign| input.peek_punct(sign)) {
        return Err(Error::new(input.next_span(), number::INSIDE));
    }
    Ok(list)
}

/// Parses `turned orientation`, if it is next.
pub(super) fn turned(input: &mut Cursor) -> Result<Option<OrientationSyntax>> {
    if input.word("turned").is_none() {
        return lacks_turned(input).map_or(Ok(None), Err);
    }
    let orientation = orientation(input)?;
    match input.word("at") {
        Some(at) => Err(Error::new(at, "write the position first: `at [x, y, z] turned …`")),
        None => Ok(Some(orientation)),
    }
}

/// Parses an orientation after `turned`.
fn orientation(input: &mut Cursor) -> Result<OrientationSyntax> {
    if is_form(input) {
        return form(input).map(OrientationSyntax::Form);
    }
    if input.peek_group(Delimiter::Bracket) {
        return Err(input.unexpected("`rpy(roll, pitch, yaw)` or `quaternion(w, x, y, z)`"));
    }
    number::number(input).map(OrientationSyntax::Angle)
}

/// Returns the error for an orientation that does not begin with `turned`.
fn lacks_turned(input: &Cursor) -> Option<Error> {
    let word = input.peek_ident()?;
    if ORIENTATIONS.iter().any(|form| word == form) && is_form(input) {
        let message = format!("write `turned` before an orientation: `turned {word}(…)`");
        return Some(Error::new(word.span(), message));
    }
    misspelt(input, "turned")
}

/// Reports a comma between a position and its orientation.
pub(super) fn no_comma_before_orientation(input: &Cursor) -> Result<()> {
    let mut ahead = *input;
    let Some(at) = ahead.punct(',') else { return Ok(()) };
    match ahead.peek_ident().filter(|_| lookahead::is_orientation(&ahead)) {
        Some(form) => {
            let message = format!("write `turned` instead of the comma: `turned {form}(…)`");
            Err(Error::new(at, message))
        }
        None => Ok(()),
    }
}

/// Returns the error for another word in the place of this keyword.
fn misspelt(input: &Cursor, keyword: &str) -> Option<Error> {
    let word = input.peek_ident()?;
    lookahead::meant_after_value(input).filter(|meant| *meant == keyword)?;
    let message = format!("unknown word `{word}`; did you mean `{keyword}`?");
    Some(Error::new(word.span(), message))
}

/// Reads a position on the item before it: `.lug`, `at lug` or `at [x, y, z]`. Returns the span of
/// its beginning.
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
            // The whole position is an error, so its parts are not checked.
            let _unit = unit::optional(&mut ahead);
            let _turn = turned(&mut ahead);
        }
        at
    };
    *input = ahead;
    Some(at)
}

/// Parses `about word`, if it is next.
fn about(input: &mut Cursor) -> Result<Option<Ident>> {
    match input.word("about") {
        None => misspelt(input, "about").map_or(Ok(None), Err),
        Some(_) => Ok(Some(input.ident().ok_or_else(|| input.unexpected("`input` or `com`"))?)),
    }
}

/// How a matrix is written.
const MATRIX: &str = "matrix([xx, xy, xz], [yx, yy, yz], [zx, zy, zz])";

/// Returns whether a form is next: `word(…)` with a word that is no function of numbers, or the
/// keyword of a form with any brackets.
fn is_form(input: &Cursor) -> bool {
    let mut ahead = *input;
    let Some(word) = ahead.ident() else { return false };
    if number::FORMS.iter().any(|form| word == form) {
        return ahead.peek_group(Delimiter::Parenthesis) || ahead.peek_group(Delimiter::Bracket);
    }
    let is_function = number::FUNCTIONS.iter().any(|function| word == function);
    let is_group = ahead.group(Delimiter::Parenthesis).is_some();
    is_group && !is_function && !number::is_operator_next(&ahead)
}

fn form(input: &mut Cursor) -> Result<FormSyntax> {
    let word = input.ident().ok_or_else(|| input.unexpected("a word"))?;
    if input.peek_group(Delimiter::Bracket) {
        let message = format!("write `{word}(…)`, with round parentheses");
        return Err(Error::new(input.next_span(), message));
    }
    let (inside, extent) =
        input.group(Delimiter::Parenthesis).ok_or_else(|| input.unexpected("`(`"))?;
    let entries = if word == "matrix" { rows(inside, extent)? } else { numbers(&word, inside)? };
    let list = ListSyntax { entries, unit: unit::optional(input)?, extent };
    if number::is_operator_next(input) {
        return Err(Error::new(input.next_span(), number::INSIDE));
    }
    Ok(FormSyntax { word, list, about: about(input)? })
}

/// The numbers of a form. Of an unknown form only the word is reported, by its user.
fn numbers(word: &Ident, inside: Cursor) -> Result<Vec<ExprSyntax>> {
    let is_known = number::FORMS.iter().any(|form| word == form);
    number::list(inside).or_else(|error| if is_known { Err(error) } else { Ok(Vec::new()) })
}

/// The entries of a matrix, row by row.
fn rows(mut inside: Cursor, extent: SpanRange) -> Result<Vec<ExprSyntax>> {
    let shape = |at: SpanRange| Error::new_spanned(at, format!("write a matrix as `{MATRIX}`"));
    let mut entries = Vec::new();
    while let Some((row, brackets)) = inside.group(Delimiter::Bracket) {
        if row.peek_group(Delimiter::Bracket) {
            return Err(shape(brackets));
        }
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

impl ValueSyntax {
    /// Returns the value if it is a single word, such as `input`.
    pub fn word(&self) -> Option<&Ident> {
        match self {
            ValueSyntax::Number(ExprSyntax {
                kind: ExprKind::Name(word) | ExprKind::Argument(word, _),
                ..
            }) => Some(word),
            _ => None,
        }
    }
}
