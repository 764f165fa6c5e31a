//! Products with several vectors at a time, of which the matrices of long chains are made.

use super::super::arrays::usize_literal;
use super::super::names::helper;
use super::super::printer::Destination;
use super::super::procedure::body;
use super::super::{EmitContext, arguments};
use super::{fallible, of_state_and_inputs};
use crate::compile::{layouts, outputs};
use crate::model::Answer;
use crate::program::{Given, OutputId};
use proc_macro2::{Ident, TokenStream};
use quote::quote;

/// Returns the name of a product with several vectors at a time.
pub(super) fn name(answer: Answer) -> Ident {
    helper(&format!("{}_columns", answer.name()))
}

/// Returns the private methods for products with several vectors at a time.
pub(super) fn emit(cx: &EmitContext) -> TokenStream {
    let functions = cx.compiled.functions.iter().filter(|function| function.by_columns);
    functions.filter_map(|function| function.answer).map(|answer| product(cx, answer)).collect()
}

/// Returns the private method for products with several vectors, one in each column of the type `C`.
///
/// It computes all values that do not depend on the vectors, then calls `products_` with the function for the rest.
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
    let accelerations = match answer {
        Answer::EffortsChange | Answer::RegressorTimes => quote!(accelerations_: &#accelerations,),
        Answer::Push => quote!(accelerations_: &mut #accelerations,),
        _ => TokenStream::new(),
    };
    let factor = match answer {
        Answer::EffortsChange | Answer::Push => quote!(#variation<C>),
        Answer::RegressorTimes => vector(quote!(C), layouts::dynamic_parameters(cx.chain).total),
        _ => vector(quote!(C), rates),
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
    let [once, columns] = cx.procedure_of_columns(procedure, destination);
    let factor_name = factor_name(answer);
    let columns = body([columns, quote!(::core::result::Result::Ok(()))]);
    let once = body([
        once,
        quote!(products_(&mut |#factor_name: &#factor, product_: &mut #product| #columns)),
    ]);
    quote! {
        #[allow(unused_doc_comments, unused_variables, clippy::all)]
        fn #name<C: #mstmm::Columns<T>>(
            &self,
            #state
            #accelerations
            products_: impl ::core::ops::FnOnce(
                &mut dyn ::core::ops::FnMut(&#factor, &mut #product) -> #returns,
            ) -> #returns,
        ) -> #returns #once
    }
}

/// Returns the variable of the factor.
fn factor_name(answer: Answer) -> TokenStream {
    match answer {
        Answer::EffortsChange | Answer::Push => quote!(direction_),
        Answer::RegressorTimes => quote!(parameters_),
        _ => quote!(vector_),
    }
}

/// Returns the variable of the caller's result.
fn product_name(answer: Answer) -> TokenStream {
    match answer {
        Answer::Push => quote!(change_),
        _ => quote!(product_),
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
    let (factor, product) = (factor_name(answer), product_name(answer));
    let (factors, accelerations) = match answer {
        Answer::Push => {
            let direction = vec![
                Given::CoordinateDirection,
                Given::RateDirection,
                Given::InputDirection,
                Given::ParameterDirection,
            ];
            (direction, quote!(&mut accelerations_found_,))
        }
        Answer::RegressorTimes => (vec![Given::DynamicParameters], quote!(accelerations_,)),
        _ => (vec![Given::Vector], TokenStream::new()),
    };
    let checks = factors.into_iter().map(check);
    let [before, after] = match answer {
        Answer::Push => [
            quote!(let mut accelerations_found_ = *accelerations_;),
            quote!(*accelerations_ = accelerations_found_;),
        ],
        _ => [TokenStream::new(), TokenStream::new()],
    };
    // The results of the caller stay unchanged after a failure.
    quote! {
        #(#checks)*
        let mut found_ = *#product;
        #before
        self.#name::<T>(state_, inputs_, #accelerations |products_| {
            products_(#factor, &mut found_)
        })?;
        *#product = found_;
        #after
    }
}
