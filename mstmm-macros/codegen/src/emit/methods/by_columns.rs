//! The matrices of long chains: loops over columns, each the product with a unit vector, several at a time. Their code does
//! not depend on the number of columns.

use super::super::EmitContext;
use super::super::arrays::usize_literal;
use super::column_products;
use super::derivatives::{docs_of_derivatives, docs_of_linearization, set_state};
use super::dynamics::of_accelerations;
use super::mass_matrix::{docs_of_coriolis_matrix, docs_of_inverse, docs_of_mass_matrix, square};
use super::{fallible, of_state_and_inputs};
use crate::compile::layouts;
use crate::model::{Answer, Request};
use crate::program::Segment;
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

/// Returns the methods for matrices that a chain does not write out.
pub(super) fn emit(cx: &EmitContext) -> TokenStream {
    let asks = |request| cx.chain.requests.contains(&request);
    let has = |answer| cx.compiled.find(answer).is_some();
    let mut methods = TokenStream::new();
    if asks(Request::MassMatrix) && !has(Answer::MassMatrix) {
        let times = Answer::MassMatrixTimes;
        methods.extend(matrix(cx, "mass_matrix", times, docs_of_mass_matrix(cx)));
        if has(Answer::InverseMassMatrixTimes) {
            let times = Answer::InverseMassMatrixTimes;
            methods.extend(matrix(cx, "inverse_mass_matrix", times, docs_of_inverse(cx)));
        }
    }
    if asks(Request::CoriolisMatrix) && !has(Answer::CoriolisMatrix) {
        let times = Answer::CoriolisMatrixTimes;
        methods.extend(matrix(cx, "coriolis_matrix", times, docs_of_coriolis_matrix(cx)));
    }
    if asks(Request::Derivatives) && !has(Answer::InverseDynamicsDerivatives) {
        methods.extend(derivatives(cx));
    }
    if asks(Request::Linearize) && !has(Answer::Linearization) {
        methods.extend(linearization(cx));
    }
    methods
}

/// Returns the method for a matrix from its products.
fn matrix(
    cx: &EmitContext,
    name: &str,
    times: Answer,
    [before, after]: [TokenStream; 2],
) -> TokenStream {
    let (mstmm, visibility) = (&cx.mstmm, &cx.passthrough.visibility);
    let (given, matrix, returns) = (of_state_and_inputs(cx), square(cx), fallible(cx, &quote!(())));
    let (into, times) = (format_ident!("{name}_into"), column_products::name(times));
    quote! {
        #before
        #after
        #visibility fn #into(&self, #given matrix_: &mut #matrix) -> #returns {
            self.#times(state_, inputs_, |products_| {
                #mstmm::generated::columns(matrix_, products_)
            })
        }
    }
}

fn derivatives(cx: &EmitContext) -> TokenStream {
    let (mstmm, visibility) = (&cx.mstmm, &cx.passthrough.visibility);
    let (given, returns) = (of_accelerations(cx), fallible(cx, &quote!(())));
    let (derivatives, variation) = (&cx.names.derivatives, &cx.names.variation);
    let [before, after] = docs_of_derivatives(cx);
    let columns = columns_type(cx);
    let change = column_products::name(Answer::EffortsChange);
    let times = column_products::name(Answer::MassMatrixTimes);
    quote! {
        #before
        #after
        #visibility fn inverse_dynamics_derivatives_into(
            &self,
            #given
            derivatives_: &mut #derivatives<T>,
        ) -> #returns {
            self.#change(state_, inputs_, accelerations_, |products_| {
                let mut direction_ = <#variation<#columns> as ::core::default::Default>::default();
                #mstmm::generated::columns_of_part(
                    &mut derivatives_.by_coordinates,
                    (&mut direction_, |direction_| &mut direction_.coordinates),
                    &mut *products_,
                )?;
                #mstmm::generated::columns_of_part(
                    &mut derivatives_.by_rates,
                    (&mut direction_, |direction_| &mut direction_.rates),
                    products_,
                )
            })?;
            self.#times(state_, inputs_, |products_| {
                #mstmm::generated::columns(&mut derivatives_.by_accelerations, products_)
            })
        }
    }
}

