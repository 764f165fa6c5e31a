//! Items of the route: hinges, bodies and ends.

use proc_macro2::{Delimiter, Ident, TokenTree};
use syn::{Error, Result};

use super::cursor::Cursor;
use super::lookahead::{HINGES, begins_field, name};
use super::route_tree::RouteItemSyntax;
use super::tree::{ArgumentsSyntax, ValueSyntax};
use super::value;
use crate::diag::Diagnostics;

/// Axes, which must be in parentheses after the kind of a hinge.
pub(super) const AXES: &[&str] = &["x", "y", "z"];

/// Parses a route item.
pub(super) fn route_item(
    input: &mut Cursor,
    diagnostics: &mut Diagnostics,
) -> Result<RouteItemSyntax> {
    if let Some(at) = input.word("ground") {
        let has_position = input.word("at").is_some() || lacks_at(input, diagnostics)?;
        let position = if has_position { Some(value::position(input)?.into()) } else { None };
        value::no_comma_before_orientation(input)?;
        return Ok(RouteItemSyntax::Ground {
            at,
            position,
            turned: value::turned(input)?.map(Box::new),
            name: name_alone(input),
        });
    }
    if let Some(at) = input.word("moving") {
        sign_before_name(input, diagnostics);
        let name = if begins_place(input) { None } else { name(input) };
        no_place(input, diagnostics)?;
        return Ok(RouteItemSyntax::Moving { at, name });
    }
    let word = input.ident().ok_or_else(|| input.unexpected("a hinge, a body or `ground`"))?;
    if word == "at" && input.peek_group(Delimiter::Bracket) {
        return Err(Error::new(word.span(), "write `ground` before the position: `ground at …`"));
    }
    let mut arguments = arguments(&word, input)?;
    let has_brackets = input.peek_group(Delimiter::Bracket);
    let may_misplace = has_brackets || begins_hinge(&word) || has_braces_and_name(input);
    if arguments.is_none() && may_misplace && is_misplaced(input) {
        return misplaced(&word, input, diagnostics);
    }
    // A position may follow the name, or a body that is written by its type or its name only.
    let place = value::place(input);
    let name = if place.is_some() { None } else { name(input) };
    let place = place.or_else(|| value::place(input));
    if arguments.is_none()
        && let Some(axis) = name.as_ref().filter(|name| AXES.iter().any(|axis| name == axis))
        && let Some(name_after) = self::name(input)
    {
        if begins_hinge(&name_after) {
            diagnostics.error(axis.span(), format!("write `{word}({axis}) {name_after}`"));
            return Ok(RouteItemSyntax::Unread { name: Some(name_after) });
        }
        // A capital letter begins a type of body: the arrow is missing.
        diagnostics.error(axis.span(), format!("write `{word}({axis}) name -> {name_after}`"));
        return Ok(RouteItemSyntax::Unread { name: self::name(input).or(Some(name_after)) });
    }
    let arguments_text = inside(input);
    let at = input.next_span();
    if let (None, Some(name), Some(after_name)) =
        (&arguments, &name, self::arguments(&word, input)?)
    {
        diagnostics.error(at, format!("write `{word}({arguments_text}) {name}`"));
        arguments = Some(after_name);
    }
    if begins_hinge(&word) && skip_fields(name.as_ref(), input, diagnostics) && name.is_none() {
        return Ok(RouteItemSyntax::Unread { name });
    }
    Ok(RouteItemSyntax::Element { word, arguments, name, place, after_error: false })
}

/// Reports the fields of a hinge on the route and skips them. Returns whether there are any.
fn skip_fields(name: Option<&Ident>, input: &mut Cursor, diagnostics: &mut Diagnostics) -> bool {
    let mut ahead = *input;
    let at = ahead.next_span();
    let Some((inside, _)) = ahead.group(Delimiter::Brace) else { return false };
    let is_argument = |word: Ident| NOT_FIELDS.iter().any(|other| word == other);
    let has_fields = begins_field(&inside) && !inside.peek_ident().is_some_and(is_argument);
    if has_fields {
        diagnostics.error(at, after_the_route(name, "…"));
        *input = ahead;
    }
    has_fields
}

/// Returns the message for fields of a hinge on the route.
fn after_the_route(name: Option<&Ident>, fields: &str) -> String {
    let name = name.map_or_else(|| "name".to_owned(), ToString::to_string);
    format!(
        "the fields of a hinge are not on the route: write `hinge {name} {{ {fields} }}` after it"
    )
}

/// Reports `=` or `:` before the name of a moving end.
fn sign_before_name(input: &mut Cursor, diagnostics: &mut Diagnostics) {
    let mut ahead = *input;
    let sign = if ahead.peek_pair('=', '>') { None } else { ahead.punct('=') };
    if let Some(at) = sign.or_else(|| ahead.punct(':'))
        && let Some(name) = ahead.peek_ident()
    {
        diagnostics.error(at, format!("write `moving {name}`"));
        *input = ahead;
    }
}

/// Reports a position of the ground without `at`; returns whether there is one.
fn lacks_at(input: &Cursor, diagnostics: &mut Diagnostics) -> Result<bool> {
    if input.peek_group(Delimiter::Parenthesis) {
        let message = "write the position as `ground at [x, y, z] m`";
        return Err(Error::new(input.next_span(), message));
    }
    let is_position = input.peek_group(Delimiter::Bracket) || input.clone().literal().is_some();
    if is_position {
        let message = "write `at` before the position: `ground at …`";
        diagnostics.error(input.next_span(), message);
    }
    Ok(is_position)
}

