//! `chain Name { … }`

use proc_macro2::{Delimiter, Ident, Span};
use syn::{Error, Result, Visibility};

use super::cursor::Cursor;
use super::field::Content;
use super::lookahead::ITEMS;
use super::tree::{BlockKeyword, BlockSyntax, ChainSyntax, DimensionKeyword, ParameterSyntax};
use super::{
    attribute, branch, field, lookahead, number, other_programs, recover, route, route_item,
};
use crate::diag::{Diagnostics, did_you_mean, nearest};

/// The keywords of blocks.
pub(super) const BLOCKS: &[(&str, BlockKeyword)] = &[
    ("body", BlockKeyword::Body),
    ("hinge", BlockKeyword::Hinge),
    ("load", BlockKeyword::Load),
    ("spring", BlockKeyword::Spring),
];
/// The keywords that may precede `chain`.
pub(super) const DIMENSIONS: &[(&str, DimensionKeyword)] = &[
    ("space", DimensionKeyword::Space),
    ("plane", DimensionKeyword::Plane),
    ("line", DimensionKeyword::Line),
];
/// The keywords of settings.
pub const SETTINGS: &[&str] = &["gravity", "method", "results", "answers"];

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
        if let Err(error) = attribute::docs(&mut inside) {
            diagnostics.push(error);
        }
        if !inside.is_empty() {
            item(&mut inside, &mut def, diagnostics);
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
            let Some(group) = group else { return Err(error) };
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
        blocks: Vec::new(),
        route: None,
        complete: true,
    };
    Ok((def, inside))
}

/// Skips a wrong word if the head of the chain has no other error. Returns whether the word
/// replaces `chain`; otherwise it precedes `chain`.
fn misspelt_chain(input: &mut Cursor) -> Option<bool> {
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
    let hint = did_you_mean(&word, DIMENSIONS.iter().map(|(known, _)| *known));
    let message = format!("expected `space`, `plane`, `line` or nothing before `chain`{hint}");
    Error::new(input.next_span(), message)
}

/// Reads the keyword before `chain`; without one the dimension is `space`.
fn dimension(input: &mut Cursor) -> DimensionKeyword {
    let known = DIMENSIONS.iter().find(|(word, _)| input.word(word).is_some());
    known.map_or(DimensionKeyword::Space, |&(_, dimension)| dimension)
}

fn item(input: &mut Cursor, def: &mut ChainSyntax, diagnostics: &mut Diagnostics) {
    let start = *input;
    let refused = end_block(input).or_else(|| route_setting(input));
    if let Some((at, message)) = refused {
        diagnostics.error(at, message);
    } else if let Some((word, at)) =
        block_word(input).or_else(|| misspelt_block(input, diagnostics))
    {
        block(word, at, input, def, diagnostics);
    } else if input.word("param").is_some() || misspelt_parameter(input, diagnostics) {
        match parameter(input, diagnostics) {
            Ok(parameter) => def.parameters.push(parameter),
            Err(error) => report_and_skip(error, input, def, diagnostics),
        }
    } else if let Some(name) = setting(input) {
        def.settings.push(field::field(name, input, diagnostics));
    } else if lookahead::is_route(input) {
        let route = route::route(input, diagnostics);
        match def.route {
            Some(ref mut first) => first.add(start.next_span(), route),
            None => def.route = Some(route),
        }
    } else {
        unknown(input, def, diagnostics);
    }
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
    ahead.ident().filter(|_| !ahead.peek_pair('=', '>'))?;
    ahead.punct('=').filter(|_| lookahead::is_clearly_route(&ahead))?;
    *input = ahead;
    Some((at, "the route has no name: write only `ground -> …`"))
}

/// Reads the keyword of a block.
fn block_word(input: &mut Cursor) -> Option<(BlockKeyword, Span)> {
    BLOCKS.iter().find_map(|&(word, block)| Some((block, input.word(word)?)))
}

