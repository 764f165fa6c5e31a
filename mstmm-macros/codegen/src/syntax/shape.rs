//! Shapes of bodies: `box([a, b, c] m) at [x, y, z] m turned rpy(…)`.

use proc_macro2::{Delimiter, Ident, Literal};
use syn::{Error, Lit, Result};

use super::cursor::Cursor;
use super::tree::{ShapeArgument, ShapeSyntax, ShapesSyntax, SpanRange};
use super::value;

/// The kinds of shapes.
pub const SHAPES: &[&str] = &["box", "cylinder", "capsule", "sphere", "mesh"];

const EXPECTED: &str = "a shape, such as `sphere(radius = 5 cm)`";
const BRACKETS: &str = "write several shapes in brackets: `[box(…), sphere(…)]`";

/// Returns whether a shape or a list of shapes is next.
pub(super) fn is_next(input: &Cursor) -> bool {
    let mut ahead = *input;
    let inside = ahead.group(Delimiter::Bracket).map(|(inside, _)| inside);
    kind(inside.as_ref().unwrap_or(input)).is_some_and(|word| SHAPES.iter().any(|it| word == it))
}

/// Returns the word of what may be a shape: `word(…)`.
fn kind(input: &Cursor) -> Option<Ident> {
    let mut ahead = *input;
    ahead.ident().filter(|_| ahead.peek_group(Delimiter::Parenthesis))
}

/// Parses a shape, or several in brackets.
pub(super) fn shapes(input: &mut Cursor) -> Result<ShapesSyntax> {
    let Some((mut inside, extent)) = input.group(Delimiter::Bracket) else {
        let shape = shape(input)?;
        let mut ahead = *input;
        if let Some(at) = ahead.punct(',').filter(|_| kind(&ahead).is_some()) {
            return Err(Error::new(at, BRACKETS));
        }
        let extent = shape.extent;
        return Ok(ShapesSyntax { shapes: vec![shape], extent });
    };
    let mut shapes = vec![shape(&mut inside)?];
    while inside.punct(',').is_some() && !inside.is_empty() {
        shapes.push(shape(&mut inside)?);
    }
    inside.check_empty("`,`")?;
    Ok(ShapesSyntax { shapes, extent })
}

fn shape(input: &mut Cursor) -> Result<ShapeSyntax> {
    let start = *input;
    let word = input.ident().ok_or_else(|| input.unexpected(EXPECTED))?;
    if !input.peek_group(Delimiter::Parenthesis) && SHAPES.iter().all(|known| word != known) {
        return Err(start.unexpected(EXPECTED));
    }
    let group = input.group(Delimiter::Parenthesis);
    let (inside, parentheses) = group.ok_or_else(|| input.unexpected("`(`"))?;
    let arguments = arguments(inside)?;
    let position = input.word("at").map(|_| value::position(input)).transpose()?;
    let orientation = value::turned(input)?;
    let extent = SpanRange::token(word.span()).to(input.last());
    Ok(ShapeSyntax { word, arguments, parentheses, position, orientation, extent })
}

/// `name = value, …`
fn arguments(mut inside: Cursor) -> Result<Vec<(Option<Ident>, ShapeArgument)>> {
    let mut arguments = Vec::new();
    while !inside.is_empty() {
        let mut ahead = inside;
        let name = ahead.ident().filter(|_| ahead.punct('=').is_some());
        if name.is_some() {
            inside = ahead;
        }
        arguments.push((name, argument(&mut inside)?));
        if inside.peek_punct('.') {
            return Err(Error::new(inside.last().first, "write the name of a file in quotes"));
        }
        if inside.punct(',').is_none() {
            inside.check_empty("`,`")?;
        }
    }
    Ok(arguments)
}

fn argument(inside: &mut Cursor) -> Result<ShapeArgument> {
    let mut ahead = *inside;
    let Some(text) = ahead.literal().and_then(text) else {
        return value::position(inside).map(ShapeArgument::Value);
    };
    *inside = ahead;
    Ok(ShapeArgument::Text(text, inside.last()))
}

/// Returns the content of a literal in quotes.
fn text(literal: Literal) -> Option<String> {
    match Lit::new(literal) {
        Lit::Str(text) => Some(text.value()),
        _ => None,
    }
}
