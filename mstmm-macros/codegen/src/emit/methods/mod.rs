//! The methods that compute: one for each function of the table.

mod dynamics;
mod state;

use super::names::helper;
use super::printer::Destination;
use super::procedure::body;
use super::{Plan, docs, integrable};
use crate::compile::CompiledFunction;
use crate::model::Answer;
use crate::program::OutputId;
use proc_macro2::TokenStream;
use quote::quote;

/// How a function looks in Rust.
struct Method {
    /// Its name, with what it may be seen from.
    name: TokenStream,
    /// What its docs say before the table of operations, and behind it.
    docs: [TokenStream; 2],
    /// What it is given beside the chain.
    arguments: TokenStream,
    /// The type of what it returns.
    returns: TokenStream,
    /// What stands before its statements.
    opening: TokenStream,
    /// What it ends with.
    end: TokenStream,
    /// Where its results go.
    destination: fn(&Plan, OutputId) -> Destination,
}

/// The chain's methods and its implementations of traits.
pub fn emit(plan: &Plan) -> TokenStream {
    let mstmm = &plan.mstmm;
    let name = &plan.names.chain;
    let methods = plan.compiled.functions.iter().map(|function| method(plan, function));
    let by_value = dynamics::by_value(plan);
    let energy = integrable::energy(plan);
    let integrable = integrable::integrable(plan);
    let generated = integrable::generated(plan);
    quote! {
        #[allow(dead_code, non_snake_case)]
        impl<T: #mstmm::Scalar> #name<T> {
            #(#methods)*
            #(#by_value)*
            #energy
        }
        #integrable
        #generated
    }
}

/// The method of a function.
fn method(plan: &Plan, function: &CompiledFunction) -> TokenStream {
    let Some(answer) = function.answer else { bug!("the setup is no method") };
    let Method { name, docs, arguments, returns, opening, end, destination } = row(plan, answer);
    let procedure = &function.procedure;
    let [before, behind] = docs;
    let cost = docs::cost(procedure);
    let statements = plan.procedure(procedure, |id| destination(plan, id));
    let body = body(quote!(#opening #statements), end);
    quote! {
        #before
        #(#[doc = #cost])*
        #behind
        #[allow(unused_doc_comments, unused_variables, clippy::all)]
        #name(&self, #arguments) -> #returns #body
    }
}

/// How each function looks.
fn row(plan: &Plan, answer: Answer) -> Method {
    match answer {
        Answer::Accelerations => dynamics::accelerations(plan),
        Answer::ImplicitAccelerations => dynamics::implicit_accelerations(plan),
        Answer::Solution => dynamics::solution(plan),
        Answer::Energy => dynamics::energy(plan),
        Answer::CoordinateRates => state::coordinate_rates(plan),
        Answer::Normalized => state::normalized(plan),
        Answer::Correction => state::correction(plan),
        Answer::ClosurePivots => state::closure_pivots(plan),
        Answer::Start => state::start(plan),
        Answer::BiasEfforts => dynamics::bias_efforts(plan),
    }
}

/// The type of a result, or the error of the chain.
fn fallible(plan: &Plan, ok: &TokenStream) -> TokenStream {
    let mstmm = &plan.mstmm;
    quote!(::core::result::Result<#ok, #mstmm::Error>)
}

fn of_state(plan: &Plan) -> TokenStream {
    let state = &plan.names.state;
    quote!(state_: &#state<T>,)
}

fn of_state_and_inputs(plan: &Plan) -> TokenStream {
    let (state, inputs) = (of_state(plan), &plan.names.inputs);
    quote!(#state inputs_: &#inputs<T>,)
}

/// A new array.
fn new(name: &str) -> Destination {
    Destination::New(helper(name))
}
