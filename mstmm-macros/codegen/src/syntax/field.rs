//! `name = value;`

use proc_macro2::Ident;
use syn::Result;
use syn::ext::IdentExt;

use super::cursor::Cursor;
use super::lookahead::{begins_field, point};
use super::tree::{ExprKind, ExprSyntax, FieldSyntax, ValueSyntax};
use super::value;
use super::{attribute, lookahead, other_programs, shape};
use crate::diag::{Diagnostics, nearest};

/// The content of a block.
pub(super) struct Content {
    /// `name = value;`
    pub fields: Vec<FieldSyntax>,
    /// `point name = value;`
    pub points: Vec<FieldSyntax>,
    /// Whether each field has at least a name.
    pub complete: bool,
}

/// Parses the content of a block. After an error it continues with the next field.
pub(super) fn content(mut inside: Cursor, diagnostics: &mut Diagnostics) -> Content {
    let mut content = Content { fields: Vec::new(), points: Vec::new(), complete: true };
    let mut ends = Ends::default();
    while !inside.is_empty() {
        if let Err(error) = attribute::docs(&mut inside) {
            diagnostics.push(error);
        }
        let name = point(&mut inside).or_else(|| misspelt_point(&mut inside, diagnostics));
        if let Some(name) = name {
            content.points.push(ends.field(name, &mut inside, diagnostics));
        } else if let Some(nameless) = nameless_point(&mut inside) {
            diagnostics.error(nameless.span(), "a point needs a name: `point name = …`");
            ends.field(nameless, &mut inside, diagnostics);
            content.complete = false;
        } else if let Some(name) = inside.ident() {
            content.fields.push(ends.field(name, &mut inside, diagnostics));
        } else if !inside.is_empty() {
            if !ends.lost {
                diagnostics.push(inside.unexpected("a field"));
            }
            inside.skip_statement();
            content.complete = false;
        }
    }
    content.complete &= !ends.skipped;
    content
}

/// Reads `point`, if `=` follows.
fn nameless_point(input: &mut Cursor) -> Option<Ident> {
    let mut ahead = *input;
    let word = ahead.ident().filter(|word| word == "point" && ahead.peek_punct('='))?;
    *input = ahead;
    Some(word)
}

/// Reads the name of a point after a misspelt `point` or a word of other programs, which is reported.
fn misspelt_point(input: &mut Cursor, diagnostics: &mut Diagnostics) -> Option<Ident> {
    let mut ahead = *input;
    let word = ahead.ident()?;
    if other_programs::POINTS.iter().all(|point| word != point) {
        nearest(&word.to_string(), ["point"])?;
    }
    let name = ahead.ident().filter(|_| ahead.peek_punct('='))?;
    diagnostics.error(word.span(), format!("unknown word `{word}`; did you mean `point`?"));
    *input = ahead;
    Some(name)
}

/// Parses the rest of a field after its name, including `;`.
pub(super) fn field(name: Ident, input: &mut Cursor, diagnostics: &mut Diagnostics) -> FieldSyntax {
    Ends::default().field(name, input, diagnostics)
}

/// Parses the value of a field.
fn value_of(name: &Ident, input: &mut Cursor) -> Result<ValueSyntax> {
    if name == "shape" || shape::is_next(input) {
        return shape::shapes(input).map(ValueSyntax::Shapes);
    }
    value::value_of(Some(name), input)
}

/// The fields whose values are single words.
const ONE_WORD: &[&str] = &["on", "axes", "method"];

/// State of the recovery from wrong ends of fields.
#[derive(Default)]
struct Ends {
    /// Whether a comma instead of `;` has been reported: once for each block.
    reported: bool,
    /// Whether skipped words after an error may have been a field.
    skipped: bool,
    /// Whether the last field has `;` instead of `=`: the next tokens are its value.
    lost: bool,
}

