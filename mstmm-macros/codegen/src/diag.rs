//! Mistakes of the user, collected so that one build reports them all.

use proc_macro2::{Ident, Span, TokenStream};
use quote::{ToTokens, TokenStreamExt};
use syn::Error;

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

/// A list of mistakes, each with the token that the user has to edit.
#[derive(Debug, Default)]
pub struct Diagnostics {
    errors: Vec<Error>,
}

impl Diagnostics {
    /// Notes a mistake at a single token.
    pub fn error(&mut self, at: Span, message: impl std::fmt::Display) {
        self.errors.push(Error::new(at, message));
    }

    /// Notes a mistake that covers all of `at`.
    pub fn error_over(&mut self, at: impl ToTokens, message: impl std::fmt::Display) {
        self.errors.push(Error::new_spanned(at, message));
    }

    /// Notes a mistake that a parser found.
    pub fn push(&mut self, error: Error) {
        self.errors.push(error);
    }

    /// Whether there is no mistake so far.
    pub fn is_empty(&self) -> bool {
        self.errors.is_empty()
    }

    /// Closes a phase: all mistakes as one error, or the way is free.
    pub fn finish(self) -> syn::Result<()> {
        match self.errors.into_iter().reduce(|mut all, next| {
            all.combine(next);
            all
        }) {
            Some(all) => Err(all),
            None => Ok(()),
        }
    }
}

/// `; did you mean …?` where one of `known` is close to `word`, else nothing.
pub fn did_you_mean<'a>(word: &str, known: impl IntoIterator<Item = &'a str>) -> String {
    nearest(word, known).map_or_else(String::new, |near| format!("; did you mean `{near}`?"))
}

/// The one of `known` that `word` was most likely meant to be, if any is close.
pub fn nearest<'a>(word: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    known
        .into_iter()
        .map(|candidate| (edit_distance(word, candidate), candidate))
        .filter(|&(distance, candidate)| distance <= (candidate.len().max(word.len()) / 3).max(1))
        // One letter for another is no slip but another name.
        .filter(|&(distance, _)| distance < word.len())
        .min_by_key(|&(distance, _)| distance)
        .map(|(_, candidate)| candidate)
}

/// Edits (insert, delete, replace, swap neighbours) that lead from `a` to `b`, case ignored.
fn edit_distance(a: &str, b: &str) -> usize {
    let a: Vec<char> = a.to_lowercase().chars().collect();
    let b: Vec<char> = b.to_lowercase().chars().collect();
    let mut rows = vec![vec![0; b.len() + 1]; a.len() + 1];
    for i in 0..=a.len() {
        for j in 0..=b.len() {
            rows[i][j] = if i == 0 || j == 0 {
                i + j
            } else {
                let replace = rows[i - 1][j - 1] + usize::from(a[i - 1] != b[j - 1]);
                let mut least = replace.min(rows[i - 1][j] + 1).min(rows[i][j - 1] + 1);
                if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                    least = least.min(rows[i - 2][j - 2] + 1);
                }
                least
            };
        }
    }
    rows[a.len()][b.len()]
}

#[cfg(test)]
mod tests {
    use super::did_you_mean;

    #[test]
    fn a_close_word_is_suggested_and_a_far_one_is_not() {
        assert_eq!(did_you_mean("lenght", ["mass", "length"]), "; did you mean `length`?");
        assert_eq!(did_you_mean("bal", ["pin", "ball"]), "; did you mean `ball`?");
        assert_eq!(did_you_mean("colour", ["mass", "com"]), "");
    }
}
