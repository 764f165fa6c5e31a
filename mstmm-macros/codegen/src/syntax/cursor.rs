//! A position in the tokens. Unlike `syn`'s parse stream it may be dropped anywhere, so that
//! parsing can continue after an error.

use proc_macro2::{Delimiter, Ident, Literal, Punct, Spacing, Span, TokenTree};
use syn::{Error, Result, buffer};

use super::tree::SpanRange;

/// The maximum depth of nested groups: expressions are traversed by recursion.
const DEEPEST: usize = 32;

/// The tokens that are still to be read.
#[derive(Clone, Copy)]
pub(super) struct Cursor<'a> {
    rest: buffer::Cursor<'a>,
    last: Span,
    depth: usize,
}

impl<'a> Cursor<'a> {
    /// Starts at the first token.
    pub fn new(rest: buffer::Cursor<'a>) -> Self {
        Cursor { rest, last: Span::call_site(), depth: 0 }
    }

    /// Returns whether the group is exhausted.
    pub fn is_empty(&self) -> bool {
        self.rest.eof()
    }

    /// The next token.
    pub fn next_span(&self) -> Span {
        self.rest.span()
    }

    /// The token read last.
    pub fn last(&self) -> SpanRange {
        SpanRange::token(self.last)
    }

    fn take<T>(&mut self, found: Option<(T, buffer::Cursor<'a>)>) -> Option<T> {
        let (token, rest) = found?;
        self.last = self.rest.span();
        self.rest = rest;
        Some(token)
    }

    /// The next token if it is an identifier, without reading it.
    pub fn peek_ident(&self) -> Option<Ident> {
        self.rest.ident().map(|(ident, _)| ident)
    }

    /// The next token if it is an identifier.
    pub fn ident(&mut self) -> Option<Ident> {
        self.take(self.rest.ident())
    }

    /// The next token if it is this word.
    pub fn word(&mut self, word: &str) -> Option<Span> {
        let ident = self.peek_ident().filter(|ident| ident == word)?;
        self.ident();
        Some(ident.span())
    }

    /// Returns the next token if it is a sign. A sign at the beginning of a group without delimiters belongs to this group: an
    /// expression that `macro_rules!` passes keeps its value in every formula.
    fn sign(&self) -> Option<(Punct, buffer::Cursor<'a>)> {
        if self.peek_group(Delimiter::None) { None } else { self.rest.punct() }
    }

    /// Whether this sign is next.
    pub fn peek_punct(&self, sign: char) -> bool {
        self.sign().is_some_and(|(punct, _)| punct.as_char() == sign)
    }

    /// The next token if it is this sign.
    pub fn punct(&mut self, sign: char) -> Option<Span> {
        let found = self.sign().filter(|(punct, _)| punct.as_char() == sign);
        self.take(found).map(|punct| punct.span())
    }

    /// Returns whether `first` and `second` are next, without a space between them: paths are
    /// passed to Rust unchanged, and there a space would separate the two signs.
    pub fn peek_pair(&self, first: char, second: char) -> bool {
        let Some((sign, rest)) = self.sign() else { return false };
        let is_first = sign.as_char() == first && sign.spacing() == Spacing::Joint;
        is_first && Cursor { rest, ..*self }.peek_punct(second)
    }

    /// A pair of signs such as `->` or `::`.
    pub fn pair(&mut self, first: char, second: char) -> Option<Span> {
        if !self.peek_pair(first, second) {
            return None;
        }
        self.punct(first);
        self.punct(second)
    }

    /// The next token if it is a number or text.
    pub fn literal(&mut self) -> Option<Literal> {
        self.take(self.rest.literal())
    }

    /// Whether a group of this kind is next.
    pub fn peek_group(&self, delimiter: Delimiter) -> bool {
        self.rest.group(delimiter).is_some()
    }

    /// Reads the next group if it has this delimiter: its content and its span.
    pub fn group(&mut self, delimiter: Delimiter) -> Option<(Cursor<'a>, SpanRange)> {
        let (inside, span, rest) = self.rest.group(delimiter)?;
        self.rest = rest;
        self.last = span.close();
        let inside = Cursor { rest: inside, last: span.open(), depth: self.depth + 1 };
        Some((inside, SpanRange::token(span.open()).to(SpanRange::token(span.close()))))
    }

    /// The next token, whatever it is.
    pub fn any(&mut self) -> Option<TokenTree> {
        self.take(self.rest.token_tree())
    }

    /// Reports groups that are nested too deeply.
    pub fn check_depth(&self) -> Result<()> {
        if self.depth <= DEEPEST {
            return Ok(());
        }
        Err(Error::new(self.last, format!("more than {DEEPEST} nested groups")))
    }

    /// Reports tokens that are left in this group.
    pub fn check_empty(&self, expected: &str) -> Result<()> {
        if self.is_empty() { Ok(()) } else { Err(self.unexpected(expected)) }
    }

    /// Returns an error at the next token, or at the last one if none is left.
    pub fn unexpected(&self, expected: &str) -> Error {
        let mut ahead = *self;
        let (at, found) = match ahead.any() {
            None => return Error::new(self.last, format!("expected {expected} after this")),
            Some(TokenTree::Group(group)) => match group.delimiter() {
                Delimiter::Parenthesis => (group.span_open(), "(".into()),
                Delimiter::Brace => (group.span_open(), "{".into()),
                Delimiter::Bracket => (group.span_open(), "[".into()),
                Delimiter::None => (group.span(), group.to_string()),
            },
            Some(token) => (token.span(), token.to_string()),
        };
        Error::new(at, format!("expected {expected}, found `{found}`"))
    }

    /// Skips the rest of a statement with an error: up to its `;`, or up to the end of its block
    /// unless an arrow follows.
    pub fn skip_statement(&mut self) {
        while !self.is_empty() {
            if self.punct(';').is_some() {
                return;
            }
            let block = self.group(Delimiter::Brace).is_some();
            if block && !self.peek_pair('-', '>') && !self.peek_punct(';') {
                return;
            }
            if !block {
                self.any();
            }
        }
    }
}
