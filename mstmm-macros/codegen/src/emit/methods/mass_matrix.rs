//! The methods for the mass matrix and its inverse, and for the Coriolis matrix.

use super::super::arrays::usize_literal;
use super::super::printer::Destination;
use super::super::{EmitContext, quaternions};
use super::{MethodTemplate, fallible, of_state_and_inputs};
use proc_macro2::TokenStream;
use quote::quote;

/// Returns the type of a matrix with one row and column for each rate.
pub(super) fn square(cx: &EmitContext) -> TokenStream {
    let (mstmm, count) = (&cx.mstmm, usize_literal(cx.rates().total));
    quote!(#mstmm::nalgebra::SMatrix<T, #count, #count>)
}

/// Returns the method for a matrix that the caller owns.
fn method(cx: &EmitContext, name: TokenStream, docs: [TokenStream; 2]) -> MethodTemplate {
    let (visibility, given) = (&cx.passthrough.visibility, of_state_and_inputs(cx));
    let matrix = square(cx);
    MethodTemplate {
        name: quote!(#visibility fn #name),
        docs,
        arguments: quote!(#given matrix_: &mut #matrix,),
        returns: fallible(cx, &quote!(())),
        opening: TokenStream::new(),
        end: quote!(::core::result::Result::Ok(())),
        destination: |cx, _| Destination::Matrix(quote!(matrix_), cx.rates().total),
    }
}

/// Returns the docs of the mass matrix.
pub(super) fn docs_of_mass_matrix(cx: &EmitContext) -> [TokenStream; 2] {
    let near_one = quaternions::near_one(cx);
    [
        quote! {
            #[doc(alias("crba", "CalcMassMatrix", "mj_fullM", "inertia matrix", "joint space inertia"))]
            /// Computes the mass matrix `M`, with one row and column per rate in the order of `v` of the
            /// state, in kg m², kg m and kg. Rotors are part of it. Of the inputs only prescribed motions
            /// matter.
            #(#[doc = #near_one])*
        },
        quote! {
            ///
            /// # Errors
            ///
            /// `Error::NotFinite` if the state or the inputs are not finite. Entries of `matrix` may then be
            /// overwritten.
        },
    ]
}

pub(super) fn mass_matrix(cx: &EmitContext) -> MethodTemplate {
    method(cx, quote!(mass_matrix_into), docs_of_mass_matrix(cx))
}

/// Returns the docs of the inverse of the mass matrix.
pub(super) fn docs_of_inverse(cx: &EmitContext) -> [TokenStream; 2] {
    let near_one = quaternions::near_one(cx);
    [
        quote! {
            #[doc(alias("computeMinverse", "Minv", "inverse inertia matrix"))]
            /// Computes the inverse `M⁻¹` of the mass matrix, with one row and column per rate in the order of
            /// `v` of the state: column `k` has the accelerations that a unit effort along rate `k` adds.
            /// Of the inputs only prescribed motions matter.
            #(#[doc = #near_one])*
        },
        quote! {
            ///
            /// # Errors
            ///
            /// `Error::Singular` if the bodies outboard of a hinge have no inertia along one of its axes,
            /// `Error::NotFinite` if the state or the inputs are not finite. Entries of `matrix` may then be
            /// overwritten.
        },
    ]
}

pub(super) fn inverse_mass_matrix(cx: &EmitContext) -> MethodTemplate {
    method(cx, quote!(inverse_mass_matrix_into), docs_of_inverse(cx))
}

/// Returns the docs of the Coriolis matrix.
pub(super) fn docs_of_coriolis_matrix(cx: &EmitContext) -> [TokenStream; 2] {
    let near_one = quaternions::near_one(cx);
    [
        quote! {
            #[doc(alias("computeCoriolisMatrix", "Christoffel", "passivity", "Slotine-Li"))]
            /// Computes the Coriolis matrix `C`, with one row and column per rate in the order of `v` of the
            /// state, in kg m²/s, kg m/s and kg/s. Along all motions `dM/dt = C + Cᵀ`, and `dM/dt − 2 C` is
            /// skew-symmetric, with the mass matrix `M`. Without prescribed motions `C v` are the efforts that
            /// Coriolis and centrifugal forces require. Of the inputs only prescribed motions matter.
            #(#[doc = #near_one])*
        },
        quote! {
            ///
            /// # Errors
            ///
            /// `Error::NotFinite` if the state or the inputs are not finite. Entries of `matrix` may then be
            /// overwritten.
        },
    ]
}

pub(super) fn coriolis_matrix(cx: &EmitContext) -> MethodTemplate {
    method(cx, quote!(coriolis_matrix_into), docs_of_coriolis_matrix(cx))
}
