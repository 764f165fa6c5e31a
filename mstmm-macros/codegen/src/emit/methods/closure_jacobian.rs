//! The methods for the constraint Jacobian of a closed chain.

use super::super::arrays::usize_literal;
use super::super::printer::Destination;
use super::super::{EmitContext, quaternions};
use super::dynamics::of_vector;
use super::{MethodTemplate, column_products, fallible, of_state_and_inputs};
use crate::model::Answer;
use proc_macro2::TokenStream;
use quote::quote;

pub(super) fn times(cx: &EmitContext) -> MethodTemplate {
    let (mstmm, visibility) = (&cx.mstmm, &cx.passthrough.visibility);
    let (given, rows) = (of_vector(cx), usize_literal(cx.chain.dimension.axes().len()));
    MethodTemplate {
        name: quote!(#visibility fn closure_jacobian_times_into),
        docs: [
            quote! {
                /// Computes the product `G x` of the constraint [Jacobian](Self::closure_jacobian_into) with a vector of
                /// one entry per rate.
            },
            quote! {
                ///
                /// # Errors
                ///
                /// `Error::NotFinite` if the state, the inputs or the vector are not finite. `product` is then unchanged.
            },
        ],
        arguments: quote!(#given product_: &mut #mstmm::nalgebra::SVector<T, #rows>,),
        returns: fallible(cx, &quote!(())),
        opening: TokenStream::new(),
        end: quote!(::core::result::Result::Ok(())),
        destination: |_, _| Destination::Vector(quote!((*product_))),
    }
}

/// Returns the constraint Jacobian by columns, if the chain has its product.
pub(super) fn matrix(cx: &EmitContext) -> TokenStream {
    if cx.compiled.find(Answer::ClosureJacobianTimes).is_none() {
        return TokenStream::new();
    }
    let (mstmm, visibility) = (&cx.mstmm, &cx.passthrough.visibility);
    let (given, near_one) = (of_state_and_inputs(cx), quaternions::near_one(cx));
    let rows = usize_literal(cx.chain.dimension.axes().len());
    let columns = usize_literal(cx.rates().total);
    let (checked, errors) = (quaternions::checked(cx), quaternions::error(cx));
    let times = column_products::name(Answer::ClosureJacobianTimes);
    quote! {
        #[doc(alias("constraint Jacobian", "getConstraintJacobian", "getConstraintsJacobian", "efc_J", "loop closure", "KKT", "Lagrange multiplier"))]
        /// Computes the constraint Jacobian `G` of the closed chain: `G v` is the velocity of the outboard side of the
        /// closing hinge relative to its inboard side, if the hinge is opened, less that of the hinge itself. It has one
        /// row for each direction, linear then angular, in the axes of the outboard frame of the hinge, and one column for
        /// each rate, in the order of `v` of the state.
        ///
        /// Rates that keep the chain closed have `G v = 0`, if moving ends and prescribed motions rest. A basis of them
        /// follows by `linear::null_space`. Accelerations that keep it closed are those of `accelerations` plus any
        /// combination of this basis. The closed chain moves as `M v̇ + bias = τ + Gᵀ λ`, with `M` and `bias` of the open
        /// chain (the KKT conditions). `λ` is minus the force and the moment at the output of the closing hinge.
        #(#[doc = #near_one])*
        ///
        /// # Errors
        ///
        /// `Error::NotFinite` if the state or the inputs are not finite. `jacobian` is then unchanged.
        #visibility fn closure_jacobian_into(
            &self,
            #given
            jacobian_: &mut #mstmm::nalgebra::SMatrix<T, #rows, #columns>,
        ) -> ::core::result::Result<(), #mstmm::Error> {
            self.#times(state_, inputs_, |products_| {
                #mstmm::generated::columns(jacobian_, products_)
            })
        }
        /// Returns the constraint Jacobian; see [`closure_jacobian_into`](Self::closure_jacobian_into).
        ///
        /// # Errors
        ///
        /// Those of [`closure_jacobian_into`](Self::closure_jacobian_into).
        #(#[doc = #errors])*
        #visibility fn closure_jacobian(
            &self,
            #given
        ) -> ::core::result::Result<#mstmm::nalgebra::SMatrix<T, #rows, #columns>, #mstmm::Error> {
            #checked
            let mut jacobian_ = #mstmm::generated::matrix([[T::constant(0.0); #rows]; #columns]);
            self.closure_jacobian_into(state_, inputs_, &mut jacobian_)?;
            ::core::result::Result::Ok(jacobian_)
        }
    }
}
