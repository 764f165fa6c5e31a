//! The methods of the regressor, and the names of its columns.

use super::super::arrays::usize_literal;
use super::super::printer::Destination;
use super::super::{EmitContext, quaternions, variation};
use super::dynamics::{lent_rates, of_accelerations};
use super::{MethodTemplate, column_products, fallible, new};
use crate::compile::layouts;
use crate::model::{Answer, Request};
use proc_macro2::{Literal, TokenStream};
use quote::quote;

/// Returns rows and columns of the regressor.
pub(super) fn size(cx: &EmitContext) -> (Literal, Literal) {
    let columns = layouts::dynamic_parameters(cx.chain).total;
    (usize_literal(cx.rates().total), usize_literal(columns))
}

/// The docs of the regressor.
fn docs_of_regressor(cx: &EmitContext) -> [TokenStream; 2] {
    let (near_one, entries) = (quaternions::near_one(cx), entries(cx));
    [
        quote! {
            #[doc(alias("computeJointTorqueRegressor", "identification", "inertial parameters", "inverse dynamics regressor"))]
            /// Computes the regressor `Y`, the matrix that maps the dynamic parameters `π` to the efforts of inverse
            /// dynamics: `Y π` are the efforts for given accelerations, less those against loads, springs between
            /// bodies and limits.
            ///
            /// It has one row for each rate, in the order of `v` of the state, and one column for each dynamic
            /// parameter. It does not depend on the values of these parameters.
            #(#[doc = #near_one])*
            ///
            #(#[doc = #entries])*
        },
        quote! {
            ///
            /// # Errors
            ///
            /// `Error::NotFinite` if the state, the inputs or the accelerations are not finite. Entries of `regressor`
            /// may then be overwritten. Entries may overflow where a length, a rate or an acceleration exceeds 1e150, in
            /// `f32` 1e18.
        },
    ]
}

/// Returns the docs of the order of the dynamic parameters.
fn entries(cx: &EmitContext) -> Vec<String> {
    let parameters = cx.chain.dynamic_parameters().into_iter();
    let named = |parameter| (format!("`{}`", cx.chain.name_of_dynamic_parameter(parameter)), 1);
    let head = " The dynamic parameters, in SI units; first moments are mass times centre of mass, inertias are about the \
                input of a body, in its axes";
    variation::documented(
        head,
        &parameters.map(named).collect::<Vec<_>>(),
        &layouts::dynamic_parameters(cx.chain),
    )
}

