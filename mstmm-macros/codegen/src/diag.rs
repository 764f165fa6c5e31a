//! Collects the errors and warnings of a text, so that one build reports all of them.

use proc_macro2::{Ident, Span, TokenStream};
use quote::{ToTokens, TokenStreamExt};
use std::collections::HashSet;
use syn::Error;

/// Panics at a broken invariant of the compiler. In a macro a panic is an error message; a default value in its place
/// would generate wrong dynamics.
macro_rules! bug {
    ($($what:tt)*) => {
        unreachable!(
            "mstmm bug: {}; please report it with the description of the chain",
            format_args!($($what)*),
        )
    };
}

/// The span from a first to a last token.
#[derive(Clone, Copy, Debug)]
pub struct SpanRange {
    /// The first token.
    pub first: Span,
    /// The last token.
    pub last: Span,
    /// The instance of a part whose arguments the text uses, if it uses any.
    pub instance: Option<InstanceId>,
}

/// An instance of a part, for messages: an index into the descriptions in [`Diagnostics`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct InstanceId(usize);

impl SpanRange {
    /// Returns the extent of a single token.
    pub fn token(at: Span) -> Self {
        SpanRange { first: at, last: at, instance: None }
    }

    /// Returns the extent from the start of this one to the end of another.
    pub fn to(self, end: SpanRange) -> Self {
        SpanRange { last: end.last, instance: self.instance.or(end.instance), ..self }
    }

    /// Returns the same extent in an instance of a part.
    pub fn within(self, instance: Option<InstanceId>) -> Self {
        SpanRange { instance, ..self }
    }
}

impl From<&Ident> for SpanRange {
    fn from(name: &Ident) -> Self {
        SpanRange::token(name.span())
    }
}

/// Writes two placeholder tokens with the spans of the first and the last token. `syn` builds the span of an error from
/// these two, so that spans need not be joined, which not every compiler can do.
impl ToTokens for SpanRange {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        tokens.append(Ident::new("from", self.first));
        tokens.append(Ident::new("to", self.last));
    }
}

/// The largest number of errors that is reported, and the largest number of warnings.
const MAX_REPORTED: usize = 100;

/// A warning: the chain is valid but possibly not what the user intended.
#[derive(Clone, Debug)]
pub struct Warning {
    /// The token that it refers to.
    pub at: Span,
    /// The name of the rule, in capitals.
    pub rule: &'static str,
    /// The message: what is unclear, then what to write instead.
    pub message: String,
}

/// The errors and the warnings of a text, each on the token that the user has to edit.
///
/// A token has at most one error and one warning: the first that was found. They are reported in the order of the text.
#[derive(Debug, Default)]
pub struct Diagnostics {
    errors: Vec<(SourcePosition, Error)>,
    /// Names that are rejected.
    refused: HashSet<NameKey>,
    /// Errors at unknown names, each with the names that the user may have intended.
    unknown: Vec<(TokenKey, Vec<NameKey>)>,
    /// The first error beyond [`MAX_REPORTED`], and the number of these errors.
    beyond: Option<(Span, usize)>,
    /// The tokens with an error.
    with_error: HashSet<TokenKey>,
    warnings: Vec<(SourcePosition, Warning)>,
    /// The tokens with a warning.
    with_warning: HashSet<TokenKey>,
    /// The instances of parts, as written: `Leg(-1, 1) rf`.
    instances: Vec<String>,
}

impl Diagnostics {
    /// Adds an error at a single token.
    pub fn error(&mut self, at: Span, message: impl std::fmt::Display) {
        self.add(|| Error::new(at, message));
    }

    /// Adds an error that covers all of `at`. If the text there uses arguments of a part, the message names the instance.
    pub fn error_over(&mut self, at: impl Into<SpanRange>, message: impl std::fmt::Display) {
        let at = at.into();
        match at.instance.and_then(|instance| self.instances.get(instance.0).cloned()) {
            Some(instance) => {
                self.add(|| Error::new_spanned(at, format!("{message}, in `{instance}`")))
            }
            None => self.add(|| Error::new_spanned(at, message)),
        };
    }

    /// Adds an instance of a part, which messages describe as written: `Leg(-1, 1) rf`.
    pub fn add_instance(&mut self, description: String) -> InstanceId {
        self.instances.push(description);
        InstanceId(self.instances.len() - 1)
    }

    /// Adds an error that a parser found.
    pub fn push(&mut self, error: Error) {
        self.add(|| error);
    }

    /// Adds an error at a name that is rejected.
    pub fn name(&mut self, name: &Ident, message: impl std::fmt::Display) {
        self.refused.insert(name_key(name));
        self.error(name.span(), message);
    }

