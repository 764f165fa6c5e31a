//! The field of a chain: its parameters, and the slots that are derived from them.
//!
//! Private fields of generated types are accessible to all code in the module of the macro call. Both are therefore inside
//! a type of the runtime, whose value only generated code replaces.

use super::EmitContext;
use super::arrays::usize_literal;
use crate::model::RepeatId;
use crate::program::ArrayLayout;
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

/// Returns the only field of a chain. rustc suggests its name in errors about unknown fields.
pub fn field() -> Ident {
    format_ident!("changed_by_setters")
}

/// Returns the type of the field: parameters, and the arrays of slots in nested pairs.
pub fn type_of(cx: &EmitContext) -> TokenStream {
    let (mstmm, parameters) = (&cx.mstmm, &cx.names.parameters);
    let slots = Literal::usize_unsuffixed(cx.slots(None).total);
    let parts = parts(cx).into_iter().map(|(_, layout)| {
        let total = usize_literal(layout.total);
        quote!([T; #total])
    });
    let derived = paired(quote!([T; #slots]), parts);
    quote!(#mstmm::generated::Sealed<#parameters<T>, #derived>)
}

/// Returns arrays in nested pairs, since tuples of arbitrary length do not have all traits.
pub fn paired(once: TokenStream, parts: impl Iterator<Item = TokenStream>) -> TokenStream {
    parts.fold(once, |before, part| quote!((#before, #part)))
}

/// Returns the repeated parts that have slots, with the layouts of these.
pub fn parts(cx: &EmitContext) -> Vec<(RepeatId, ArrayLayout)> {
    let part =
        |part: RepeatId| Some((part, cx.slots(Some(part)))).filter(|(_, layout)| layout.total > 0);
    cx.chain.repeats.ids().into_iter().filter_map(part).collect()
}

/// Returns all arrays of slots of a chain.
pub fn arrays(cx: &EmitContext, owner: &TokenStream) -> Vec<TokenStream> {
    (0..=parts(cx).len()).map(|number| array(cx, owner, number)).collect()
}

/// Returns the array of slots outside of repeated parts.
pub fn once(cx: &EmitContext, owner: &TokenStream) -> TokenStream {
    array(cx, owner, 0)
}

/// Returns the array of slots of a repeated part, which must have slots.
pub fn of_part(cx: &EmitContext, owner: &TokenStream, part: RepeatId) -> TokenStream {
    let before = parts(cx).iter().filter(|(other, _)| *other < part).count();
    array(cx, owner, 1 + before)
}

fn array(cx: &EmitContext, owner: &TokenStream, number: usize) -> TokenStream {
    let (field, parts) = (field(), parts(cx).len());
    if parts == 0 {
        return quote!(*#owner.#field.derived());
    }
    let inwards = (number..parts).map(|_| quote!(.0));
    let last = (number > 0).then(|| quote!(.1));
    quote!(#owner.#field.derived()#(#inwards)*#last)
}