pub(super) fn regressor_times(cx: &EmitContext) -> MethodTemplate {
    let (mstmm, visibility) = (&cx.mstmm, &cx.passthrough.visibility);
    let (given, lent) = (of_accelerations(cx), lent_rates(cx, &quote!(product_)));
    let (_, columns) = size(cx);
    MethodTemplate {
        name: quote!(#visibility fn regressor_times_into),
        docs: [
            quote! {
                /// Computes the product `Y π` of the [regressor](Self::regressor_into) with any values of the dynamic
                /// parameters, in O(n) and without the matrix, in the order of `v` of the state.
            },
            quote! {
                ///
                /// # Errors
                ///
                /// `Error::NotFinite` if the state, the inputs, the accelerations or the parameters are not finite.
                /// `product` is then unchanged.
            },
        ],
        arguments: quote!(#given parameters_: &#mstmm::nalgebra::SVector<T, #columns>, #lent),
        returns: fallible(cx, &quote!(())),
        opening: TokenStream::new(),
        end: quote!(::core::result::Result::Ok(())),
        destination: |_, _| Destination::Vector(quote!((*product_))),
    }
}

pub(super) fn regressor(cx: &EmitContext) -> MethodTemplate {
    let (mstmm, visibility) = (&cx.mstmm, &cx.passthrough.visibility);
    let given = of_accelerations(cx);
    let (rows, columns) = size(cx);
    MethodTemplate {
        name: quote!(#visibility fn regressor_into),
        docs: docs_of_regressor(cx),
        arguments: quote!(#given regressor_: &mut #mstmm::nalgebra::SMatrix<T, #rows, #columns>,),
        returns: fallible(cx, &quote!(())),
        opening: TokenStream::new(),
        end: quote!(::core::result::Result::Ok(())),
        destination: |cx, _| Destination::Matrix(quote!((*regressor_)), cx.rates().total),
    }
}

pub(super) fn dynamic_parameters(cx: &EmitContext) -> MethodTemplate {
    let (mstmm, visibility) = (&cx.mstmm, &cx.passthrough.visibility);
    let (_, columns) = size(cx);
    MethodTemplate {
        name: quote!(#[must_use] #visibility fn dynamic_parameters),
        docs: [
            quote! {
                #[doc(alias("toDynamicParameters", "inertial parameters"))]
                /// Returns the dynamic parameters `π` of the chain, in the order of the columns of the
                /// [regressor](Self::regressor_into).
            },
            TokenStream::new(),
        ],
        arguments: TokenStream::new(),
        returns: quote!(#mstmm::nalgebra::SVector<T, #columns>),
        opening: TokenStream::new(),
        end: quote!(#mstmm::generated::vector(dynamic_parameters_)),
        destination: |_, _| new("dynamic_parameters"),
    }
}

/// Returns the forms of the regressor that are no procedures, and the names of its columns.
pub(super) fn others(cx: &EmitContext) -> TokenStream {
    if !cx.chain.requests.contains(&Request::Regressor) {
        return TokenStream::new();
    }
    let (mstmm, visibility) = (&cx.mstmm, &cx.passthrough.visibility);
    let given = of_accelerations(cx);
    let (rows, columns) = size(cx);
    let (checked, errors) = (quaternions::checked(cx), quaternions::error(cx));
    let names = cx.chain.repeats.is_empty().then(|| names(cx));
    let by_columns = cx.compiled.find(Answer::Regressor).is_none().then(|| by_columns(cx));
    quote! {
        #names
        #by_columns
        /// Returns the regressor; see [`regressor_into`](Self::regressor_into).
        ///
        /// # Errors
        ///
        /// Those of [`regressor_into`](Self::regressor_into).
        #(#[doc = #errors])*
        #visibility fn regressor(
            &self,
            #given
        ) -> ::core::result::Result<#mstmm::nalgebra::SMatrix<T, #rows, #columns>, #mstmm::Error> {
            #checked
            let mut regressor_ = #mstmm::generated::matrix([[T::constant(0.0); #rows]; #columns]);
            self.regressor_into(state_, accelerations_, inputs_, &mut regressor_)?;
            ::core::result::Result::Ok(regressor_)
        }
    }
}

/// Returns the names of the columns, and the base parameters.
fn names(cx: &EmitContext) -> TokenStream {
    let visibility = &cx.passthrough.visibility;
    let (_, columns) = size(cx);
    let parameters = cx.chain.dynamic_parameters().into_iter();
    let names = parameters.map(|parameter| cx.chain.name_of_dynamic_parameter(parameter));
    let base = cx.findings.base_parameters.iter().map(|&number| usize_literal(number));
    let base_count = usize_literal(cx.findings.base_parameters.len());
    quote! {
        /// The names of the dynamic parameters, by the columns of the regressor.
        #visibility const DYNAMIC_PARAMETERS: [&'static ::core::primitive::str; #columns] = [#(#names),*];
        /// The indices of dynamic parameters whose columns are independent: the base parameters. The column of every other
        /// parameter is a combination of theirs, in every state and for all inputs, so no motion can tell its value from
        /// theirs. They are the first with independent columns, from the ground outward. Prescribed motions and gravity as an
        /// input must vary for all base parameters to be identified. States of a closed chain need not fulfil its loop
        /// constraints.
        ///
        /// Found numerically, with parameters at their defaults; empty if the description has Rust constants.
        #visibility const BASE_PARAMETERS: [::core::primitive::usize; #base_count] = [#(#base),*];
    }
}

/// Returns the regressor of a chain that does not write it out: its columns are products.
fn by_columns(cx: &EmitContext) -> TokenStream {
    let (mstmm, visibility) = (&cx.mstmm, &cx.passthrough.visibility);
    let given = of_accelerations(cx);
    let (rows, columns) = size(cx);
    let [before, after] = docs_of_regressor(cx);
    let times = column_products::name(Answer::RegressorTimes);
    quote! {
        #before
        #after
        #visibility fn regressor_into(
            &self,
            #given
            regressor_: &mut #mstmm::nalgebra::SMatrix<T, #rows, #columns>,
        ) -> ::core::result::Result<(), #mstmm::Error> {
            self.#times(state_, inputs_, accelerations_, |products_| {
                #mstmm::generated::columns(regressor_, products_)
            })
        }
    }
}