    /// Adds an error at an unknown name. The error is not reported if one of the names that it may be `meant` to be is
    /// rejected itself, since it then follows from that error.
    pub fn unknown<'n>(
        &mut self,
        name: &Ident,
        message: impl std::fmt::Display,
        meant: impl IntoIterator<Item = &'n Ident>,
    ) {
        if let Some(key) = self.add(|| Error::new(name.span(), message)) {
            self.unknown.push((key, meant.into_iter().map(name_key).collect()));
        }
    }

    /// Adds an error and returns the key of its token; none if the token has an error already, or if the error is only
    /// counted.
    fn add(&mut self, error: impl FnOnce() -> Error) -> Option<TokenKey> {
        if let Some((_, count)) = &mut self.beyond {
            *count += 1;
            return None;
        }
        let error = error();
        let position = SourcePosition::of(error.span());
        let key = position.key(&error);
        if !self.with_error.insert(key.clone()) {
            return None;
        }
        if self.is_full() {
            self.beyond = Some((error.span(), 1));
            return None;
        }
        self.errors.push((position, error));
        Some(key)
    }

    /// Adds a warning at a single token; `rule` is the name of the rule, in capitals.
    pub fn warn(&mut self, at: Span, rule: &'static str, message: impl std::fmt::Display) {
        let (position, message) = (SourcePosition::of(at), message.to_string());
        if self.warnings.len() < MAX_REPORTED && self.with_warning.insert(position.key(&message)) {
            self.warnings.push((position, Warning { at, rule, message }));
        }
    }

    /// Returns whether further errors are only counted, so that their messages are not needed.
    pub fn is_full(&self) -> bool {
        self.errors.len() >= MAX_REPORTED
    }

    /// Returns whether there is no error so far.
    pub fn is_empty(&self) -> bool {
        self.errors.is_empty()
    }

    /// Returns the warnings so far, in the order of the text.
    pub fn warnings(&self) -> Vec<Warning> {
        let mut warnings = self.warnings.clone();
        warnings.sort_by(|(a, _), (b, _)| a.cmp(b));
        warnings.into_iter().map(|(_, warning)| warning).collect()
    }

    /// Drops errors at unknown names that may be meant to be rejected names.
    fn drop_consequences(&mut self) {
        let Diagnostics { errors, refused, unknown, .. } = self;
        let follows = |(_, meant): &&(TokenKey, Vec<NameKey>)| {
            meant.iter().any(|name| refused.contains(name))
        };
        let follow: HashSet<&TokenKey> =
            unknown.iter().filter(follows).map(|(key, _)| key).collect();
        errors.retain(|(position, error)| !follow.contains(&position.key(error)));
    }

    /// Ends a phase: returns all errors as one, in the order of the text.
    pub fn finish(mut self) -> syn::Result<()> {
        self.drop_consequences();
        self.errors.sort_by(|(a, _), (b, _)| a.cmp(b));
        let beyond =
            self.beyond.map(|(at, count)| Error::new(at, format!("… and {count} more errors")));
        let errors = self.errors.into_iter().map(|(_, error)| error).chain(beyond);
        match errors.reduce(|mut error, next| {
            error.combine(next);
            error
        }) {
            Some(error) => Err(error),
            None => Ok(()),
        }
    }
}

/// The start of a token: its file, line and column.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
struct SourcePosition(String, usize, usize);

/// Identifies a token. Tokens from another macro may all have the position of that macro's call; the message
/// distinguishes them.
type TokenKey = (SourcePosition, Option<String>);

/// Identifies an occurrence of a name.
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

/// Returns `; did you mean …?` if one of `known` is close to `word`, otherwise an empty text.
pub fn did_you_mean<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> String {
    nearest(word, candidates).map_or_else(String::new, |near| format!("; did you mean `{near}`?"))
}

/// Returns the closest of `known` to `word`, if any is close.
pub fn nearest<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let letters = letters(word);
    let near = |candidate: &'a str| {
        // A one-letter word with another letter is another name, not a typing error.
        let most = (candidate.len().max(word.len()) / 3).max(1).min(word.len().saturating_sub(1));
        // Comparing the lengths rules out most candidates.
        if candidate.chars().count().abs_diff(letters.len()) > most {
            return None;
        }
        let distance = edit_distance(&letters, &self::letters(candidate));
        (distance <= most).then_some((distance, candidate))
    };
    candidates
        .into_iter()
        .filter_map(near)
        .min_by_key(|&(distance, _)| distance)
        .map(|(_, near)| near)
}

/// Returns the letters of a word in lower case.
fn letters(word: &str) -> Vec<char> {
    word.chars().flat_map(char::to_lowercase).collect()
}

/// Returns the number of edits (insert, delete, replace, swap neighbours) that lead from `a` to `b`.
fn edit_distance(a: &[char], b: &[char]) -> usize {
    // The rows of the table for the previous letter of `a` and for the letter before it.
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
    fn more_errors_than_help_are_counted() {
        let mut diagnostics = Diagnostics::default();
        for number in 0..1000 {
            diagnostics.error(Span::call_site(), number);
        }
        let errors = diagnostics.finish().expect_err("errors");
        let errors: Vec<_> = errors.into_iter().map(|error| error.to_string()).collect();
        assert_eq!(errors.len(), 101);
        assert_eq!(errors[99..], ["99", "… and 900 more errors"]);
    }

    #[test]
    fn a_close_word_is_suggested_and_a_far_one_is_not() {
        assert_eq!(did_you_mean("lenght", ["mass", "length"]), "; did you mean `length`?");
        assert_eq!(did_you_mean("bal", ["pin", "ball"]), "; did you mean `ball`?");
        assert_eq!(did_you_mean("colour", ["mass", "com"]), "");
    }
}
