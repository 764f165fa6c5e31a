//! Finds brackets, strings and comments that are not closed, and characters that no token has: the tokenizer does not
//! tell the place.

use std::ops::Range;

/// Characters of other programs, and what to write instead.
const REPLACED: &[(char, &str)] = &[
    ('²', "^2"),
    ('³', "^3"),
    ('°', "deg"),
    ('−', "-"),
    ('–', "-"),
    ('—', "-"),
    ('·', "*"),
    ('×', "*"),
    ('→', "->"),
    ('“', "\""),
    ('”', "\""),
    ('„', "\""),
];

/// The words with which a chain may begin.
const HEADS: &[&str] = &["chain", "space", "plane", "line", "pub"];

/// The message at a brace that closes an outer bracket too early.
const TOO_MANY: &str = "this `}` is too many, or a `{` before it is missing";

/// Returns the place and the message of the first character that no token has, of the first bracket without a partner, or
/// of the string or comment that does not end.
#[must_use]
pub fn unclosed(text: &str) -> Option<(Range<usize>, String)> {
    let mut brackets = Brackets { text, open: Vec::new(), suspect: None, extra: None };
    let mut at = 0;
    while let Some(letter) = text[at..].chars().next() {
        let rest = &text[at..];
        let length = match letter {
            '/' if rest.starts_with("//") => rest.find('\n').unwrap_or(rest.len()),
            '/' if rest.starts_with("/*") => match comment(rest) {
                Some(length) => length,
                None => return Some((at..at + 2, "this comment is not closed".into())),
            },
            '\'' => match quoted(rest) {
                Some(length) => length,
                None => return Some((at..at + 1, apostrophe(&text[..at], &rest[1..]))),
            },
            '"' => match string(rest) {
                Some(length) => length,
                None => return Some((at..at + 1, "this string is not closed".into())),
            },
            _ => letter.len_utf8(),
        };
        let found = match letter {
            '(' | '[' | '{' => {
                brackets.open.push((at, letter));
                None
            }
            ')' | ']' | '}' => brackets.close(at, letter),
            _ => strange(letter).map(|message| (at..at + length, message)),
        };
        if found.is_some() {
            return found;
        }
        at += length;
    }
    brackets.end()
}

/// The brackets that are open at a place of a text.
struct Brackets<'a> {
    text: &'a str,
    open: Vec<(usize, char)>,
    /// The first brace whose partner is further to the left than itself: another one closed it, probably.
    suspect: Option<(usize, char)>,
    /// The first brace that probably is too many: it is further to the right than its partner, or text follows it that begins
    /// no chain.
    extra: Option<usize>,
}

impl Brackets<'_> {
    /// Closes a bracket. Returns the place and the message of one without a partner.
    fn close(&mut self, at: usize, letter: char) -> Option<(Range<usize>, String)> {
        let here = at..at + 1;
        let Some((opened, left)) = self.open.pop() else {
            let extra = self.extra.filter(|_| letter == '}');
            return Some(match extra {
                Some(at) => (at..at + 1, TOO_MANY.into()),
                None => (here, format!("`{letter}` closes no bracket")),
            });
        };
        if partner(left) == letter {
            if letter == '}' && self.is_extra(at, opened) {
                self.extra = self.extra.or(Some(at));
            }
            if letter == '}' && self.indentation(at) < self.indentation(opened) {
                self.suspect = self.suspect.or(Some((opened, left)));
            }
            return None;
        }
        match (left, letter) {
            // Braces are further apart than other brackets.
            ('{', _) => Some((here, format!("`{letter}` closes no bracket"))),
            (_, '}') => Some(not_closed(opened, left)),
            _ => Some((here, format!("expected `{}`, found `{letter}`", partner(left)))),
        }
    }

    /// Returns the place and the message of a bracket that is open at the end.
    fn end(mut self) -> Option<(Range<usize>, String)> {
        let (at, left) = self.open.pop()?;
        let (at, left) = self.suspect.filter(|_| left == '{').unwrap_or((at, left));
        Some(not_closed(at, left))
    }

    /// Returns whether a brace is probably too many.
    fn is_extra(&self, at: usize, opened: usize) -> bool {
        let line = self.text[..at].rfind('\n').map_or(0, |end| end + 1);
        let is_first = self.text[line..at].trim().is_empty();
        let rest = self.text[at + 1..].trim_start();
        let word = rest.split(|letter: char| !letter.is_alphanumeric()).next().unwrap_or_default();
        let goes_on = !word.is_empty() && !HEADS.contains(&word);
        (is_first && self.indentation(at) > self.indentation(opened))
            || (self.open.is_empty() && goes_on)
    }

    /// Returns the number of blanks at the start of the line of a place.
    fn indentation(&self, at: usize) -> usize {
        let line = self.text[..at].rfind('\n').map_or(0, |end| end + 1);
        self.text[line..].chars().take_while(|letter| letter.is_whitespace()).count()
    }
}

fn not_closed(at: usize, left: char) -> (Range<usize>, String) {
    (at..at + 1, format!("`{left}` is not closed: expected `{}`", partner(left)))
}

/// Returns the message about a character that no token has.
fn strange(letter: char) -> Option<String> {
    if is_blank(letter) || letter.is_alphabetic() || is_ascii_sign(letter) {
        return None;
    }
    let instead = REPLACED.iter().find(|(other, _)| *other == letter);
    let instead = instead.map_or_else(String::new, |(_, text)| format!(": write `{text}`"));
    let code = u32::from(letter);
    // Characters that are not visible are written as in Rust.
    let shown = if letter == '\\' { letter.to_string() } else { letter.escape_debug().to_string() };
    Some(format!("`{shown}` (U+{code:04X}) is not a character of the language{instead}"))
}

/// Returns whether Rust reads a character as a blank. Other blanks, such as one at which no line may break, are errors.
fn is_blank(letter: char) -> bool {
    let beyond_ascii = ['\u{85}', '\u{200e}', '\u{200f}', '\u{2028}', '\u{2029}', '\u{feff}'];
    matches!(letter, ' ' | '\t'..='\r') || beyond_ascii.contains(&letter)
}

/// Returns whether the tokenizer reads a character of a text as a blank that is none for Rust.
pub fn has_other_blanks(text: &str) -> bool {
    text.chars().any(|letter| letter.is_whitespace() && !is_blank(letter))
}

/// Returns whether an ASCII character can be in a token. An apostrophe can only be in some.
fn is_ascii_sign(letter: char) -> bool {
    letter.is_ascii() && !letter.is_ascii_control() && !['`', '\\'].contains(&letter)
}

/// Returns the message about an apostrophe between two texts.
fn apostrophe(before: &str, after: &str) -> String {
    let is_digit = |letter: char| letter.is_ascii_digit();
    let is_in_number = before.ends_with(is_digit) && after.starts_with(is_digit);
    let instead = if is_in_number { ": write `_` between digits" } else { "" };
    format!("`'` (U+0027) is not a character of the language{instead}")
}

/// Returns the length of the token of Rust with an apostrophe at the start of a text: of a character, or the
/// apostrophe of a lifetime.
fn quoted(text: &str) -> Option<usize> {
    let mut letters = text.char_indices().skip(1);
    let (_, first) = letters.next()?;
    if first == '\\' {
        letters.next()?;
        return letters.find(|(_, letter)| *letter == '\'').map(|(at, _)| at + 1);
    }
    match letters.next() {
        Some((at, '\'')) if first != '\'' => Some(at + 1),
        _ => (first.is_alphabetic() || first == '_').then_some(1),
    }
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
