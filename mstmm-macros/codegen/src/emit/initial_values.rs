//! The initial values of a workspace.

use super::EmitContext;
use super::arrays::usize_literal;
use crate::model::Answer;
use crate::program::{Array, ArrayRole, OutputId};
use proc_macro2::TokenStream;
use quote::quote;

/// Returns the initial array of a result of the solution: zeros, and the values that are the same in every state.
pub fn array(cx: &EmitContext, id: OutputId) -> TokenStream {
    of_array(cx, result(cx, id))
}

/// Returns the initial array of a result of an answer, if the answer has it.
pub fn array_of(cx: &EmitContext, answer: Answer, id: OutputId) -> Option<TokenStream> {
    result_of(cx, answer, id).map(|array| of_array(cx, array))
}

/// Returns a result of an answer, if the answer has it.
pub fn result_of<'a>(cx: &'a EmitContext, answer: Answer, id: OutputId) -> Option<&'a Array> {
    let arrays = &cx.compiled.find(answer)?.procedure.arrays;
    arrays.iter().find(|array| array.role == ArrayRole::Result(id))
}

fn of_array(cx: &EmitContext, array: &Array) -> TokenStream {
    let count = usize_literal(array.layout.total);
    let zeros = quote!([T::constant(0.0); #count]);
    let known = array.initial.iter().filter(|(_, value)| *value != 0.0).map(|&(entry, value)| {
        let entry = usize_literal(entry);
        let value = constant(value);
        quote!((#entry, #value))
    });
    let known: Vec<TokenStream> = known.collect();
    if known.is_empty() {
        return zeros;
    }
    let mstmm = &cx.mstmm;
    quote!(#mstmm::generated::with_constants(#zeros, &[#(#known),*]))
}

/// Returns the initial value of an entry of a result.
pub fn entry(cx: &EmitContext, id: OutputId, entry: usize) -> TokenStream {
    let known = result(cx, id).initial.iter().find(|(other, _)| *other == entry);
    constant(known.map_or(0.0, |(_, value)| *value))
}

/// Returns a constant. It may be infinite if a chain has no inertia; the test of the pivots fails before anyone reads it.
pub fn constant(value: f64) -> TokenStream {
    if value.is_finite() {
        quote!(T::constant(#value))
    } else {
        quote!(T::constant(::core::f64::NAN))
    }
}

/// Returns the length of a result, if the solution has it.
pub fn length(cx: &EmitContext, id: OutputId) -> Option<usize> {
    find(cx, id).map(|array| array.layout.total)
}

fn result<'a>(cx: &'a EmitContext, id: OutputId) -> &'a Array {
    find(cx, id).unwrap_or_else(|| bug!("a solution has no `{}`", id.name))
}

fn find<'a>(cx: &'a EmitContext, id: OutputId) -> Option<&'a Array> {
    result_of(cx, Answer::Solution, id)
}
