//! Paths: names joined by points, also in the heads of blocks.

use proc_macro2::{Delimiter, Ident};
use syn::{Error, Result};

use super::cursor::Cursor;
use super::lookahead::begins_field;
use super::tree::PathSyntax;
use crate::diag::Diagnostics;

/// Reads a path of at least two names. A path of at least three that begins with `last` is of the
/// previous repetition.
pub(super) fn path_of_several(input: &mut Cursor) -> Option<PathSyntax> {
    let mut ahead = *input;
    let mut path = path(&mut ahead)?;
    if path.names.len() < 2 {
        return None;
    }
    *input = ahead;
    if path.names.len() > 2 && path.names[0] == "last" {
        path.last = Some(path.names.remove(0).span());
    }
    Some(path)
}

/// Reads a path: names joined by points.
pub(super) fn path(input: &mut Cursor) -> Option<PathSyntax> {
    let mut names = vec![input.ident()?];
    loop {
        let mut ahead = *input;
        let next = ahead.punct('.').and_then(|_| ahead.ident());
        let Some(next) = next else { return Some(PathSyntax { last: None, names }) };
        names.push(next);
        *input = ahead;
    }
}

/// Reads the paths in the head of a block, up to its brace.
fn paths(input: &mut Cursor) -> Result<Vec<PathSyntax>> {
    let mut paths = Vec::new();
    loop {
        paths.push(path(input).ok_or_else(|| input.unexpected("a name"))?);
        if input.punct(',').is_none() {
            return Ok(paths);
        }
    }
}

/// Parses the names of a block and enters its braces. Fields in other brackets are reported and entered.
pub(super) fn block_head<'a>(
    input: &mut Cursor<'a>,
    diagnostics: &mut Diagnostics,
) -> Result<(Vec<PathSyntax>, Cursor<'a>)> {
    let names = paths(input)?;
    for other in [Delimiter::Bracket, Delimiter::Parenthesis] {
        let mut ahead = *input;
        if let Some((inside, _)) = ahead.group(other)
            && begins_field(&inside)
        {
            diagnostics.push(input.unexpected("`{`"));
            *input = ahead;
            return Ok((names, inside));
        }
    }
    if input.peek_group(Delimiter::Bracket) {
        let message = "a block applies to each repetition: remove the index";
        return Err(Error::new(input.next_span(), message));
    }
    let (inside, _) = input.group(Delimiter::Brace).ok_or_else(|| input.unexpected("`{`"))?;
    Ok((names, inside))
}

/// Returns whether a path is next: a name and a point.
pub(super) fn begins_with_path(input: &Cursor) -> bool {
    let mut ahead = *input;
    ahead.ident().is_some_and(|_: Ident| ahead.peek_punct('.'))
}
