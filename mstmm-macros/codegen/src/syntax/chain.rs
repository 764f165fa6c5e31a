//! `chain Name { … }`

use proc_macro2::{Delimiter, Ident, Span};
use syn::{Attribute, Error, Result, Visibility};

use super::cursor::Cursor;
use super::lookahead::SETTINGS;
use super::path::{begins_with_path, path_of_several};
use super::route_tree::{ChainSyntax, ContentSyntax, DimensionKeyword, ParameterSyntax};
use super::tree::{FieldSyntax, SpanRange};
use super::{attribute, content, field, lookahead, number, other_programs, part, route_item};
use crate::diag::{Diagnostics, did_you_mean, nearest};

/// The keywords that may precede `chain`.
pub(super) const DIMENSIONS: &[(&str, DimensionKeyword)] = &[
    ("space", DimensionKeyword::Space),
    ("plane", DimensionKeyword::Plane),
    ("line", DimensionKeyword::Line),
];

/// The count of a parameter whose count is not readable.
const UNKNOWN_COUNT: usize = 1000;

/// Parses one chain; returns `None` if its head is not readable.
pub(super) fn chain(input: &mut Cursor, diagnostics: &mut Diagnostics) -> Option<ChainSyntax> {
    let (mut def, mut inside) = match head(input, diagnostics) {
        Ok(head) => head,
        Err(error) => {
            diagnostics.push(error);
            input.skip_statement();
            return None;
        }
    };
    while !inside.is_empty() {
        let docs = attribute::docs(&mut inside).unwrap_or_else(|error| {
            diagnostics.push(error);
            Vec::new()
        });
        if !inside.is_empty() {
            item(docs, &mut inside, &mut def, diagnostics);
        }
    }
    Some(def)
}

fn head<'a>(
    input: &mut Cursor<'a>,
    diagnostics: &mut Diagnostics,
) -> Result<(ChainSyntax, Cursor<'a>)> {
    let attributes = attribute::of_chain(input).or_else(|error| {
        diagnostics.push(error);
        Ok::<_, Error>(Vec::new())
    })?;
    let visibility = attribute::visibility(input).unwrap_or_else(|error| {
        diagnostics.push(error);
        Visibility::Inherited
    });
    let mut dimension = Some(dimension(input));
    if input.word("chain").is_none() {
        let error = no_chain(input);
        let word = input.peek_ident();
        let Some(of_chain) = misspelt_chain(input) else { return Err(error) };
        if !of_chain {
            dimension = word.and_then(|word| near_dimension(&word));
        }
        diagnostics.push(error);
    }
    let mut name = input.ident().ok_or_else(|| input.unexpected("the chain's name"))?;
    let (inside, _) = match input.group(Delimiter::Brace) {
        Some(group) => group,
        None => {
            let error = input.unexpected("`{`");
            name = input.ident().unwrap_or(name);
            let other = [Delimiter::Brace, Delimiter::Bracket, Delimiter::Parenthesis];
            let group = other.into_iter().find_map(|other| input.group(other));
            let Some(mut group) = group else { return Err(error) };
            // The first brackets may be those of parameters, which a chain does not have.
            group = input.group(Delimiter::Brace).unwrap_or(group);
            diagnostics.push(error);
            group
        }
    };
    let def = ChainSyntax {
        attributes,
        visibility,
        dimension,
        name,
        settings: Vec::new(),
        parameters: Vec::new(),
        parts: Vec::new(),
        content: ContentSyntax::empty(),
    };
    Ok((def, inside))
}

/// Skips a wrong word if the head of the chain has no other error. Returns whether the word
/// replaces `chain`; otherwise it precedes `chain`.
fn misspelt_chain(input: &mut Cursor) -> Option<bool> {
    // An item has no chain around it.
    if lookahead::begins_item(input) {
        return None;
    }
    let mut ahead = *input;
    ahead.any();
    let of_chain = ahead.word("chain").is_none();
    let mut after = ahead;
    after.ident()?;
    if !after.peek_group(Delimiter::Brace) {
        return None;
    }
    *input = ahead;
    Some(of_chain)
}

/// Returns the dimension whose keyword is closest to `word`.
fn near_dimension(word: &Ident) -> Option<DimensionKeyword> {
    let near = nearest(&word.to_string(), DIMENSIONS.iter().map(|(known, _)| *known))?;
    DIMENSIONS.iter().find(|(known, _)| *known == near).map(|&(_, dimension)| dimension)
}

/// Returns the error for a missing `chain`, which may follow a wrong word.
fn no_chain(input: &Cursor) -> Error {
    let mut ahead = *input;
    let word = ahead.any().map_or_else(String::new, |word| word.to_string());
    if ahead.word("chain").is_none() {
        return input.unexpected("`chain`");
    }
    let words = || DIMENSIONS.iter().map(|(known, _)| *known);
    if words().any(|known| known == word) {
        let message = "a chain has one word for its dimension: remove this one";
        return Error::new(input.next_span(), message);
    }
    let hint = did_you_mean(&word, words());
    let message = format!("expected `space`, `plane`, `line` or nothing before `chain`{hint}");
    Error::new(input.next_span(), message)
}

/// Reads the keyword before `chain`; without one the dimension is `space`.
fn dimension(input: &mut Cursor) -> DimensionKeyword {
    let known = DIMENSIONS.iter().find(|(word, _)| input.word(word).is_some());
    known.map_or(DimensionKeyword::Space, |&(_, dimension)| dimension)
}

