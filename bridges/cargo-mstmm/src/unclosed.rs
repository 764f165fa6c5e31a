//! Finds brackets, strings and comments that are not closed: the tokenizer does not tell the place.

use std::ops::Range;

/// Returns the place of the first bracket without a partner, or of the string or comment that does not end, and the
/// message.
#[must_use]
pub fn unclosed(text: &str) -> Option<(Range<usize>, String)> {
    let mut open: Vec<(usize, char)> = Vec::new();
    let mut at = 0;
    while let Some(letter) = text[at..].chars().next() {
        let rest = &text[at..];
        let length = match letter {
            '/' if rest.starts_with("//") => rest.find('\n').unwrap_or(rest.len()),
            '/' if rest.starts_with("/*") => match comment(rest) {
                Some(length) => length,
                None => return Some((at..at + 2, "this comment is not closed".into())),
            },
            '"' => match string(rest) {
                Some(length) => length,
                None => return Some((at..at + 1, "this string is not closed".into())),
            },
            _ => letter.len_utf8(),
        };
        match letter {
            '(' | '[' | '{' => open.push((at, letter)),
            ')' | ']' | '}' => match open.pop() {
                Some((_, left)) if partner(left) == letter => {}
                Some((_, left)) => {
                    let expected = partner(left);
                    return Some((at..at + 1, format!("expected `{expected}`, found `{letter}`")));
                }
                None => return Some((at..at + 1, format!("`{letter}` closes no bracket"))),
            },
            _ => {}
        }
        at += length;
    }
    let (at, left) = open.pop()?;
    Some((at..at + 1, format!("`{left}` is not closed: expected `{}`", partner(left))))
}

fn partner(left: char) -> char {
    match left {
        '(' => ')',
        '[' => ']',
        _ => '}',
    }
}

/// Returns the length of the string literal at the start of a text.
fn string(text: &str) -> Option<usize> {
    let mut letters = text.char_indices().skip(1);
    while let Some((at, letter)) = letters.next() {
        match letter {
            '\\' => drop(letters.next()),
            '"' => return Some(at + 1),
            _ => {}
        }
    }
    None
}

/// Returns the length of the comment at the start of a text; comments nest.
fn comment(text: &str) -> Option<usize> {
    let (mut depth, mut at) = (0_usize, 0);
    while let Some(letter) = text[at..].chars().next() {
        let (step, change) = match &text[at..] {
            rest if rest.starts_with("/*") => (2, 1),
            rest if rest.starts_with("*/") => (2, -1),
            _ => (letter.len_utf8(), 0),
        };
        at += step;
        depth = depth.saturating_add_signed(change);
        if depth == 0 {
            return Some(at);
        }
    }
    None
}