/// Reads and reports a misspelt keyword of a block.
fn misspelt_block(
    input: &mut Cursor,
    diagnostics: &mut Diagnostics,
) -> Option<(BlockKeyword, Span)> {
    let mut ahead = *input;
    let word = ahead.ident()?;
    let words = BLOCKS.iter().map(|&(word, _)| word);
    let near = other_programs::keyword(&word)
        .or_else(|| nearest(&word.to_string(), words.chain(["param"])))?;
    let &(_, block) = BLOCKS.iter().find(|(word, _)| *word == near)?;
    let mut names = ahead;
    block_head(&mut names).ok()?;
    diagnostics.error(word.span(), format!("unknown item `{word}`; did you mean `{near}`?"));
    *input = ahead;
    Some((block, word.span()))
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
    let name = ahead.ident()?;
    let is_field = ahead.peek_punct('=') && !ahead.peek_pair('=', '>');
    if !is_field && SETTINGS.iter().all(|setting| name != setting) {
        return None;
    }
    *input = ahead;
    Some(name)
}

fn parameter(input: &mut Cursor, diagnostics: &mut Diagnostics) -> Result<ParameterSyntax> {
    let name = input.ident().ok_or_else(|| input.unexpected("the parameter's name"))?;
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

fn block(
    word: BlockKeyword,
    at: Span,
    input: &mut Cursor,
    def: &mut ChainSyntax,
    diagnostics: &mut Diagnostics,
) {
    let after_route = def.route.is_some();
    match block_head(input) {
        Ok((names, inside)) => {
            let Content { fields, points, complete } = field::content(inside, diagnostics);
            def.blocks.push(BlockSyntax { word, at, names, fields, points, complete, after_route });
        }
        Err(error) => report_and_skip(error, input, def, diagnostics),
    }
}

fn block_head<'a>(input: &mut Cursor<'a>) -> Result<(Vec<Ident>, Cursor<'a>)> {
    let mut names = Vec::new();
    loop {
        names.push(input.ident().ok_or_else(|| input.unexpected("a name"))?);
        if input.punct(',').is_none() {
            break;
        }
    }
    let (inside, _) = input.group(Delimiter::Brace).ok_or_else(|| input.unexpected("`{`"))?;
    Ok((names, inside))
}

/// Reports an item that begins with no keyword.
fn unknown(input: &mut Cursor, def: &mut ChainSyntax, diagnostics: &mut Diagnostics) {
    let start = *input;
    let Some(word) = input.peek_ident() else {
        // This may be the rest of the route.
        if let Some(route) = &mut def.route {
            if input.pair('-', '>').is_some() {
                *input = start;
                diagnostics.push(input.unexpected("an item"));
                return recover::rest(input, route);
            }
            route.complete = false;
        }
        return report_and_skip(input.unexpected("an item"), input, def, diagnostics);
    };
    if let Some(message) = branch::item(&word).or_else(|| other_programs::item(&word)) {
        return report_and_skip(Error::new(word.span(), message), input, def, diagnostics);
    }
    let near = other_programs::keyword(&word)
        .or_else(|| nearest(&word.to_string(), ITEMS.iter().chain(SETTINGS).copied()));
    let hint = near.map_or_else(
        || {
            "the items are `gravity`, `method`, `results`, `answers`, `param`, `body`, the route, \
            `hinge`, `load` and `spring`"
                .to_owned()
        },
        |near| format!("did you mean `{near}`?"),
    );
    let message = format!("unknown item `{word}`; {hint}");
    report_and_skip(Error::new(word.span(), message), input, def, diagnostics);
}

/// Reports an item that is not readable and skips it.
fn report_and_skip(
    error: Error,
    input: &mut Cursor,
    def: &mut ChainSyntax,
    diagnostics: &mut Diagnostics,
) {
    diagnostics.push(error);
    def.complete = false;
    input.skip_statement();
}
