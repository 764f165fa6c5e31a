//! Errors and warnings with their places, for people and for editors.

use annotate_snippets::{AnnotationKind, Level, Renderer, Snippet};
use mstmm_codegen::diag::Warning;
use serde::Serialize;
use std::ops::Range;
use std::path::Path;

use crate::commands::Failure;
use crate::source::Source;

/// How serious a message is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Severity {
    /// The text is not a chain.
    Error,
    /// The chain is valid but possibly not what its author intended.
    Warning,
}

/// An error or a warning. Lines and columns count from 1, columns in characters; the end is the first character after
/// the place.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Message {
    /// The file.
    pub file: String,
    /// The line.
    pub line: usize,
    /// The column.
    pub column: usize,
    /// The line of the end.
    pub end_line: usize,
    /// The column of the end.
    pub end_column: usize,
    /// How serious it is.
    pub severity: Severity,
    /// The text.
    pub message: String,
    /// The text to write instead, if the compiler has a suggestion.
    pub help: Option<String>,
    /// The name of the rule of a warning.
    pub rule: Option<String>,
    /// The bytes of the place.
    #[serde(skip)]
    pub range: Range<usize>,
}

impl Message {
    /// Makes an error at a place.
    #[must_use]
    pub fn at(source: &Source, range: Range<usize>, message: &str) -> Self {
        let range = in_text(&source.text, range);
        let [start, end] = [range.start, range.end].map(|at| line_and_column(&source.text, at));
        let help = message.rsplit_once("; did you mean `");
        let help = help.and_then(|(_, help)| help.strip_suffix("`?"));
        Message {
            file: source.file.clone(),
            line: start.0,
            column: start.1,
            end_line: end.0,
            end_column: end.1,
            severity: Severity::Error,
            message: message.to_owned(),
            help: help.map(str::to_owned),
            rule: None,
            range,
        }
    }

    /// Makes the error about a file that cannot be read, at its first character.
    #[must_use]
    pub fn of_file(file: &Path, failure: &Failure) -> Self {
        let source = Source::new(&Source::name(file), "");
        let message = failure.to_string();
        let reason = message.strip_prefix(&source.file).and_then(|rest| rest.strip_prefix(": "));
        Self::at(&source, 0..0, reason.unwrap_or(&message))
    }

    /// Makes the message of an error of the compiler.
    #[must_use]
    pub fn of_error(source: &Source, error: &syn::Error) -> Self {
        Self::at(source, error.span().byte_range(), &error.to_string())
    }

    /// Makes the message of a warning of the compiler.
    #[must_use]
    pub fn of_warning(source: &Source, warning: &Warning) -> Self {
        let rule = Some(warning.rule.to_lowercase());
        let error = Self::at(source, warning.at.byte_range(), &warning.message);
        Message { severity: Severity::Warning, rule, ..error }
    }

    /// Returns the number of errors among messages.
    #[must_use]
    pub fn count_errors(messages: &[Message]) -> usize {
        messages.iter().filter(|message| message.severity == Severity::Error).count()
    }
}

/// Returns the message texts with their lines of the source, as rustc prints them.
#[must_use]
pub fn rendered(source: &Source, messages: &[Message]) -> String {
    let report = |message: &Message| {
        let level = match message.severity {
            Severity::Error => Level::ERROR,
            Severity::Warning => Level::WARNING,
        };
        let place = AnnotationKind::Primary.span(message.range.clone());
        let lines = Snippet::source(&*source.text).path(&*source.file).annotation(place);
        let report = [level.primary_title(&*message.message).element(lines)];
        Renderer::plain().render(&report).to_string() + "\n\n"
    };
    messages.iter().map(report).collect()
}

/// Returns the messages as JSON objects, one in a line.
#[must_use]
pub fn json_lines(messages: &[Message]) -> String {
    let line = |message| serde_json::to_string(message).unwrap_or_default() + "\n";
    messages.iter().map(line).collect()
}

/// Returns a place in the text. A message without a place is at the end of the text, where something is missing.
fn in_text(text: &str, range: Range<usize>) -> Range<usize> {
    let is_in = range.start < range.end && text.get(range.clone()).is_some();
    let end = text.trim_end().len();
    if is_in { range } else { end..end }
}

/// Returns line and column of a byte, from 1.
fn line_and_column(text: &str, at: usize) -> (usize, usize) {
    let before = &text[..at];
    let line = before.rfind('\n').map_or(0, |newline| newline + 1);
    (before.matches('\n').count() + 1, before[line..].chars().count() + 1)
}
