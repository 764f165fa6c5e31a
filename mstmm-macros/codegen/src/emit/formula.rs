//! Formulas of constants as Rust expressions.

use super::Plan;
use crate::model::{Symbol, Value};
use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

/// A formula of constants as an `f64` expression, with parameters at their defaults.
pub fn value_tokens(plan: &Plan, value: &Value) -> TokenStream {
    let go = |value: &Value| value_tokens(plan, value);
    match value {
        Value::Number(number) => {
            let magnitude = Literal::f64_suffixed(number.abs());
            if *number < 0.0 { quote!((-#magnitude)) } else { quote!(#magnitude) }
        }
        Value::Symbol(Symbol::Constant(index)) => plan.surface.constants[*index].clone(),
        Value::Symbol(Symbol::Parameter(index)) => go(&plan.chain.parameters[*index].default),
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
        Value::Sqrt(a) => function(plan, "sqrt", go(a)),
        Value::Sin(a) => function(plan, "sin", go(a)),
        Value::Cos(a) => function(plan, "cos", go(a)),
    }
}

/// `core` has no such functions of `f64`; the runtime has.
fn function(plan: &Plan, name: &str, argument: TokenStream) -> TokenStream {
    let mstmm = &plan.mstmm;
    let name = format_ident!("{name}");
    quote!(#mstmm::generated::#name(#argument))
}
