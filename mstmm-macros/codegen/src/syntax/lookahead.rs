//! Lookahead: what begins at the next token.

use proc_macro2::{Delimiter, Ident};

use super::cursor::Cursor;
use super::other_programs::TURNED;
use crate::diag::nearest;

/// The words that an item can begin with.
pub(super) const ITEMS: &[&str] = &["param", "body", "hinge", "load", "spring", "ground", "moving"];
/// Keywords that may also be names: they begin an item only if a name follows.
const ALSO_NAMES: &[&str] = &["load", "spring", "moving"];

/// The keywords of settings.
pub const SETTINGS: &[&str] = &["gravity", "method", "results", "answers"];
/// The kinds of hinges, with which a route of a single hinge begins.
pub(super) const HINGES: &[&str] = &[
    "weld",
    "pin",
    "slider",
    "screw",
    "cylindrical",
    "universal",
    "gimbal",
    "ball",
    "planar",
    "floating",
    "elastic",
];

/// The forms of an orientation.
pub(super) const ORIENTATIONS: &[&str] = &["rpy", "quaternion"];

/// Returns the keyword that the next word means after a value, if it is a word of other programs or misspelt: `turned`
/// before an orientation, `about` before a reference point.
pub(super) fn meant_after_value(input: &Cursor) -> Option<&'static str> {
    let mut ahead = *input;
    let word = ahead.ident()?;
    if TURNED.iter().any(|other| word == other) {
        return Some("turned").filter(|_| !ahead.peek_punct('='));
    }
    let is_point = ahead.peek_ident().is_some_and(|word| word == "input" || word == "com");
    let keyword = match is_orientation(&ahead) {
        true => "turned",
        false if is_point => "about",
        false => return None,
    };
    nearest(&word.to_string(), [keyword]).filter(|near| word != near)
}

/// Returns whether an orientation is next that is an angle in digits or a form.
pub(super) fn is_orientation(input: &Cursor) -> bool {
    let mut ahead = *input;
    if let Some(form) = ahead.ident() {
        let is_known = ORIENTATIONS.iter().any(|known| form == known);
        return is_known && ahead.peek_group(Delimiter::Parenthesis);
    }
    if !ahead.peek_pair('-', '>') {
        ahead.punct('-');
    }
    ahead.literal().is_some()
}

/// Returns whether the next word can only be the beginning of an item.
pub(super) fn begins_item(input: &Cursor) -> bool {
    begins_block(input) || input.peek_ident().is_some_and(|word| word == "ground")
}

/// Returns whether a part is next: `part Name (` or `part Name {`.
pub(super) fn begins_part(input: &Cursor) -> bool {
    let mut ahead = *input;
    ahead.word("part").is_some() && begins_part_head(&ahead)
}

/// Returns whether the head of a part is next, without its keyword.
pub(super) fn begins_part_head(input: &Cursor) -> bool {
    let mut ahead = *input;
    ahead.ident().is_some()
        && (ahead.peek_group(Delimiter::Parenthesis) || ahead.peek_group(Delimiter::Brace))
}

/// Returns whether the next word begins an item other than the route: a name or a block follows.
pub(super) fn begins_block(input: &Cursor) -> bool {
    let mut ahead = *input;
    begins_part(input)
        || ahead.ident().is_some_and(|word| {
            let may_be_name = ALSO_NAMES.iter().any(|name| word == name);
            let block = !may_be_name && ahead.peek_group(Delimiter::Brace);
            ITEMS.iter().any(|item| word == item)
                && word != "ground"
                && (block || ahead.ident().is_some())
        })
}

/// The name of a point, if one is next: `point name`.
pub(super) fn point(input: &mut Cursor) -> Option<Ident> {
    let mut ahead = *input;
    ahead.word("point")?;
    let name = ahead.ident()?;
    *input = ahead;
    Some(name)
}

/// Whether `name =` is next, or `point name =`.
pub(super) fn begins_field(input: &Cursor) -> bool {
    let mut ahead = *input;
    point(&mut ahead).or_else(|| ahead.ident()).is_some() && ahead.peek_punct('=')
}

/// Reads the name of a route item, if it has one.
pub(super) fn name(input: &mut Cursor) -> Option<Ident> {
    if begins_block(input) { None } else { input.ident() }
}

/// Returns whether the statement looks like a route rather than like a misspelt item: by its first
/// word, by an arrow, or because it is a single body or hinge.
pub(super) fn is_route(input: &Cursor) -> bool {
    let mut ahead = *input;
    let Some(word) = ahead.ident() else { return false };
    let is_hinge = HINGES.iter().any(|kind| word == kind);
    let is_item = is_hinge || word.to_string().starts_with(char::is_uppercase);
    ahead.group(Delimiter::Parenthesis);
    let is_named = name(&mut ahead).is_some();
    let ends = ahead.peek_punct(';') || ahead.is_empty() || begins_block(&ahead);
    // A wrong sign, or none, before the next item; or a word too many before the end.
    let goes_on =
        is_hinge && is_named && !ahead.peek_group(Delimiter::Brace) && !ahead.peek_punct('=');
    let goes_on = goes_on || (is_named && ahead.ident().is_some() && ahead.peek_punct(';'));
    (is_item && (ends || goes_on)) || is_clearly_route(input)
}

/// Returns whether the statement begins with a keyword of the route, or has an arrow.
pub(super) fn is_clearly_route(input: &Cursor) -> bool {
    let mut ahead = *input;
    let Some(first) = ahead.ident() else { return false };
    // Braces in a wrong place, unless they have the fields of a body type without its keyword.
    if let Some((inside, _)) = ahead.group(Delimiter::Brace)
        && first.to_string().starts_with(char::is_uppercase)
        && begins_field(&inside)
    {
        return false;
    }
    if first == "moving" {
        // A keyword as the name of an end is reported where the name is checked.
        ahead.word("ground");
    }
    first == "ground" || first == "repeat" || has_arrow(ahead)
}

/// Returns the keyword that is missing before the name of a type or a part, if only its braces follow: `Name { … }`.
pub(super) fn missing_keyword(input: &Cursor) -> Option<&'static str> {
    let mut ahead = *input;
    ahead.ident().filter(|word| word.to_string().starts_with(char::is_uppercase))?;
    let has_parameters = ahead.group(Delimiter::Parenthesis).is_some();
    let (inside, _) = ahead.group(Delimiter::Brace)?;
    Some(if !has_parameters && begins_field(&inside) { "body" } else { "part" })
}

/// Returns whether an end of a route is next that no arrow follows: the last item of the route.
pub(super) fn is_last_end(input: &Cursor) -> bool {
    let mut ahead = *input;
    let is_end = ahead.word("ground").or_else(|| ahead.word("moving")).is_some();
    let is_block = {
        let mut after_name = ahead;
        after_name.ident();
        ahead.peek_group(Delimiter::Brace) || after_name.peek_group(Delimiter::Brace)
    };
    is_end && !is_block && !has_arrow(ahead)
}

/// Returns whether the rest of a statement has an arrow.
pub(super) fn has_arrow(mut rest: Cursor) -> bool {
    let pairs = [('-', '>'), ('=', '>'), ('<', '-')];
    let is_arrow = |at: &Cursor| pairs.iter().any(|&(first, second)| at.peek_pair(first, second));
    while !rest.is_empty() && !rest.peek_punct(';') && !begins_item(&rest) {
        if is_arrow(&rest) {
            return true;
        }
        if rest.group(Delimiter::Brace).is_some() {
            return is_arrow(&rest);
        }
        rest.any();
    }
    false
}
