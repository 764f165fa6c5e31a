//! Descriptions and what is made of them.
//!
//! `tests/ui` has one case with the whole text for a message, and variants here have key words of it;
//! `tests/messages.rs` holds both to that.

mod answer_pages;
mod any_tokens;
mod branches_and_loops;
mod causes;
mod each_error_once;
mod errors_in_chains;
mod errors_in_hinges;
mod errors_in_numbers;
mod errors_in_parts;
mod errors_in_routes;
mod errors_in_shapes;
mod errors_in_trees;
mod errors_in_words;
mod errors_of_parts;
mod grammar;
mod keywords;
mod no_follow_up_errors;
mod parts;
mod read_as_intended;
mod rules;
mod shapes;
mod trees;
mod valid;
mod valid_chains;
mod valid_hinges;
mod warnings;

use proc_macro2::Span;

use super::{Chain, Drive, Effort, Value};
use crate::read;
use crate::syntax::Passthrough;

/// The example of the documentation, from which the wrong ones are made by a single edit each.
const PENDULUM: &str = "
    pub chain Pendulum {
        gravity = [0, -9.8, 0] m/s^2;
        param payload = 0.5 kg;
        param ratio = 2;

        body Cube {
            mass = 1 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(1/6, 5/12, 5/12) kg*m^2 about input;
        }
        body Rod {
            mass = 2 kg;
            com = [0.5, 0, 0] m;
            inertia = diag(0, 1/6, 1/6) kg*m^2 about com;
        }

        ground -> pin(z) shoulder -> Cube upper -> ball wrist -> Rod rod;

        hinge wrist { start_rate = [0, 0.1, 0] rad/s; }
        hinge shoulder { start = 30 deg; torque = input; }
    }";

/// The only chain of a description without errors.
fn chain(source: &str) -> (Chain, Passthrough) {
    let tokens = source.parse().expect("tokens");
    let mut chains = read(tokens).unwrap_or_else(|error| panic!("{error}, in {source}"));
    assert_eq!(chains.len(), 1);
    chains.remove(0)
}

fn known<const N: usize>(values: &[Value; N]) -> [f64; N] {
    values.each_ref().map(|value| value.known().expect("a known number"))
}

fn all_known(values: &[Value]) -> Vec<f64> {
    values.iter().map(|value| value.known().expect("a known number")).collect()
}

/// The constant efforts of a hinge.
fn constants(drive: &Drive) -> Vec<f64> {
    let Drive::Efforts(efforts) = drive else { panic!("no efforts") };
    let constant = |effort: &Effort| match effort {
        Effort::Constant(value) => value.known().expect("a known number"),
        other => panic!("{other:?}"),
    };
    efforts.iter().map(constant).collect()
}

/// The example with some of its text replaced.
fn edited(edits: &[(&str, &str)]) -> String {
    edits.iter().fold(PENDULUM.to_owned(), |source, (from, to)| {
        assert_eq!(source.matches(from).count(), 1, "`{from}` must stand once in {source}");
        source.replace(from, to)
    })
}

/// Makes one edit and expects exactly these errors: the text that each points at, the message.
#[track_caller]
fn expect(from: &str, to: &str, errors: &[(&str, &str)]) {
    expect_all(&edited(&[(from, to)]), errors);
}

/// Expects exactly these errors: the text that each points at, and the message.
#[track_caller]
fn expect_all(source: &str, errors: &[(&str, &str)]) {
    let found = errors_in(source);
    let as_expected = |((at, message), expected): (&(String, String), &(&str, &str))| {
        at == expected.0 && says(message, expected.1)
    };
    let all = found.len() == errors.len() && found.iter().zip(errors).all(as_expected);
    assert!(all, "found {found:#?}\nexpected {errors:#?}\nin {source}");
}

/// Whether a message is the expected one, in which `…` stands for any words.
fn says(message: &str, expected: &str) -> bool {
    let Some((start, rest)) = expected.split_once('…') else { return message == expected };
    let (between, end) = rest.rsplit_once('…').unwrap_or(("", rest));
    message.strip_prefix(start).is_some_and(|message| {
        message.ends_with(end) && between.split('…').all(|words| message.contains(words))
    })
}

/// All errors: the text that each points at, and the message.
fn errors_in(source: &str) -> Vec<(String, String)> {
    match read(source.parse().expect("tokens")) {
        Ok(_) => Vec::new(),
        Err(errors) => errors
            .into_iter()
            .map(|error| (text(source, error.span()), error.to_string()))
            .collect(),
    }
}

/// The source under a span.
fn text(source: &str, span: Span) -> String {
    let index = |place: proc_macro2::LineColumn| {
        let line: usize = source.split_inclusive('\n').take(place.line - 1).map(str::len).sum();
        let rest = &source[line..];
        line + rest.char_indices().nth(place.column).map_or(rest.len(), |(at, _)| at)
    };
    source[index(span.start())..index(span.end())].to_owned()
}
