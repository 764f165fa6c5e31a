//! The methods for momentum.

use super::super::arrays::usize_literal;
use super::super::{EmitContext, quaternions};
use super::{MethodTemplate, fallible, new, of_state_and_inputs};
use crate::model::{Dimension, Request};
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

/// Returns the type of the matrix.
fn matrix(cx: &EmitContext) -> TokenStream {
    let mstmm = &cx.mstmm;
    let rows = usize_literal(cx.chain.dimension.axes().len());
    let columns = usize_literal(cx.rates().total);
    quote!(#mstmm::nalgebra::SMatrix<T, #rows, #columns>)
}

pub(super) fn momentum(cx: &EmitContext) -> MethodTemplate {
    let (mstmm, visibility) = (&cx.mstmm, &cx.passthrough.visibility);
    let name = match cx.chain.dimension {
        Dimension::Space => "Momentum",
        Dimension::Plane => "PlaneMomentum",
        Dimension::Line => "LineMomentum",
    };
    let (given, name) = (of_state_and_inputs(cx), format_ident!("{name}"));
    MethodTemplate {
        name: quote!(#visibility fn momentum),
        docs: [
            quote! {
                #[doc(alias("centroidal momentum", "computeCentroidalMomentum", "center of mass", "centerOfMass", "subtree_com", "subtree_linvel", "CalcCenterOfMassPositionInWorld", "mj_comPos", "mj_subtreeVel", "CalcTotalMass", "computeTotalMass"))]
                /// Returns mass, centre of mass, linear momentum, and angular momentum about the centre of mass, in
                /// inertial axes.
            },
            quote! {
                ///
                /// # Errors
                ///
                /// `Error::NotFinite` if the state or the inputs are not finite.
            },
        ],
        arguments: given,
        returns: fallible(cx, &quote!(#mstmm::#name<T>)),
        opening: quaternions::checked(cx),
        end: quote!(::core::result::Result::Ok(#mstmm::#name::of(momentum_))),
        destination: |_, _| new("momentum"),
    }
}

pub(super) fn momentum_matrix(cx: &EmitContext) -> MethodTemplate {
    let visibility = &cx.passthrough.visibility;
    let (given, matrix, near_one) =
        (of_state_and_inputs(cx), matrix(cx), quaternions::near_one(cx));
    MethodTemplate {
        name: quote!(#visibility fn momentum_matrix_into),
        docs: [
            quote! {
                #[doc(alias("centroidal momentum matrix", "CMM", "computeCentroidalMap", "ccrba", "jacobianCenterOfMass", "getJacobianComFromCrba", "mj_jacSubtreeCom", "CalcJacobianCenterOfMassTranslationalVelocity"))]
                /// Computes the matrix that maps the rates `v` to linear momentum and angular momentum about the centre
                /// of mass, in kg m/s and kg m²/s, in inertial axes. It has one row for each direction, linear then
                /// angular, and one column for each rate, in the order of `v` of the state. The linear rows divided by
                /// the mass are the Jacobian of the centre of mass. Moving ends and prescribed motions add momentum that is
                /// not part of it.
                #(#[doc = #near_one])*
            },
            quote! {
                ///
                /// # Errors
                ///
                /// `Error::NotFinite` if the state or the inputs are not finite. `matrix` is then unchanged.
            },
        ],
        arguments: quote!(#given matrix_: &mut #matrix,),
        returns: fallible(cx, &quote!(())),
        opening: TokenStream::new(),
        end: quote! {
            matrix_.iter_mut().zip(momentum_).for_each(|(entry_, value_)| *entry_ = value_);
            ::core::result::Result::Ok(())
        },
        destination: |_, _| new("momentum"),
    }
}

/// Returns the form of the matrix that returns by value.
pub(super) fn by_value(cx: &EmitContext) -> TokenStream {
    if !cx.chain.requests.contains(&Request::Momentum) {
        return TokenStream::new();
    }
    let (mstmm, visibility) = (&cx.mstmm, &cx.passthrough.visibility);
    let (given, matrix) = (of_state_and_inputs(cx), matrix(cx));
    let rows = usize_literal(cx.chain.dimension.axes().len());
    let columns = usize_literal(cx.rates().total);
    let returns = fallible(cx, &matrix);
    let (checked, errors) = (quaternions::checked(cx), quaternions::error(cx));
    quote! {
        /// Returns the momentum matrix; see [`momentum_matrix_into`](Self::momentum_matrix_into).
        ///
        /// # Errors
        ///
        /// Those of [`momentum_matrix_into`](Self::momentum_matrix_into).
        #(#[doc = #errors])*
        #visibility fn momentum_matrix(&self, #given) -> #returns {
            #checked
            let mut matrix_ = #mstmm::generated::matrix([[T::constant(0.0); #rows]; #columns]);
            self.momentum_matrix_into(state_, inputs_, &mut matrix_)?;
            ::core::result::Result::Ok(matrix_)
        }
    }
}
