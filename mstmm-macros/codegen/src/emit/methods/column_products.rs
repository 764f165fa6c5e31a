//! Products with several vectors at a time, of which the matrices of long chains are made.

use super::super::arrays::usize_literal;
use super::super::names::helper;
use super::super::printer::Destination;
use super::super::procedure::body;
use super::super::{EmitContext, arguments};
use super::{fallible, of_state_and_inputs};
use crate::compile::{layouts, outputs};
use crate::model::{Answer, Request};
use crate::program::{Given, OutputId};
use proc_macro2::{Ident, TokenStream};
use quote::quote;

/// Returns whether the chain has a product with several vectors at a time: one that a matrix is computed by.
pub(super) fn is_used(cx: &EmitContext, answer: Answer) -> bool {
    let lacks = |request, matrix| {
        cx.chain.requests.contains(&request) && cx.compiled.find(matrix).is_none()
    };
    let mass_matrix = lacks(Request::MassMatrix, Answer::MassMatrix);
    let derivatives = lacks(Request::Derivatives, Answer::InverseDynamicsDerivatives);
    let linearization = lacks(Request::Linearize, Answer::Linearization);
    match answer {
        Answer::MassMatrixTimes => mass_matrix || derivatives,
        Answer::InverseMassMatrixTimes => mass_matrix || linearization,
        Answer::EffortsChange => derivatives,
        Answer::Push => linearization,
        Answer::RegressorTimes => lacks(Request::Regressor, Answer::Regressor),
        Answer::ClosureJacobianTimes => true,
        _ => false,
    }
}

/// Returns the name of a product with several vectors at a time.
pub(super) fn name(answer: Answer) -> Ident {
    helper(&format!("{}_columns", answer.name()))
}

/// Returns the private methods for products with several vectors at a time.
pub(super) fn emit(cx: &EmitContext) -> TokenStream {
    let answers = cx.compiled.functions.iter().filter_map(|function| function.answer);
    answers.filter(|&answer| is_used(cx, answer)).map(|answer| product(cx, answer)).collect()
}

/// Returns the private method for a product with several vectors, one in each column of the type `C`.
///
/// Values that do not depend on the vectors are computed once for all columns.
fn product(cx: &EmitContext, answer: Answer) -> TokenStream {
    let mstmm = &cx.mstmm;
    let (name, returns) = (name(answer), fallible(cx, &quote!(())));
    let variation = &cx.names.variation;
    let vector = |scalar: TokenStream, count: usize| {
        let count = usize_literal(count);
        quote!(#mstmm::nalgebra::SVector<#scalar, #count>)
    };
    let rates = cx.rates().total;
    let accelerations = vector(quote!(T), rates);
    let arguments = match answer {
        Answer::EffortsChange => {
            quote!(accelerations_: &#accelerations, direction_: &#variation<C>)
        }
        Answer::Push => quote!(direction_: &#variation<C>, accelerations_: &mut #accelerations),
        Answer::RegressorTimes => {
            let parameters = vector(quote!(C), layouts::dynamic_parameters(cx.chain).total);
            quote!(accelerations_: &#accelerations, parameters_: &#parameters)
        }
        _ => {
            let vector = vector(quote!(C), rates);
            quote!(vector_: &#vector)
        }
    };
    let rows = match answer {
        Answer::ClosureJacobianTimes => cx.chain.dimension.axes().len(),
        _ => rates,
    };
    let (state, product) = (of_state_and_inputs(cx), vector(quote!(C), rows));
    let destination = |id: OutputId| match id {
        outputs::ACCELERATIONS => Destination::Vector(quote!((*accelerations_))),
        _ => Destination::Vector(quote!((*product_))),
    };
    let procedure = &cx.compiled.function(answer).procedure;
    let statements = cx.procedure_of_columns(procedure, destination);
    let body = body(statements, quote!(::core::result::Result::Ok(())));
    quote! {
        #[allow(unused_doc_comments, unused_variables, clippy::all)]
        fn #name<C: #mstmm::Columns<T>>(
            &self,
            #state
            #arguments,
            product_: &mut #product,
        ) -> #returns #body
    }
}

/// Returns the statements of the method for a product with one vector, a single column: first the test of the vector, which
/// the method for several columns omits.
pub(super) fn of_one_vector(cx: &EmitContext, answer: Answer) -> TokenStream {
    let (mstmm, name) = (&cx.mstmm, name(answer));
    let check = |given| {
        let (name, vector) = arguments::given(given);
        quote!(#mstmm::generated::check_argument::<T>(#name, #vector.as_slice())?;)
    };
    let (checks, arguments): (TokenStream, _) = match answer {
        Answer::Push => {
            let direction = [
                Given::CoordinateDirection,
                Given::RateDirection,
                Given::InputDirection,
                Given::ParameterDirection,
            ];
            (
                direction.map(check).into_iter().collect(),
                quote!(direction_, accelerations_, change_),
            )
        }
        Answer::RegressorTimes => {
            (check(Given::DynamicParameters), quote!(accelerations_, parameters_, product_))
        }
        _ => (check(Given::Vector), quote!(vector_, product_)),
    };
    quote! {
        #checks
        self.#name::<T>(state_, inputs_, #arguments)?;
    }
}
