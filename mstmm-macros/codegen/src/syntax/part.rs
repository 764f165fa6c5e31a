//! `part Name(parameter, …) { … }`

use proc_macro2::{Delimiter, Ident};
use syn::{Attribute, Error, Result};

use super::cursor::Cursor;
use super::path::begins_with_path;
use super::route_tree::{ContentSyntax, PartSyntax};
use super::tree::BlockKeyword;
use super::{attribute, content, lookahead};
use crate::diag::{Diagnostics, nearest};

/// The fields that only a body type has.
const OF_TYPES: &[&str] = &["mass", "com", "inertia", "output", "shape"];

/// Reads the keyword `part`, if it begins an item; a misspelt one is reported.
pub(super) fn keyword(input: &mut Cursor, diagnostics: &mut Diagnostics) -> bool {
    if lookahead::begins_part(input) {
        return input.word("part").is_some();
    }
    let mut ahead = *input;
    let Some(word) = ahead.ident() else { return false };
    let mut after_name = ahead;
    let is_type = after_name.ident().is_some_and(|name| begins_type(&name));
    let has_content = after_name.group(Delimiter::Parenthesis).is_some()
        && after_name.peek_group(Delimiter::Brace);
    let words = content::BLOCKS.iter().map(|(word, _)| *word).chain(["param", "part"]);
    if !is_type || !has_content || nearest(&word.to_string(), words) != Some("part") {
        return false;
    }
    diagnostics.error(word.span(), format!("unknown item `{word}`; did you mean `part`?"));
    *input = ahead;
    true
}

fn begins_type(name: &Ident) -> bool {
    name.to_string().starts_with(char::is_uppercase)
}

/// Parses the rest of a part after its keyword.
pub(super) fn part(
    docs: Vec<Attribute>,
    after_route: bool,
    input: &mut Cursor,
    diagnostics: &mut Diagnostics,
) -> Result<PartSyntax> {
    let name = input.ident().ok_or_else(|| input.unexpected("a name"))?;
    let parameters = match input.group(Delimiter::Parenthesis) {
        Some((inside, _)) => parameters(inside)?,
        None => Vec::new(),
    };
    let (mut inside, _) = input.group(Delimiter::Brace).ok_or_else(|| input.unexpected("`{`"))?;
    let mut content = ContentSyntax::empty();
    while !inside.is_empty() {
        if let Err(error) = attribute::docs(&mut inside) {
            diagnostics.push(error);
        }
        if !inside.is_empty() {
            piece(&mut inside, &mut content, diagnostics);
        }
    }
    Ok(PartSyntax { docs, name, parameters, content, after_route })
}

/// The names of parameters in parentheses.
fn parameters(mut inside: Cursor) -> Result<Vec<Ident>> {
    let mut parameters = Vec::new();
    while !inside.is_empty() {
        parameters.push(inside.ident().ok_or_else(|| inside.unexpected("a name"))?);
        if inside.punct(',').is_none() {
            if inside.peek_punct('=') || inside.peek_punct(':') {
                let message = "a parameter of a part is a number without a default: write its \
                               name only";
                return Err(Error::new(inside.next_span(), message));
            }
            inside.check_empty("`,`")?;
        }
    }
    Ok(parameters)
}

/// Parses an item of a part.
fn piece(input: &mut Cursor, def: &mut ContentSyntax, diagnostics: &mut Diagnostics) {
    let at = input.next_span();
    if input.pair('-', '>').is_some() {
        diagnostics.error(at, "a part begins with a hinge or a body: remove `->`");
        return;
    }
    if begins_with_path(input) {
        return content::route(input, def, diagnostics);
    }
    if let Some(message) = refused(input) {
        return content::report_and_skip(Error::new(at, message), input, def, diagnostics);
    }
    if let Some((word, at)) = content::block_word(input, diagnostics) {
        let blocks = def.blocks.len();
        content::block((word, at), true, input, def, diagnostics);
        let has_route = !def.routes.is_empty();
        for block in &mut def.blocks[blocks..] {
            let of_type = |name: &Ident| OF_TYPES.iter().any(|known| name == known);
            let describes_type =
                !block.points.is_empty() || block.fields.iter().any(|field| of_type(&field.name));
            // After a route it may be the start of a floating body, which is an error.
            block.after_route = block.word != BlockKeyword::Body || (has_route && !describes_type);
        }
    } else if lookahead::is_route(input) {
        content::route(input, def, diagnostics);
    } else {
        let items = "`body`, the routes, `hinge`, `load` and `spring`";
        content::unknown(items, input, def, diagnostics);
    }
}

/// Returns the message for an item that is not written in parts.
fn refused(input: &Cursor) -> Option<String> {
    if lookahead::begins_part(input) {
        return Some("write a `part` outside of other parts, and set it here by its name".into());
    }
    let mut ahead = *input;
    let word = ahead.ident()?;
    if word == "param" {
        return Some(
            "write `param` outside of parts, and pass it as an argument of the part".into(),
        );
    }
    let is_setting = lookahead::SETTINGS.iter().any(|setting| word == setting);
    let is_name = ['-', '='].iter().any(|&first| ahead.peek_pair(first, '>'));
    (is_setting && !is_name)
        .then(|| format!("write `{word}` outside of parts: it is a setting of the whole chain"))
}