/// Reads a name after `ground`, if an arrow or the end of the route follows: it has none, which is reported later.
fn name_alone(input: &mut Cursor) -> Option<Ident> {
    let mut ahead = *input;
    let name = name(&mut ahead).filter(|name| {
        begins_hinge(name) && HINGES.iter().all(|kind| name != kind) && is_end(&ahead)
    })?;
    *input = ahead;
    Some(name)
}

/// Returns whether an item of a route ends here.
fn is_end(input: &Cursor) -> bool {
    input.is_empty() || input.peek_punct(';') || input.peek_pair('-', '>')
}

/// Returns whether `at` or `turned` begins a position or an orientation: alone it is a name.
fn begins_place(input: &Cursor) -> bool {
    let mut ahead = *input;
    let is_word = ahead.ident().is_some_and(|word| word == "at" || word == "turned");
    is_word && !is_end(&ahead)
}

/// Reports a position after a moving end.
fn no_place(input: &mut Cursor, diagnostics: &mut Diagnostics) -> Result<()> {
    let start = *input;
    let position = input.word("at").map(|_| value::position(input)).transpose()?;
    let orientation = value::turned(input)?;
    if position.is_some() || orientation.is_some() {
        diagnostics.error(start.next_span(), MOVING_HAS_NO_PLACE);
    }
    Ok(())
}

/// The message for a position of a moving end.
pub(super) const MOVING_HAS_NO_PLACE: &str = "a moving end has no position: its motion is an input";

/// Parses the arguments in parentheses, if there are any.
fn arguments(word: &Ident, input: &mut Cursor) -> Result<Option<ArgumentsSyntax>> {
    match input.group(Delimiter::Parenthesis) {
        None => Ok(None),
        Some((inside, extent)) => {
            let name = input.peek_ident();
            let values = values(inside, |field| {
                let is_field = begins_hinge(word) && NOT_FIELDS.iter().all(|other| field != other);
                is_field.then(|| after_the_route(name.as_ref(), &format!("{field} = …;")))
            })?;
            Ok(Some(ArgumentsSyntax { values, extent }))
        }
    }
}

/// Names of arguments in other programs that are not fields of a hinge.
const NOT_FIELDS: [&str; 5] = ["axis", "direction", "normal", "pitch", "name"];

/// Returns whether a word looks like the kind of a hinge.
fn begins_hinge(word: &Ident) -> bool {
    word.to_string().starts_with(char::is_lowercase)
}

/// Returns whether arguments are in brackets other than parentheses.
fn is_misplaced(input: &Cursor) -> bool {
    input.peek_group(Delimiter::Bracket)
        || input.peek_group(Delimiter::Brace)
        || input.peek_punct('<')
}

/// Returns whether braces and the name of an item are next.
fn has_braces_and_name(input: &Cursor) -> bool {
    let mut ahead = *input;
    let has_braces = ahead.group(Delimiter::Brace).is_some();
    let has_name = name(&mut ahead).is_some();
    has_braces && has_name && (ahead.peek_punct(';') || ahead.peek_pair('-', '>'))
}

/// Reports a hinge with brackets other than parentheses, and reads its name only.
fn misplaced(
    word: &Ident,
    input: &mut Cursor,
    diagnostics: &mut Diagnostics,
) -> Result<RouteItemSyntax> {
    if skip_fields(None, input, diagnostics) {
        return Ok(RouteItemSyntax::Unread { name: name(input) });
    }
    let at = input.next_span();
    let mut arguments_text = inside(input);
    if input.punct('<').is_some() {
        while !input.is_empty() && !input.peek_punct(';') && input.punct('>').is_none() {
            arguments_text.extend(input.any().map(|token| token.to_string()));
        }
    } else {
        input.any();
        if input.peek_punct('.') {
            let message = format!(
                "a place has no index: in a `repeat` it is that of the same repetition, outside \
                 of it that of the last one; write `{word}.place`"
            );
            return Err(Error::new(at, message));
        }
    }
    let name = name(input);
    let called = name.as_ref().map_or_else(|| "name".to_owned(), ToString::to_string);
    diagnostics.error(at, format!("write `{word}({arguments_text}) {called}`"));
    Ok(RouteItemSyntax::Unread { name })
}

/// Returns the content of the next brackets, for a message.
fn inside(input: &Cursor) -> String {
    match input.clone().any() {
        Some(TokenTree::Group(group)) if group.delimiter() != Delimiter::Brace => {
            group.stream().to_string()
        }
        Some(TokenTree::Group(_)) => "…".into(),
        _ => String::new(),
    }
}

/// Parses arguments. `other` returns the message for a name that is not the name of an argument.
fn values(
    mut inside: Cursor,
    other: impl Fn(&Ident) -> Option<String>,
) -> Result<Vec<ValueSyntax>> {
    let mut values = Vec::new();
    while !inside.is_empty() {
        let mut ahead = inside;
        if let Some(name) = ahead.ident().filter(|_| ahead.peek_punct('=')) {
            let message = other(&name)
                .unwrap_or_else(|| format!("arguments have no names: remove `{name} =`"));
            return Err(Error::new(name.span(), message));
        }
        values.push(value::value(&mut inside)?);
        if inside.punct(',').is_none() {
            inside.check_empty("`,`")?;
        }
    }
    Ok(values)
}
