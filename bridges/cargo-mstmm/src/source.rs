//! The text of a chain in a file, and what the compiler finds in it.

use mstmm_codegen::{Checked, CheckedChain};
use proc_macro2::{Group, LexError, Span, TokenStream, TokenTree};
use std::io::Read;
use std::ops::Range;
use std::path::Path;

use crate::commands::{Failure, read};
use crate::messages::{Message, rendered};
use crate::unclosed::{has_other_blanks, unclosed};

/// A file with the text of one or more chains, with `mstmm_chain! { … }` around them or without.
#[derive(Clone, Debug)]
pub struct Source {
    /// The name of the file, for messages.
    pub file: String,
    /// Its text.
    pub text: String,
}

impl Source {
    /// Reads a file; `-` is standard input.
    ///
    /// # Errors
    ///
    /// If the file cannot be read or is not UTF-8.
    pub fn read(file: &Path) -> Result<Self, Failure> {
        let name = Self::name(file);
        if file == Path::new("-") {
            let mut text = String::new();
            return match std::io::stdin().read_to_string(&mut text) {
                Ok(_) => Ok(Self::new(&name, &text)),
                Err(error) => Err(Failure(format!("{name}: {error}"))),
            };
        }
        Ok(Self::new(&name, &read(file)?))
    }

    /// Returns the name of a file for messages.
    #[must_use]
    pub fn name(file: &Path) -> String {
        let is_input = file == Path::new("-");
        if is_input { "standard input".to_owned() } else { file.display().to_string() }
    }

    /// Makes a source from a text.
    #[must_use]
    pub fn new(file: &str, text: &str) -> Self {
        // Places count from the first character after the mark of the byte order.
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        Source { file: file.to_owned(), text: text.to_owned() }
    }

    /// Finds the chains, or all errors, and the warnings.
    #[must_use]
    pub fn check(&self) -> (Vec<CheckedChain>, Vec<Message>) {
        let tokens = match self.tokens() {
            Ok(tokens) => tokens,
            Err(message) => return (Vec::new(), vec![*message]),
        };
        let Checked { chains, errors, warnings } = mstmm_codegen::check(tokens);
        let errors = errors.into_iter().flatten().map(|error| Message::of_error(self, &error));
        let warnings = warnings.iter().map(|warning| Message::of_warning(self, warning));
        let mut messages: Vec<Message> = errors.chain(warnings).collect();
        messages.sort_by_key(|message| (message.line, message.column));
        (chains, messages)
    }

    /// Returns the chains. Writes the messages to standard error.
    ///
    /// # Errors
    ///
    /// If the text has errors.
    pub fn chains(&self) -> Result<Vec<CheckedChain>, Failure> {
        let (chains, messages) = self.check();
        eprint!("{}", rendered(self, &messages));
        match Message::count_errors(&messages) {
            0 => Ok(chains),
            errors => Err(Failure::of_errors(errors)),
        }
    }

    /// Returns the tokens inside `mstmm_chain! { … }`, or all tokens.
    ///
    /// # Errors
    ///
    /// If a bracket, a string or a comment is not closed, a character has no meaning, or the file has items of Rust.
    pub fn tokens(&self) -> Result<TokenStream, Box<Message>> {
        let tokens = self.all_tokens()?;
        if let Some(item) = rust_item(&tokens) {
            let message = "a file has chains, or one `mstmm_chain! { … }` around all its text: this is a file of Rust";
            return Err(Box::new(Message::at(self, item.byte_range(), message)));
        }
        Ok(macro_group(&tokens).map_or(tokens, |group| group.stream()))
    }

    /// Returns the text inside `mstmm_chain! { … }`, or the whole text.
    ///
    /// # Errors
    ///
    /// Those of [`Source::tokens`].
    pub fn inside(&self) -> Result<&str, Box<Message>> {
        let group = macro_group(&self.all_tokens()?);
        let range = group
            .map(|group| group.span_open().byte_range().end..group.span_close().byte_range().start);
        Ok(range.and_then(|range| self.text.get(range)).unwrap_or(&self.text))
    }

    /// Returns the character at an empty range: an error of the tokenizer has a place without an end.
    fn character(&self, range: Range<usize>) -> Range<usize> {
        let letter = self.text.get(range.start..).and_then(|rest| rest.chars().next());
        range.start..range.end.max(range.start + letter.map_or(0, char::len_utf8))
    }

    fn all_tokens(&self) -> Result<TokenStream, Box<Message>> {
        let found =
            || unclosed(&self.text).map(|(at, text)| Box::new(Message::at(self, at, &text)));
        let other_blanks = has_other_blanks(&self.text).then(found).flatten();
        if let Some(message) = other_blanks {
            return Err(message);
        }
        self.text.parse().map_err(|error: LexError| {
            found().unwrap_or_else(|| {
                let text = "expected a name, a number or a sign of the language";
                Box::new(Message::at(self, self.character(error.span().byte_range()), text))
            })
        })
    }
}

/// Returns the brackets of `mstmm_chain! { … }`, with the path of the crate or without; none if the tokens begin otherwise.
fn macro_group(tokens: &TokenStream) -> Option<Group> {
    let is_path = |token: &TokenTree| match token {
        TokenTree::Ident(name) => name == "mstmm",
        TokenTree::Punct(sign) => sign.as_char() == ':',
        _ => false,
    };
    let mut rest = tokens.clone().into_iter().skip_while(is_path);
    match [rest.next(), rest.next(), rest.next()] {
        [
            Some(TokenTree::Ident(name)),
            Some(TokenTree::Punct(_)),
            Some(TokenTree::Group(group)),
        ] if name == "mstmm_chain" => Some(group),
        _ => None,
    }
}

/// The keywords with which items of Rust begin.
const RUST_ITEMS: &[&str] = &[
    "use", "fn", "mod", "struct", "enum", "impl", "trait", "const", "static", "type", "extern",
    "unsafe", "let",
];

/// Returns the place of the first item of Rust, if the tokens begin with one or with an attribute of a file.
fn rust_item(tokens: &TokenStream) -> Option<Span> {
    let mut rest = tokens.clone().into_iter().peekable();
    loop {
        match rest.next()? {
            TokenTree::Punct(sign) if sign.as_char() == '#' => {
                if let Some(TokenTree::Punct(second)) = rest.peek() {
                    return (second.as_char() == '!').then(|| sign.span());
                }
                rest.next();
            }
            TokenTree::Ident(word) if word == "pub" => {
                rest.next_if(|token| matches!(token, TokenTree::Group(_)));
            }
            TokenTree::Ident(word) => {
                return RUST_ITEMS.iter().any(|item| word == item).then(|| word.span());
            }
            _ => return None,
        }
    }
}
