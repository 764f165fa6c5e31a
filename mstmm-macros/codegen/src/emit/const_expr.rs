//! Prints formulas of constants as Rust expressions.

use super::EmitContext;
use crate::model::{Symbol, Value};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

/// Returns the items with the values of the user's constants, if there are any. A constant of another type than `f64` is
/// then one error, however often it is used.
pub fn constants(cx: &EmitContext) -> Option<TokenStream> {
    let (chain, values) = (&cx.names.chain, &cx.passthrough.constants);
    let items = values.iter().enumerate().map(|(index, value)| {
        let name = constant_name(index);
        quote!(const #name: ::core::primitive::f64 = #value;)
    });
    (!values.is_empty()).then(|| {
        quote! {
            #[allow(clippy::all)]
            impl #chain<::core::primitive::f64> {
                #(#items)*
            }
        }
    })
}

/// Returns the value of a constant of the user.
pub fn constant(cx: &EmitContext, index: usize) -> TokenStream {
    let (chain, name) = (&cx.names.chain, constant_name(index));
    quote!(<#chain<::core::primitive::f64>>::#name)
}

fn constant_name(index: usize) -> Ident {
    format_ident!("CONSTANT{index}_")
}

/// Returns a formula of constants as an `f64` expression, with parameters at their defaults.
pub fn value_tokens(cx: &EmitContext, value: &Value) -> TokenStream {
    let go = |value: &Value| value_tokens(cx, value);
    match value {
        Value::Number(number) => {
            let magnitude = Literal::f64_suffixed(number.abs());
            if *number < 0.0 { quote!((-#magnitude)) } else { quote!(#magnitude) }
        }
        Value::Symbol(Symbol::Constant(index)) => constant(cx, *index),
        Value::Symbol(Symbol::Parameter(index)) => go(&cx.chain.parameters[*index].default),
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
            quote!((#a / #b))
        }
        Value::Sqrt(a) => function(cx, "sqrt", go(a)),
        Value::Sin(a) => function(cx, "sin", go(a)),
        Value::Cos(a) => function(cx, "cos", go(a)),
    }
}

/// Returns the call of a function of `f64` in the runtime, since `core` has none.
fn function(cx: &EmitContext, name: &str, argument: TokenStream) -> TokenStream {
    let mstmm = &cx.mstmm;
    let name = format_ident!("{name}");
    quote!(#mstmm::generated::#name(#argument))
}

/// Returns whether a formula can be evaluated in a `const` item.
pub fn is_const(cx: &EmitContext, value: &Value) -> bool {
    let is_const = |value: &Value| is_const(cx, value);
    match value {
        Value::Number(_) | Value::Symbol(Symbol::Constant(_)) => true,
        Value::Sum(a, b) | Value::Product(a, b) | Value::Quotient(a, b) => {
            is_const(a) && is_const(b)
        }
        Value::Symbol(Symbol::Parameter(index)) => is_const(&cx.chain.parameters[*index].default),
        Value::Sqrt(_) | Value::Sin(_) | Value::Cos(_) => false,
    }
}
