//! The table of bodies with their inertia, and the values of it that parameters change.

use super::super::EmitContext;
use super::super::arrays::usize_literal;
use super::super::const_expr::{constant, is_const};
use super::row::{Row, default, indexed};
use super::shapes::ShapeLists;
use crate::model::{About, Body, BodyId, Symbol, Value};
use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};
use std::collections::BTreeMap;

/// Returns the inertias and shapes that occur, and the table of bodies.
pub fn bodies(cx: &EmitContext) -> (TokenStream, Vec<Row>) {
    let mut seen: BTreeMap<String, usize> = BTreeMap::new();
    let (mut items, mut rows) = (TokenStream::new(), Vec::new());
    let mut shapes = ShapeLists::default();
    for id in cx.chain.physical_bodies() {
        let body = &cx.chain.bodies[id];
        let inertia = written(cx, body);
        let next = seen.len();
        let number = *seen.entry(inertia.to_string()).or_insert(next);
        let name = format_ident!("BODY{number}_");
        if number == next {
            items.extend(quote!(const #name: Inertia_ = #inertia;));
        }
        let repeat = cx.chain.repeat_of_body(id);
        let (path, ty) = (indexed(&body.path, repeat.is_some()), body.type_name.to_string());
        let shaped = shapes.of(body);
        let tokens = quote!(#name.named(#path, #ty) #shaped);
        rows.push(Row { tokens, repeat: cx.counted(repeat) });
    }
    items.extend(shapes.items);
    (items, rows)
}

/// Returns the inertia of a body with default parameters.
fn written(cx: &EmitContext, body: &Body) -> TokenStream {
    let mass = default(cx, &body.mass);
    let com = body.com.iter().map(|value| default(cx, value));
    let tensor = body.inertia.tensor.iter().map(|value| default(cx, value));
    let about_com = body.inertia.about == About::Com;
    if body.inertia.tensor[3..].iter().all(Value::is_zero) {
        let diag = tensor.take(3);
        return quote!(diag_(#mass, [#(#com),*], [#(#diag),*], #about_com));
    }
    quote!(tensor_(#mass, [#(#com),*], [#(#tensor),*], #about_com))
}

/// Returns the method that sets the values which are not constants, if there are any.
pub fn changes(cx: &EmitContext) -> TokenStream {
    let bodies: Vec<BodyId> = cx.chain.physical_bodies().collect();
    let arms: Vec<TokenStream> = bodies
        .into_iter()
        .enumerate()
        .filter_map(|(row, id)| {
            let changes = changes_of(cx, &cx.chain.bodies[id]);
            let row = usize_literal(row);
            (!changes.is_empty()).then(|| quote!(#row => { #changes }))
        })
        .collect();
    if arms.is_empty() {
        return TokenStream::new();
    }
    let mstmm = &cx.mstmm;
    quote! {
        fn change_inertia_(&self, it_: &mut #mstmm::generated::description::Inertia_<T>) {
            let parameters_ = self.parameters();
            match it_.row {
                #(#arms)*
                _ => {}
            }
        }
    }
}

fn changes_of(cx: &EmitContext, body: &Body) -> TokenStream {
    let entry = |array: &str, entry: usize| {
        let (array, entry) = (format_ident!("{array}"), usize_literal(entry));
        quote!(it_.#array[#entry])
    };
    let com = body.com.iter().enumerate().map(|(k, value)| (entry("com", k), value));
    let tensor = body.inertia.tensor.iter().enumerate();
    let tensor = tensor.map(|(k, value)| (entry("tensor", k), value));
    let all = std::iter::once((quote!(it_.mass), &body.mass)).chain(com).chain(tensor);
    all.map(|(place, value)| assignment(cx, &place, value)).collect()
}

/// Returns the statement that sets a place to a value with the parameters as they are set, unless the value is constant.
pub fn assignment(cx: &EmitContext, place: &TokenStream, value: &Value) -> TokenStream {
    if !value.changes() && is_const(cx, value) {
        return TokenStream::new();
    }
    let value = scalar(cx, value);
    quote!(#place = #value;)
}

/// Returns a value as an expression of the scalar type, with the parameters as they are set.
fn scalar(cx: &EmitContext, value: &Value) -> TokenStream {
    let mstmm = &cx.mstmm;
    let go = |value: &Value| scalar(cx, value);
    match value {
        Value::Number(number) => {
            let number = Literal::f64_suffixed(*number);
            quote!(T::constant(#number))
        }
        Value::Symbol(Symbol::Constant(index)) => {
            let constant = constant(cx, *index);
            quote!(T::constant(#constant))
        }
        Value::Symbol(Symbol::Parameter(index)) => {
            let parameter = &cx.chain.parameters[*index];
            let name = &parameter.name;
            match parameter.repetitions {
                None => quote!(parameters_.#name),
                Some(_) => quote!(#mstmm::generated::entry(&parameters_.#name, it_.index)),
            }
        }
        Value::Sum(a, b) => {
            let (a, b) = (go(a), go(b));
            quote!((#a + #b))
        }
        Value::Product(a, b) => {
            let (a, b) = (go(a), go(b));
            quote!((#a * #b))
        }
        Value::Quotient(a, b) => {
            let (a, b) = (go(a), go(b));
            quote!((#a * <T as #mstmm::Scalar>::recip(#b)))
        }
        Value::Sqrt(a) => {
            let a = go(a);
            quote!(<T as #mstmm::Scalar>::sqrt(#a))
        }
        Value::Sin(a) => {
            let a = go(a);
            quote!(#mstmm::generated::scalar_sin(#a))
        }
        Value::Cos(a) => {
            let a = go(a);
            quote!(#mstmm::generated::scalar_cos(#a))
        }
    }
}
