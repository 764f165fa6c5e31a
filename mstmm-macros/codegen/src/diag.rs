//! Errors and warnings of a text, collected so that one build reports them all.

use proc_macro2::{Ident, Span, TokenStream};
use quote::{ToTokens, TokenStreamExt};
use std::collections::HashSet;
use syn::Error;

/// Stops the compiler at a broken invariant: in a macro that is an error message, and a default in its position
/// would be a wrong robot.
macro_rules! bug {
    ($($what:tt)*) => {
        unreachable!(
            "mstmm bug: {}; please report it with the description of the chain",
            format_args!($($what)*),
        )
    };
}

/// From the first to the last token of something written.
#[derive(Clone, Copy, Debug)]
pub struct Extent {
    /// The first token.
    pub first: Span,
    /// The last token.
    pub last: Span,
}

impl Extent {
    /// A single token.
    pub fn token(at: Span) -> Self {
        Extent { first: at, last: at }
    }

    /// From the start of this to the end of another one.
    pub fn to(self, end: Extent) -> Self {
        Extent { first: self.first, last: end.last }
    }
}

/// Two stand-in tokens with the right spans: `syn` builds the span of an error from the first and
/// the last token, and that way works without joining spans, which not every compiler can.
impl ToTokens for Extent {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        tokens.append(Ident::new("from", self.first));
        tokens.append(Ident::new("to", self.last));
    }
}

/// As many errors are reported, and as many warnings: more would help nobody.
const MOST: usize = 100;

/// A warning: the chain is right, and perhaps not what was meant.
#[derive(Clone, Debug)]
pub struct Warning {
    /// The token that it is about.
    pub at: Span,
    /// The name of the rule, in capitals.
    pub rule: &'static str,
    /// The message: it says what is unclear, then what to write instead.
    pub message: String,
}

/// The errors and the warnings of a text, each on the token that the user has to edit. A token has
/// one of each at most: the first that was found. They are reported in the order of the text.
#[derive(Debug, Default)]
pub struct Diagnostics {
    errors: Vec<(SourcePosition, Error)>,
    /// Names that are refused.
    refused: HashSet<NameKey>,
    /// Errors at unknown names, and the names that these may be meant to be.
    unknown: Vec<(TokenKey, Vec<NameKey>)>,
    /// The first of those beyond the most that are reported, and how many these are.
    beyond: Option<(Span, usize)>,
    /// Where errors are.
    wrong: HashSet<TokenKey>,
    warnings: Vec<(SourcePosition, Warning)>,
    /// Where warnings are.
    unclear: HashSet<TokenKey>,
}

impl Diagnostics {
    /// Adds an error at a single token.
    pub fn error(&mut self, at: Span, message: impl std::fmt::Display) {
        self.note(|| Error::new(at, message));
    }

    /// Adds an error that covers all of `at`.
    pub fn error_over(&mut self, at: impl ToTokens, message: impl std::fmt::Display) {
        self.note(|| Error::new_spanned(at, message));
    }

    /// Adds an error that a parser found.
    pub fn push(&mut self, error: Error) {
        self.note(|| error);
    }

    /// Adds an error at a name that is refused.
    pub fn name(&mut self, name: &Ident, message: impl std::fmt::Display) {
        self.refused.insert(name_key(name));
        self.error(name.span(), message);
    }

    /// Adds an error at a name that is unknown. It follows from another one, and is not reported, where a name is
    /// refused that it may be `meant` to be.
    pub fn unknown<'n>(
        &mut self,
        name: &Ident,
        message: impl std::fmt::Display,
        meant: impl IntoIterator<Item = &'n Ident>,
    ) {
        if let Some(key) = self.note(|| Error::new(name.span(), message)) {
            self.unknown.push((key, meant.into_iter().map(name_key).collect()));
        }
    }

    /// Where an error is that was added; nothing if there was one, or if it is only counted.
    fn note(&mut self, error: impl FnOnce() -> Error) -> Option<TokenKey> {
        if let Some((_, count)) = &mut self.beyond {
            *count += 1;
            return None;
        }
        let error = error();
        let position = SourcePosition::of(error.span());
        let key = position.key(&error);
        if !self.wrong.insert(key.clone()) {
            return None;
        }
        if self.is_full() {
            self.beyond = Some((error.span(), 1));
            return None;
        }
        self.errors.push((position, error));
        Some(key)
    }

    /// Adds a warning at a single token. `rule` is the name of the rule, in capitals.
    pub fn warn(&mut self, at: Span, rule: &'static str, message: impl std::fmt::Display) {
        let (position, message) = (SourcePosition::of(at), message.to_string());
        if self.warnings.len() < MOST && self.unclear.insert(position.key(&message)) {
            self.warnings.push((position, Warning { at, rule, message }));
        }
    }

    /// Whether the next errors will only be counted, so that their words are of no use.
    pub fn is_full(&self) -> bool {
        self.errors.len() >= MOST
    }

    /// Whether there is no error so far.
    pub fn is_empty(&self) -> bool {
        self.errors.is_empty()
    }

    /// The warnings so far, in the order of the text.
    pub fn warnings(&self) -> Vec<Warning> {
        let mut warnings = self.warnings.clone();
        warnings.sort_by(|(a, _), (b, _)| a.cmp(b));
        warnings.into_iter().map(|(_, warning)| warning).collect()
    }

    /// Drops errors at unknown names that may be meant to be refused ones.
    fn drop_what_follows(&mut self) {
        let Diagnostics { errors, refused, unknown, .. } = self;
        let follows = |(_, meant): &&(TokenKey, Vec<NameKey>)| {
            meant.iter().any(|name| refused.contains(name))
        };
        let follow: HashSet<&TokenKey> =
            unknown.iter().filter(follows).map(|(key, _)| key).collect();
        errors.retain(|(position, error)| !follow.contains(&position.key(error)));
    }

    /// Closes a phase: all errors as one, in the order of the text, or none.
    pub fn finish(mut self) -> syn::Result<()> {
        self.drop_what_follows();
        self.errors.sort_by(|(a, _), (b, _)| a.cmp(b));
        let beyond =
            self.beyond.map(|(at, count)| Error::new(at, format!("… and {count} more mistakes")));
        let errors = self.errors.into_iter().map(|(_, error)| error).chain(beyond);
        match errors.reduce(|mut all, next| {
            all.combine(next);
            all
        }) {
            Some(all) => Err(all),
            None => Ok(()),
        }
    }
}