impl Ends {
    fn field(
        &mut self,
        name: Ident,
        input: &mut Cursor,
        diagnostics: &mut Diagnostics,
    ) -> FieldSyntax {
        let name = hyphenated(&name, input, diagnostics).unwrap_or(name);
        let sign = if input.punct('=').is_some() { Ok(()) } else { Err(input.unexpected("`=`")) };
        let colon = sign.is_err() && input.punct(':').is_some();
        let has_sign = sign.is_ok();
        let value = match sign {
            Ok(()) => value_of(&name, input).and_then(|value| {
                value::no_comma_before_orientation(input)?;
                Ok(Some(value))
            }),
            // The value may follow anyway, or a type.
            Err(error) if colon => {
                diagnostics.push(error);
                Ok(value_of(&name, input).ok().filter(|_| self.is_end(input)))
            }
            Err(error) => Err(error),
        };
        match value {
            Ok(Some(value)) => {
                let value = self.end(&name, &value, input, diagnostics).then_some(value);
                self.lost = false;
                return FieldSyntax { name, value };
            }
            Err(error) if has_sign || !self.lost => diagnostics.push(error),
            _ => {}
        }
        self.lost = !has_sign && !self.lost && input.peek_punct(';');
        self.skip(input);
        FieldSyntax { name, value: None }
    }

    fn is_end(&self, input: &Cursor) -> bool {
        input.is_empty() || input.peek_punct(';') || input.peek_punct(',')
    }

    /// Returns whether the value ends here. If only its `;` is missing, the value and what follows
    /// are kept.
    fn end(
        &mut self,
        name: &Ident,
        value: &ValueSyntax,
        input: &mut Cursor,
        diagnostics: &mut Diagnostics,
    ) -> bool {
        if input.punct(';').is_some() {
            return true;
        }
        let item = lookahead::begins_item(input) || lookahead::is_clearly_route(input);
        if begins_field(input) || input.is_empty() || item {
            if !self.reported {
                diagnostics.error(input.last().first, "expected `;` after this");
            }
            return true;
        }
        let mut after = *input;
        if let Some(at) = after.punct(',') {
            if after.literal().is_some() && is_literal(value) {
                diagnostics.error(at, "write decimals with a point");
                self.skip(input);
                return false;
            }
            let is_path = matches!(value, ValueSyntax::Path(_));
            let is_word = is_path || value.word().is_some();
            if is_word && after.peek_ident().is_some() && !begins_field(&after) {
                let message = match is_path || ONE_WORD.iter().any(|field| name == field) {
                    true => format!("`{name}` has one value: remove the others"),
                    false => "write several words in brackets: `[…, …]`".to_owned(),
                };
                diagnostics.error(at, message);
                self.skip(input);
                return false;
            }
            if begins_field(&after) || after.is_empty() {
                if !self.reported {
                    diagnostics.error(at, "fields end with `;`");
                }
                self.reported = true;
                *input = after;
                return true;
            }
        }
        diagnostics.push(input.unexpected("`;`"));
        self.skip(input);
        false
    }

    /// Skips the rest of a field with an error: up to its `;`, or to the next field or item.
    fn skip(&mut self, input: &mut Cursor) {
        while !input.is_empty() && !begins_field(input) && !lookahead::begins_item(input) {
            if input.punct(';').is_some() {
                return;
            }
            if input.word("let").is_some() {
                input.ident();
            } else if input.ident().is_some() {
                // A word within a unit is not a field.
                let ends = ['*', '/', '^', ';'].iter().any(|&sign| input.peek_punct(sign));
                self.skipped |= !ends && !input.is_empty();
            } else {
                input.any();
            }
        }
    }
}

/// Reads the rest of a name with hyphens before `=` and reports it. Returns the name with underscores.
fn hyphenated(name: &Ident, input: &mut Cursor, diagnostics: &mut Diagnostics) -> Option<Ident> {
    let mut ahead = *input;
    let plain = name.unraw().to_string();
    let mut text = plain.clone();
    while ahead.punct('-').is_some() {
        text += &format!("_{}", ahead.ident()?.unraw());
    }
    if text == plain || !ahead.peek_punct('=') {
        return None;
    }
    diagnostics.error(name.span(), format!("a name has no hyphens: write `{text}`"));
    *input = ahead;
    Some(Ident::new(&text, name.span()))
}

/// Returns whether this is a literal, with a minus or without.
fn is_literal(value: &ValueSyntax) -> bool {
    let ValueSyntax::Number(ExprSyntax { kind, .. }) = value else { return false };
    match kind {
        ExprKind::Negated(inner) => matches!(inner.kind, ExprKind::Number(_)),
        other => matches!(other, ExprKind::Number(_)),
    }
}
