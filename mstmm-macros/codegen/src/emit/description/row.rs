//! The rows of the tables.

use super::super::EmitContext;
use super::super::arrays::usize_literal;
use super::super::const_expr::{is_const, value_tokens};
use crate::ids::{HingeId, RepeatId};
use crate::model::{Hinge, Value};
use crate::program::ArrayLayout;
use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

/// Returns the call that sets a table, unless the table is empty.
pub fn table(method: &str, rows: &[Row]) -> TokenStream {
    if rows.is_empty() {
        return TokenStream::new();
    }
    let method = format_ident!("{method}");
    let tokens = rows.iter().map(|row| &row.tokens);
    quote!(.#method(&[#(#tokens),*]))
}

/// A row of a table.
pub struct Row {
    /// Its tokens.
    pub tokens: TokenStream,
    /// The repeated part that it belongs to, with the number of repetitions.
    pub repeat: Option<(RepeatId, usize)>,
}

/// Returns the numbers of rows in a run and of their repetitions; nothing if all rows occur once.
pub fn runs(rows: &[Row]) -> TokenStream {
    if rows.iter().all(|row| row.repeat.is_none()) {
        return TokenStream::new();
    }
    let segments = ArrayLayout::of(rows.iter().map(|row| (1, row.repeat))).segments;
    let run = |count: usize, repetitions: usize| {
        let [count, repetitions] = [count, repetitions].map(usize_literal);
        quote!([#count, #repetitions])
    };
    let runs = segments.iter().map(|segment| run(segment.count, segment.repetitions));
    quote!(#(#runs),*)
}

/// Returns the hinges of the table: all but the welds at the ends of repeated parts.
pub fn described_hinges<'a>(cx: &'a EmitContext) -> impl Iterator<Item = (HingeId, &'a Hinge)> {
    let hinges = cx.chain.hinges.enumerate();
    hinges.filter(|(_, hinge)| cx.chain.repeat_boundary(&hinge.outboard).is_none())
}

impl EmitContext<'_> {
    /// Returns a part with the number of its repetitions.
    pub fn counted(&self, repeat: Option<RepeatId>) -> Option<(RepeatId, usize)> {
        repeat.map(|repeat| (repeat, self.chain.repeats[repeat].count))
    }
}

/// Returns a path with brackets for the index of a repetition.
pub fn indexed(path: &str, is_repeated: bool) -> String {
    if is_repeated { format!("{path}[]") } else { path.to_owned() }
}

/// Returns a value with default parameters, not a number if a `const` item cannot compute it.
pub fn default(cx: &EmitContext, value: &Value) -> TokenStream {
    let defaults: Vec<Option<f64>> =
        cx.chain.parameters.iter().map(|parameter| parameter.default.at(&[])).collect();
    match value.at(&defaults) {
        Some(number) if number.is_finite() => literal(number),
        None if is_const(cx, value) => value_tokens(cx, value),
        _ => quote!(NAN_),
    }
}

/// Returns a finite number.
pub fn literal(number: f64) -> TokenStream {
    let magnitude = Literal::f64_unsuffixed(number.abs());
    if number < 0.0 { quote!(-#magnitude) } else { quote!(#magnitude) }
}