fn linearization(cx: &EmitContext) -> TokenStream {
    let (mstmm, visibility) = (&cx.mstmm, &cx.passthrough.visibility);
    let (given, returns) = (of_state_and_inputs(cx), fallible(cx, &quote!(())));
    let (linearization, variation) = (&cx.names.linearization, &cx.names.variation);
    let [before, after] = docs_of_linearization(cx);
    let set_state = set_state(cx);
    let columns = columns_type(cx);
    let push = column_products::name(Answer::Push);
    let times = column_products::name(Answer::InverseMassMatrixTimes);
    let motors = motor_columns(cx);
    let along = ["coordinates", "rates", "inputs", "parameters"].map(|name| {
        let (field, result) = (format_ident!("{name}"), format_ident!("by_{name}"));
        let (columns_of, known) = match name {
            "inputs" => {
                let known = quote!((&linearization_.inverse_mass_matrix, &#motors),);
                (quote!(input_columns), known)
            }
            _ => (quote!(columns_of_part), TokenStream::new()),
        };
        quote! {
            #mstmm::generated::#columns_of(
                &mut linearization_.#result,
                #known
                (&mut direction_, |direction_| &mut direction_.#field),
                &mut *products_,
            )?;
        }
    });
    quote! {
        #before
        #after
        #visibility fn linearize_into(
            &self,
            #given
            linearization_: &mut #linearization<T>,
        ) -> #returns {
            self.#times(state_, inputs_, |products_| {
                #mstmm::generated::columns(&mut linearization_.inverse_mass_matrix, products_)
            })?;
            let accelerations_ = &mut linearization_.accelerations;
            self.#push(state_, inputs_, accelerations_, |products_| {
                let mut direction_ = <#variation<#columns> as ::core::default::Default>::default();
                #(#along)*
                ::core::result::Result::Ok(())
            })?;
            #set_state
            ::core::result::Result::Ok(())
        }
    }
}

/// Returns which columns of the inputs are columns of the inverse mass matrix.
fn motor_columns(cx: &EmitContext) -> TokenStream {
    let mstmm = &cx.mstmm;
    let (inputs, rates) = (layouts::inputs(cx.chain, cx.layout), cx.rates());
    let driven = cx.layout.driven_rates(cx.chain).into_iter().enumerate();
    let columns = driven.filter_map(|(entry, rate)| Some((entry, rate?))).map(|(entry, rate)| {
        let segments = [inputs.segment_of(entry), rates.segment_of(rate)];
        let first = |segment: &Segment, entry| segment.offset + entry - segment.first;
        let [input, rate] =
            [first(segments[0], entry), first(segments[1], rate)].map(usize_literal);
        let strides = segments.map(|segment| usize_literal(segment.count));
        let repetitions = usize_literal(segments[0].repetitions);
        quote! {
            #mstmm::generated::MotorColumns {
                input: #input,
                rate: #rate,
                strides: [#(#strides),*],
                repetitions: #repetitions,
            }
        }
    });
    quote!([#(#columns),*])
}

/// Returns the type of several columns.
fn columns_type(cx: &EmitContext) -> TokenStream {
    let mstmm = &cx.mstmm;
    quote!(<T as #mstmm::Scalar>::Columns)
}

/// Returns the implementation of the trait that the discrete model of a step needs.
pub(super) fn linearize_trait(cx: &EmitContext) -> TokenStream {
    if !cx.chain.requests.contains(&Request::Linearize) {
        return TokenStream::new();
    }
    let (mstmm, name) = (&cx.mstmm, &cx.names.chain);
    let (state, inputs) = (&cx.names.state, &cx.names.inputs);
    let linearization = &cx.names.linearization;
    let rates = usize_literal(cx.rates().total);
    let count = crate::compile::layouts::inputs(cx.chain, cx.layout).total;
    let count = usize_literal(count);
    let returns = fallible(cx, &quote!(()));
    quote! {
        impl<T: #mstmm::Scalar> #mstmm::linear::Linearize<#rates, #count> for #name<T> {
            fn linearize_into(
                &self,
                state_: &#state<T>,
                inputs_: &#inputs<T>,
                at_: &mut #mstmm::linear::ContinuousModel<T, #rates, #count>,
            ) -> #returns {
                let mut linearization_ = <#linearization<T> as ::core::default::Default>::default();
                #name::linearize_into(self, state_, inputs_, &mut linearization_)?;
                linearization_.write_to(at_);
                ::core::result::Result::Ok(())
            }
        }
    }
}
