//! Blocks, routes and unknown items of a chain or of a part.

use proc_macro2::Span;
use syn::Error;

use super::cursor::Cursor;
use super::field::{self, Content};
use super::lookahead::{ITEMS, SETTINGS};
use super::path::block_head;
use super::route_tree::ContentSyntax;
use super::tree::{BlockKeyword, BlockSyntax};
use super::{lookahead, other_programs, recover, route};
use crate::diag::{Diagnostics, nearest};

/// The keywords of blocks.
pub(super) const BLOCKS: &[(&str, BlockKeyword)] = &[
    ("body", BlockKeyword::Body),
    ("hinge", BlockKeyword::Hinge),
    ("load", BlockKeyword::Load),
    ("spring", BlockKeyword::Spring),
];

/// Reads the keyword of a block; a misspelt one is reported.
pub(super) fn block_word(
    input: &mut Cursor,
    diagnostics: &mut Diagnostics,
) -> Option<(BlockKeyword, Span)> {
    let known = BLOCKS.iter().find_map(|&(word, block)| Some((block, input.word(word)?)));
    known.or_else(|| misspelt_block(input, diagnostics))
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
    block_head(&mut names, &mut Diagnostics::default()).ok()?;
    diagnostics.error(word.span(), format!("unknown item `{word}`; did you mean `{near}`?"));
    *input = ahead;
    Some((block, word.span()))
}

/// Parses the rest of a block after its keyword.
pub(super) fn block(
    (word, at): (BlockKeyword, Span),
    after_route: bool,
    input: &mut Cursor,
    def: &mut ContentSyntax,
    diagnostics: &mut Diagnostics,
) {
    match block_head(input, diagnostics) {
        Ok((names, inside)) => {
            let Content { fields, points, complete } = field::content(inside, diagnostics);
            let routes_before = def.routes.len();
            def.blocks.push(BlockSyntax {
                word,
                at,
                names,
                fields,
                points,
                complete,
                after_route,
                routes_before,
            });
        }
        Err(error) => {
            report_and_skip(error, input, def, diagnostics);
            // Without braces the fields stand alone.
            while begins_stray_field(input) {
                input.skip_statement();
            }
        }
    }
}

/// Whether `name = value` or `point name = value` is next that is not a setting.
fn begins_stray_field(input: &Cursor) -> bool {
    let is_setting = input.peek_ident().is_some_and(|word| SETTINGS.iter().any(|it| word == it));
    let is_arrow = {
        let mut ahead = *input;
        ahead.ident();
        ahead.peek_pair('=', '>')
    };
    lookahead::begins_field(input) && !is_setting && !is_arrow
}

/// Parses a route.
pub(super) fn route(input: &mut Cursor, def: &mut ContentSyntax, diagnostics: &mut Diagnostics) {
    def.routes.push(route::route(input, diagnostics));
}

/// Reports an item that begins with no keyword; `items` are those that can be here.
pub(super) fn unknown(
    items: &str,
    input: &mut Cursor,
    def: &mut ContentSyntax,
    diagnostics: &mut Diagnostics,
) {
    let start = *input;
    let Some(word) = input.peek_ident() else {
        // This may be the rest of the route.
        if let Some(route) = def.routes.last_mut() {
            if input.pair('-', '>').is_some() {
                *input = start;
                diagnostics.push(input.unexpected("an item"));
                return recover::rest(input, route);
            }
            route.complete = false;
        }
        return report_and_skip(input.unexpected("an item"), input, def, diagnostics);
    };
    if let Some(message) = other_programs::item(&word) {
        return report_and_skip(Error::new(word.span(), message), input, def, diagnostics);
    }
    if word == "moving" {
        let message =
            "a moving end begins or ends a route: write `moving name -> …` or `… -> moving name`";
        return report_and_skip(Error::new(word.span(), message), input, def, diagnostics);
    }
    if word == "part" {
        let message = "write `part Name(parameter, …) { … }`, or `part Name { … }`";
        return report_and_skip(Error::new(word.span(), message), input, def, diagnostics);
    }
    if let Some(keyword) = lookahead::missing_keyword(input) {
        let message = format!("write the keyword: `{keyword} {word}`");
        return report_and_skip(Error::new(word.span(), message), input, def, diagnostics);
    }
    let known = ITEMS.iter().chain(SETTINGS).copied().filter(|known| word != known);
    let near = other_programs::keyword(&word).or_else(|| nearest(&word.to_string(), known));
    let hint = near
        .map_or_else(|| format!("the items are {items}"), |near| format!("did you mean `{near}`?"));
    let message = format!("unknown item `{word}`; {hint}");
    report_and_skip(Error::new(word.span(), message), input, def, diagnostics);
}

/// Reports an item that is not readable and skips it.
pub(super) fn report_and_skip(
    error: Error,
    input: &mut Cursor,
    def: &mut ContentSyntax,
    diagnostics: &mut Diagnostics,
) {
    diagnostics.push(error);
    def.complete = false;
    input.skip_statement();
}