fn item(
    docs: Vec<Attribute>,
    input: &mut Cursor,
    def: &mut ChainSyntax,
    diagnostics: &mut Diagnostics,
) {
    if let Some((at, message)) = field_of_path(input) {
        return diagnostics.error_over(at, message);
    }
    if begins_with_path(input) {
        return content::route(input, &mut def.content, diagnostics);
    }
    if part::keyword(input, diagnostics) {
        let after_route = !def.content.routes.is_empty();
        match part::part(docs, after_route, input, diagnostics) {
            Ok(part) => def.parts.push(part),
            Err(error) => content::report_and_skip(error, input, &mut def.content, diagnostics),
        }
        return;
    }
    let refused = end_block(input).or_else(|| route_setting(input));
    if let Some((at, message)) = refused {
        diagnostics.error(at, message);
    } else if let Some((word, at)) = content::block_word(input, diagnostics) {
        let after_route = !def.content.routes.is_empty();
        content::block((word, at), after_route, input, &mut def.content, diagnostics);
    } else if input.word("param").is_some() || misspelt_parameter(input, diagnostics) {
        match parameter(input, diagnostics) {
            Ok(parameter) => def.parameters.push(parameter),
            Err(error) => content::report_and_skip(error, input, &mut def.content, diagnostics),
        }
    } else if let Some(name) = setting(input) {
        def.settings.push(field::field(name, input, diagnostics));
    } else if lookahead::is_route(input) {
        content::route(input, &mut def.content, diagnostics);
    } else {
        let items = "`gravity`, `method`, `results`, `answers`, `param`, `body`, `part`, the routes, `hinge`, \
                     `load` and `spring`";
        content::unknown(items, input, &mut def.content, diagnostics);
    }
}

/// Reads `element.field = …;`, which is an error.
fn field_of_path(input: &mut Cursor) -> Option<(SpanRange, String)> {
    let mut ahead = *input;
    let mut path = path_of_several(&mut ahead)?;
    if !ahead.peek_punct('=') || ahead.peek_pair('=', '>') {
        return None;
    }
    let extent = path.extent();
    let field = path.names.pop()?;
    let message = format!(
        "a field is in the block of its element: for a hinge write `hinge {path} {{ {field} = …; }}`"
    );
    ahead.skip_statement();
    *input = ahead;
    Some((extent, message))
}

/// Reads a block for `ground` or for a moving end, which is an error.
fn end_block(input: &mut Cursor) -> Option<(Span, &'static str)> {
    let mut ahead = *input;
    let at = input.next_span();
    let message = if ahead.word("ground").is_some() {
        "write the position of the ground on the route: `ground at [x, y, z] turned …`"
    } else {
        ahead.word("moving")?;
        ahead.ident()?;
        route_item::MOVING_HAS_NO_PLACE
    };
    ahead.group(Delimiter::Brace)?;
    *input = ahead;
    Some((at, message))
}

/// Reads `word =` before the route, which is an error.
fn route_setting(input: &mut Cursor) -> Option<(Span, &'static str)> {
    let mut ahead = *input;
    let at = input.next_span();
    ahead.ident().filter(|word| word != "moving" && !ahead.peek_pair('=', '>'))?;
    ahead.punct('=').filter(|_| lookahead::is_clearly_route(&ahead))?;
    *input = ahead;
    Some((at, "the route has no name: write only `ground -> …`"))
}

/// Reads and reports a misspelt `param`.
fn misspelt_parameter(input: &mut Cursor, diagnostics: &mut Diagnostics) -> bool {
    let mut ahead = *input;
    let Some(word) = ahead.ident() else { return false };
    let mut value = ahead;
    let meant = other_programs::keyword(&word).or_else(|| nearest(&word.to_string(), ["param"]));
    let is_parameter = meant == Some("param")
        && value.ident().is_some()
        && (value.group(Delimiter::Bracket).is_some() || value.peek_punct('='));
    if is_parameter {
        let message = format!("unknown item `{word}`; did you mean `param`?");
        diagnostics.error(word.span(), message);
        *input = ahead;
    }
    is_parameter
}

/// Reads the name of a setting: its keyword, or any word that `=` follows.
fn setting(input: &mut Cursor) -> Option<Ident> {
    let mut ahead = *input;
    // An end with a wrong sign is read with its route.
    let name = ahead.ident().filter(|name| name != "moving")?;
    let is_field = ahead.peek_punct('=') && !ahead.peek_pair('=', '>');
    if !is_field && SETTINGS.iter().all(|setting| name != setting) {
        return None;
    }
    *input = ahead;
    Some(name)
}

fn parameter(input: &mut Cursor, diagnostics: &mut Diagnostics) -> Result<ParameterSyntax> {
    let name = input.ident().ok_or_else(|| input.unexpected("the parameter's name"))?;
    if input.peek_punct(';') {
        let message = format!("a parameter needs a default with its unit: `param {name} = 1 kg;`");
        diagnostics.error(name.span(), message);
        input.punct(';');
        return Ok(ParameterSyntax { field: FieldSyntax { name, value: None }, repetitions: None });
    }
    if input.peek_punct(',') {
        let message = "a `param` is one parameter: write a `param` for each";
        return Err(Error::new(input.next_span(), message));
    }
    let mut after = *input;
    let repetitions = match input.group(Delimiter::Bracket) {
        // Other brackets are an error.
        None if after.group(Delimiter::Parenthesis).is_some() && after.peek_punct('=') => {
            diagnostics.push(input.unexpected("`=`"));
            *input = after;
            Some(UNKNOWN_COUNT)
        }
        None => None,
        Some((mut inside, _)) => {
            let times = number::count("a parameter count", &mut inside).flatten();
            let times = times.and_then(|times| inside.check_empty("`]`").map(|()| times));
            Some(times.unwrap_or_else(|error| {
                diagnostics.push(error);
                UNKNOWN_COUNT
            }))
        }
    };
    Ok(ParameterSyntax { field: field::field(name, input, diagnostics), repetitions })
}