/// Where a token begins: its file, line and column.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
struct SourcePosition(String, usize, usize);

/// What tells tokens apart. Tokens that another macro has made may all be at the place of its call:
/// the message tells those apart.
type TokenKey = (SourcePosition, Option<String>);

/// What tells names apart.
type NameKey = (SourcePosition, String);

fn name_key(name: &Ident) -> NameKey {
    (SourcePosition::of(name.span()), name.to_string())
}

impl SourcePosition {
    fn of(span: Span) -> SourcePosition {
        let start = span.start();
        SourcePosition(span.file(), start.line, start.column)
    }

    fn key(&self, message: &impl ToString) -> TokenKey {
        let is_of_call = *self == SourcePosition::of(Span::call_site());
        (self.clone(), is_of_call.then(|| message.to_string()))
    }
}

/// `; did you mean …?` where one of `known` is close to `word`, else nothing.
pub fn did_you_mean<'a>(word: &str, known: impl IntoIterator<Item = &'a str>) -> String {
    nearest(word, known).map_or_else(String::new, |near| format!("; did you mean `{near}`?"))
}

/// The one of `known` that `word` was most likely meant to be, if any is close.
pub fn nearest<'a>(word: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let letters = letters(word);
    let near = |candidate: &'a str| {
        // One letter for another is no slip but another name.
        let most = (candidate.len().max(word.len()) / 3).max(1).min(word.len().saturating_sub(1));
        // The lengths alone tell most of them apart.
        if candidate.chars().count().abs_diff(letters.len()) > most {
            return None;
        }
        let distance = edit_distance(&letters, &self::letters(candidate));
        (distance <= most).then_some((distance, candidate))
    };
    known.into_iter().filter_map(near).min_by_key(|&(distance, _)| distance).map(|(_, near)| near)
}

/// The letters of a word, case ignored.
fn letters(word: &str) -> Vec<char> {
    word.chars().flat_map(char::to_lowercase).collect()
}

/// Edits (insert, delete, replace, swap neighbours) that lead from `a` to `b`.
fn edit_distance(a: &[char], b: &[char]) -> usize {
    // The rows for the letters of `a` up to the one before, and up to the last but one.
    let mut before: Vec<usize> = (0..=b.len()).collect();
    let mut last_but_one = before.clone();
    for i in 1..=a.len() {
        let mut row = vec![i];
        for j in 1..=b.len() {
            let replace = before[j - 1] + usize::from(a[i - 1] != b[j - 1]);
            let mut least = replace.min(before[j] + 1).min(row[j - 1] + 1);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                least = least.min(last_but_one[j - 2] + 1);
            }
            row.push(least);
        }
        last_but_one = std::mem::replace(&mut before, row);
    }
    before[b.len()]
}

#[cfg(test)]
mod tests {
    use super::{Diagnostics, did_you_mean};
    use proc_macro2::Span;

    #[test]
    fn more_mistakes_than_help_are_counted() {
        let mut diagnostics = Diagnostics::default();
        for number in 0..1000 {
            diagnostics.error(Span::call_site(), number);
        }
        let mistakes = diagnostics.finish().expect_err("mistakes");
        let mistakes: Vec<_> = mistakes.into_iter().map(|error| error.to_string()).collect();
        assert_eq!(mistakes.len(), 101);
        assert_eq!(mistakes[99..], ["99", "… and 900 more mistakes"]);
    }

    #[test]
    fn a_close_word_is_suggested_and_a_far_one_is_not() {
        assert_eq!(did_you_mean("lenght", ["mass", "length"]), "; did you mean `length`?");
        assert_eq!(did_you_mean("bal", ["pin", "ball"]), "; did you mean `ball`?");
        assert_eq!(did_you_mean("colour", ["mass", "com"]), "");
    }
}
