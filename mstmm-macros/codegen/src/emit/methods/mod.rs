//! The generated methods, one for each function of the table.

mod body_jacobian;
mod by_columns;
mod closure_jacobian;
mod column_products;
mod derivatives;
mod dynamics;
mod inverse_dynamics;
mod kinematics;
mod mass_matrix;
mod momentum;
mod negative_products;
mod packed;
mod products;
mod regressor;
mod regressor_by_rates;
mod state;

use super::names::helper;
use super::printer::Destination;
use super::procedure::body;
use super::{EmitContext, chain_impl, docs};
use crate::compile::CompiledFunction;
use crate::model::Answer;
use crate::program::{OutputId, Procedure};
use proc_macro2::TokenStream;
use quote::quote;

/// The signature and the docs of a generated method.
struct MethodTemplate {
    /// Attributes, visibility and name.
    name: TokenStream,
    /// The docs before and after the table of operation counts.
    docs: [TokenStream; 2],
    /// The arguments after `&self`.
    arguments: TokenStream,
    /// The return type.
    returns: TokenStream,
    /// Statements before those of the procedure.
    opening: TokenStream,
    /// Statements and value after those of the procedure.
    end: TokenStream,
    /// Returns the destination of a result.
    destination: fn(&EmitContext, OutputId) -> Destination,
}

/// Returns the chain's methods and its implementations of traits.
pub fn emit(cx: &EmitContext) -> TokenStream {
    let mstmm = &cx.mstmm;
    let name = &cx.names.chain;
    let functions = cx.compiled.functions.iter();
    let functions = functions.filter(|function| !function.answer.is_some_and(is_part));
    let methods = functions.map(|function| method(cx, function));
    let by_value = dynamics::by_value(cx);
    let (derivatives, products) = (derivatives::by_value(cx), products::by_value(cx));
    let energy = chain_impl::energy(cx);
    let closure_jacobian = closure_jacobian::matrix(cx);
    let (by_columns, linearize) = (by_columns::emit(cx), by_columns::linearize_trait(cx));
    let column_products = column_products::emit(cx);
    let body_jacobians = body_jacobian::emit(cx);
    let momentum_matrix = momentum::by_value(cx);
    let regressor = regressor::others(cx);
    let kinematics = kinematics::further(cx);
    let chain_impl = chain_impl::chain_impl(cx);
    let generated = chain_impl::generated(cx);
    let not_asked = chain_impl::not_asked(cx);
    quote! {
        #[allow(dead_code, non_snake_case)]
        impl<T: #mstmm::Scalar> #name<T> {
            #(#methods)*
            #(#by_value)*
            #derivatives
            #products
            #energy
            #closure_jacobian
            #regressor
            #column_products
            #by_columns
            #momentum_matrix
            #kinematics
            #body_jacobians
        }
        #chain_impl
        #generated
        #linearize
        #not_asked
    }
}

/// Returns whether an answer is only part of another one: a product with several vectors, or the motions that a matrix is
/// made of.
fn is_part(answer: Answer) -> bool {
    matches!(answer, Answer::EffortsChange | Answer::RegressorMotions)
}

/// Returns a table of the operations of all functions that the description asks for, for the docs of the chain.
pub fn operations(cx: &EmitContext) -> Vec<String> {
    let row = |name: String, procedure: &Procedure| {
        let cost = procedure.cost();
        format!(" | [`{name}`](Self::{name}) | {} | {cost} |", cost.arithmetic())
    };
    let requested = cx.compiled.functions.iter().filter_map(|function| {
        let is_public = |answer: &Answer| answer.is_requested() && !is_part(*answer);
        let answer = function.answer.filter(is_public)?;
        let name = template(cx, answer).name.into_iter().last()?.to_string();
        Some(row(name, &function.procedure))
    });
    let of_bodies = cx.compiled.jacobians.iter();
    let of_bodies =
        of_bodies.map(|(body, procedure)| row(body_jacobian::name(cx, *body), procedure));
    let rows: Vec<String> = requested.chain(of_bodies).collect();
    if rows.is_empty() {
        return rows;
    }
    let head =
        [String::new(), " | answer | operations | in detail |".into(), " |---|---|---|".into()];
    head.into_iter().chain(rows).collect()
}

