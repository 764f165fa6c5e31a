//! What a chain keeps: its parameters and what is derived from them.
//!
//! Private fields of generated types are in reach of all code in the module of the macro call. Both are
//! therefore inside a type of the runtime. Only generated code replaces that value.

use super::EmitContext;
use super::arrays::usize_literal;
use crate::model::RepeatId;
use crate::program::ArrayLayout;
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

/// The only field of a chain. Its name is what rustc proposes where a field is written that is not there.
pub fn field() -> Ident {
    format_ident!("changed_by_setters")
}

/// The type of the field: parameters, and an array, in pairs with those of repeated parts.
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

/// Arrays in pairs: tuples of any length have not all traits.
pub fn paired(once: TokenStream, parts: impl Iterator<Item = TokenStream>) -> TokenStream {
    parts.fold(once, |before, part| quote!((#before, #part)))
}

/// Repeated parts of which something is known since setup, and how it lies in its array.
pub fn parts(cx: &EmitContext) -> Vec<(RepeatId, ArrayLayout)> {
    let part =
        |part: RepeatId| Some((part, cx.slots(Some(part)))).filter(|(_, layout)| layout.total > 0);
    cx.chain.repeats.ids().into_iter().filter_map(part).collect()
}

/// All arrays of a chain.
pub fn arrays(cx: &EmitContext, owner: &TokenStream) -> Vec<TokenStream> {
    (0..=parts(cx).len()).map(|number| array(cx, owner, number)).collect()
}

/// The array of what is known since setup and is there once.
pub fn once(cx: &EmitContext, owner: &TokenStream) -> TokenStream {
    array(cx, owner, 0)
}

/// The array of a repeated part that has one.
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
