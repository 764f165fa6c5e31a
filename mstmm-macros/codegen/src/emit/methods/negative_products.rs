//! The products of a linearisation: derivatives of inverse dynamics times `−M⁻¹` are those of the accelerations.

use super::super::EmitContext;
use super::super::arrays::usize_literal;
use super::super::initial_values;
use super::super::names::helper;
use crate::compile::outputs;
use crate::model::{Answer, InputKind};
use crate::program::{Array, OutputId};
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};
use std::ops::Range;

/// A factor of a product: derivatives of inverse dynamics.
struct Factor<'a> {
    /// The field of the result.
    result: Ident,
    /// The variable of the factor.
    name: Ident,
    /// The factor.
    array: &'a Array,
}

/// Returns the factors of products with `−M⁻¹` that have columns.
fn factors_of<'a>(cx: &'a EmitContext) -> Vec<Factor<'a>> {
    let all = [outputs::BY_COORDINATES, outputs::BY_RATES, outputs::BY_PARAMETERS];
    let factor = |id: OutputId| {
        let array = initial_values::result_of(cx, Answer::Linearization, id)?;
        let (result, name) = (format_ident!("{}", id.name), helper(id.name));
        (array.layout.total > 0).then_some(Factor { result, name, array })
    };
    all.into_iter().filter_map(factor).collect()
}

/// Returns the declarations of these factors, with the entries that are the same in every state.
pub(super) fn factors(cx: &EmitContext) -> TokenStream {
    let (mstmm, rows) = (&cx.mstmm, cx.rates().total);
    let declared = factors_of(cx).into_iter().map(|Factor { name, array, .. }| {
        let columns = usize_literal(array.layout.total / rows);
        let known = array.initial.iter().filter(|(_, value)| *value != 0.0);
        let known = known.map(|&(entry, value)| {
            let [row, column] = [entry % rows, entry / rows].map(usize_literal);
            let value = initial_values::constant(value);
            quote!(#name.data.0[#column][#row] = #value;)
        });
        let rows = usize_literal(rows);
        quote! {
            let mut #name = #mstmm::generated::matrix([[T::constant(0.0); #rows]; #columns]);
            #(#known)*
        }
    });
    declared.collect()
}

/// Returns the statements that multiply derivatives of inverse dynamics by `−M⁻¹`.
pub(super) fn products(cx: &EmitContext) -> TokenStream {
    let (mstmm, rates) = (&cx.mstmm, cx.rates().total);
    let inverse = quote!(linearization_.inverse_mass_matrix);
    let products = factors_of(cx).into_iter().map(|Factor { result, name, array }| {
        if array.initial.is_empty() {
            return quote! {
                #mstmm::linear::negative_product(&#inverse, &#name, &mut linearization_.#result);
            };
        }
        // The numbers of columns, and the rows where they may have other numbers than zero.
        let pattern = pattern_of(array, rates);
        let pattern = pattern.iter().map(|(columns, rows)| {
            let columns = usize_literal(*columns);
            let rows = rows.iter().map(|Range { start, end }| {
                let [start, end] = [start, end].map(|&row| usize_literal(row));
                quote!(#start..#end)
            });
            quote!((#columns, &[#(#rows),*]))
        });
        quote! {
            #mstmm::linear::negative_product_of_rows(
                &#inverse, &#name, &[#(#pattern),*], &mut linearization_.#result,
            );
        }
    });
    let mut statements: TokenStream = products.collect();
    // The columns of motors are those of the inverse.
    for input in &cx.layout.inputs {
        if !matches!(input.what, InputKind::Efforts(_)) {
            let [start, end] = [input.range.start, input.range.end].map(usize_literal);
            statements.extend(quote! {
                if let ::core::option::Option::Some(columns_) =
                    linearization_.by_inputs.data.0.get_mut(#start..#end)
                {
                    #mstmm::generated::multiply_by_negative(&#inverse, columns_);
                }
            });
        }
    }
    statements
}

/// Returns the numbers of neighbouring columns that have zeros in the same rows in every state, each with its other rows.
fn pattern_of(array: &Array, rows: usize) -> Vec<(usize, Vec<Range<usize>>)> {
    let mut vanishes = vec![false; array.layout.total];
    for &(entry, value) in &array.initial {
        vanishes[entry] = value == 0.0;
    }
    let mut pattern: Vec<(usize, Vec<Range<usize>>)> = Vec::new();
    for column in vanishes.chunks(rows) {
        let ranges = other_rows(column);
        match pattern.last_mut() {
            Some((columns, last)) if *last == ranges => *columns += 1,
            _ => pattern.push((1, ranges)),
        }
    }
    pattern
}

/// Returns the rows of a column that do not vanish, in ranges.
fn other_rows(vanishes: &[bool]) -> Vec<Range<usize>> {
    let mut ranges: Vec<Range<usize>> = Vec::new();
    for row in (0..vanishes.len()).filter(|&row| !vanishes[row]) {
        match ranges.last_mut() {
            Some(last) if last.end == row => last.end += 1,
            _ => ranges.push(row..row + 1),
        }
    }
    ranges
}