/// Returns the method of a function.
fn method(cx: &EmitContext, function: &CompiledFunction) -> TokenStream {
    let Some(answer) = function.answer else { bug!("the setup is no method") };
    let MethodTemplate { name, docs, arguments, returns, opening, end, destination } =
        template(cx, answer);
    let procedure = &function.procedure;
    let [before, after] = docs;
    let fresh = fresh(answer);
    let cost = docs::cost(procedure);
    let statements = match function.by_columns {
        true => column_products::of_one_vector(cx, answer),
        false => cx.procedure(procedure, &fresh, |id| destination(cx, id)),
    };
    let (dispatch, packed) = match answer {
        Answer::Regressor => regressor_by_rates::emit(cx),
        _ => packed::emit(cx, function),
    };
    let body = body([dispatch, opening, statements, end]);
    quote! {
        #packed
        #before
        #(#[doc = #cost])*
        #after
        #[allow(unused_doc_comments, unused_variables, clippy::all)]
        #name(&self, #arguments) -> #returns #body
    }
}

/// Returns the value of results after a failure.
fn fresh(answer: Answer) -> TokenStream {
    match answer {
        Answer::Kinematics => quote!(::core::default::Default::default()),
        _ => quote!(self.workspace()),
    }
}

/// Returns the template of the method for an answer.
fn template(cx: &EmitContext, answer: Answer) -> MethodTemplate {
    match answer {
        Answer::Accelerations => dynamics::accelerations(cx),
        Answer::ImplicitAccelerations => dynamics::implicit_accelerations(cx),
        Answer::Solution => dynamics::solution(cx),
        Answer::Energy => dynamics::energy(cx),
        Answer::CoordinateRates => state::coordinate_rates(cx),
        Answer::Normalized => state::normalized(cx),
        Answer::Correction => state::correction(cx),
        Answer::ClosurePivots => state::closure_pivots(cx),
        Answer::Start => state::start(cx),
        Answer::BiasEfforts => inverse_dynamics::bias_efforts(cx),
        Answer::InverseDynamics => inverse_dynamics::inverse_dynamics(cx),
        Answer::GravityEfforts => inverse_dynamics::gravity_efforts(cx),
        Answer::PassiveEfforts => inverse_dynamics::passive_efforts(cx),
        Answer::InverseSolution => inverse_dynamics::inverse_solution(cx),
        Answer::MassMatrixTimes => inverse_dynamics::mass_matrix_times(cx),
        Answer::InverseMassMatrixTimes => inverse_dynamics::inverse_mass_matrix_times(cx),
        Answer::Push => products::push(cx),
        Answer::EffortsChange => bug!("the change of efforts is no public method"),
        Answer::Pull => products::pull(cx),
        Answer::ClosureJacobianTimes => closure_jacobian::times(cx),
        Answer::Regressor => regressor::regressor(cx),
        Answer::RegressorTimes => regressor::regressor_times(cx),
        Answer::DynamicParameters => regressor::dynamic_parameters(cx),
        Answer::MassMatrix => mass_matrix::mass_matrix(cx),
        Answer::InverseMassMatrix => mass_matrix::inverse_mass_matrix(cx),
        Answer::InverseDynamicsDerivatives => derivatives::inverse_dynamics_derivatives(cx),
        Answer::Linearization => derivatives::linearization(cx),
        Answer::Kinematics => kinematics::kinematics(cx),
        Answer::Momentum => momentum::momentum(cx),
        Answer::MomentumMatrix => momentum::momentum_matrix(cx),
        Answer::CoriolisMatrixTimes => inverse_dynamics::coriolis_matrix_times(cx),
        Answer::CoriolisMatrix => mass_matrix::coriolis_matrix(cx),
        Answer::RegressorMotions => bug!("the motions of a regressor are no public method"),
    }
}

/// Returns the type `Result<ok, mstmm::Error>`.
fn fallible(cx: &EmitContext, ok: &TokenStream) -> TokenStream {
    let mstmm = &cx.mstmm;
    quote!(::core::result::Result<#ok, #mstmm::Error>)
}

fn of_state(cx: &EmitContext) -> TokenStream {
    let state = &cx.names.state;
    quote!(state_: &#state<T>,)
}

fn of_state_and_inputs(cx: &EmitContext) -> TokenStream {
    let (state, inputs) = (of_state(cx), &cx.names.inputs);
    quote!(#state inputs_: &#inputs<T>,)
}

/// Returns a new array as destination.
fn new(name: &str) -> Destination {
    Destination::New(helper(name))
}
