//! The methods for products with the derivatives of the accelerations.

use super::super::arrays::usize_literal;
use super::super::printer::Destination;
use super::super::{EmitContext, quaternions};
use super::dynamics::{lent_rates, of_vector};
use super::{MethodTemplate, fallible, of_state_and_inputs};
use crate::compile::outputs;
use crate::model::Answer;
use crate::program::OutputId;
use proc_macro2::TokenStream;
use quote::quote;

pub(super) fn push(cx: &EmitContext) -> MethodTemplate {
    let (visibility, near_one) = (&cx.passthrough.visibility, quaternions::near_one(cx));
    let (given, variation) = (of_state_and_inputs(cx), &cx.names.variation);
    let lent = ["accelerations_", "change_"].map(|name| {
        let name = quote::format_ident!("{name}");
        lent_rates(cx, &quote!(#name))
    });
    MethodTemplate {
        name: quote!(#visibility fn push_into),
        docs: [
            quote! {
                #[doc(alias("jvp", "forward mode", "directional derivative", "pushforward", "tangent"))]
                /// Computes the accelerations `v̇` and their derivative along a direction, the product of the
                /// Jacobian of forward dynamics with a vector. Both are exact, and need O(n) operations.
                ///
                /// The coordinates change along the rates: `dq = N(q) δ` with the `N(q)` of `q̇ = N(q) v`, and
                /// `direction.coordinates` is `δ`.
                #(#[doc = #near_one])*
            },
            quote! {
                ///
                /// # Errors
                ///
                /// `Error::Singular` if the bodies outboard of a hinge have no inertia along one of its axes,
                /// `Error::NotFinite` if the state, the inputs or the direction are not finite. Both results are
                /// then unchanged.
            },
        ],
        arguments: {
            let [a, c] = &lent;
            quote!(#given direction_: &#variation<T>, #a #c)
        },
        returns: fallible(cx, &quote!(())),
        opening: TokenStream::new(),
        end: quote!(::core::result::Result::Ok(())),
        destination: |_, id: OutputId| match id {
            outputs::ACCELERATIONS => Destination::Vector(quote!((*accelerations_))),
            outputs::CHANGE => Destination::Vector(quote!((*change_))),
            _ => bug!("a product has no place for `{}`", id.name),
        },
    }
}

pub(super) fn pull(cx: &EmitContext) -> MethodTemplate {
    let (visibility, near_one) = (&cx.passthrough.visibility, quaternions::near_one(cx));
    let (given, variation) = (of_vector(cx), &cx.names.variation);
    let lent = lent_rates(cx, &quote!(accelerations_));
    MethodTemplate {
        name: quote!(#visibility fn pull_into),
        docs: [
            quote! {
                #[doc(alias("vjp", "reverse mode", "gradient", "adjoint", "backpropagation", "pullback"))]
                /// Computes the accelerations `v̇` and the gradient of their weighted sum `yᵀ v̇`, the product of
                /// the transposed Jacobian of forward dynamics with the weights `y` in `vector`. Both are exact,
                /// and need O(n) operations, whatever the number of inputs and parameters.
                ///
                /// `gradient.coordinates` is with respect to `δ` along the rates: `dq = N(q) δ` with the `N(q)` of
                /// `q̇ = N(q) v`.
                #(#[doc = #near_one])*
            },
            quote! {
                ///
                /// # Errors
                ///
                /// `Error::Singular` if the bodies outboard of a hinge have no inertia along one of its axes,
                /// `Error::NotFinite` if the state, the inputs, the weights, the accelerations or the derivatives by
                /// the coordinates are not finite. Both results are then unchanged. Derivatives by rates, inputs and
                /// parameters are not tested: they may overflow where a length or a rate exceeds 1e150, in `f32` 1e18.
            },
        ],
        arguments: quote!(#given #lent gradient_: &mut #variation<T>,),
        returns: fallible(cx, &quote!(())),
        opening: TokenStream::new(),
        end: quote!(::core::result::Result::Ok(())),
        destination: |_, id: OutputId| match id {
            outputs::ACCELERATIONS => Destination::Vector(quote!((*accelerations_))),
            outputs::BY_COORDINATES => Destination::Vector(quote!(gradient_.coordinates)),
            outputs::BY_RATES => Destination::Vector(quote!(gradient_.rates)),
            outputs::BY_INPUTS => Destination::Vector(quote!(gradient_.inputs)),
            outputs::BY_PARAMETERS => Destination::Vector(quote!(gradient_.parameters)),
            _ => bug!("a gradient has no place for `{}`", id.name),
        },
    }
}

/// Returns the methods that return products by value.
pub(super) fn by_value(cx: &EmitContext) -> TokenStream {
    let (mstmm, visibility) = (&cx.mstmm, &cx.passthrough.visibility);
    let (checked, errors) = (quaternions::checked(cx), quaternions::error(cx));
    let (variation, count) = (&cx.names.variation, usize_literal(cx.rates().total));
    let rates = quote!(#mstmm::nalgebra::SVector<T, #count>);
    let zeros = quote!(#mstmm::generated::vector([T::constant(0.0); #count]));
    let mut methods = TokenStream::new();
    if cx.compiled.find(Answer::Push).is_some() {
        let (given, returns) = (of_state_and_inputs(cx), fallible(cx, &quote!((#rates, #rates))));
        methods.extend(quote! {
            /// Returns the accelerations `v̇` and their derivative along a direction; see
            /// [`push_into`](Self::push_into).
            ///
            /// # Errors
            ///
            /// Those of [`push_into`](Self::push_into).
            #(#[doc = #errors])*
            #[inline]
            #visibility fn push(&self, #given direction_: &#variation<T>) -> #returns {
                #checked
                let mut accelerations_ = #zeros;
                let mut change_ = #zeros;
                self.push_into(state_, inputs_, direction_, &mut accelerations_, &mut change_)?;
                ::core::result::Result::Ok((accelerations_, change_))
            }
        });
    }
    if cx.compiled.find(Answer::Pull).is_some() {
        let (given, returns) = (of_vector(cx), fallible(cx, &quote!((#rates, #variation<T>))));
        methods.extend(quote! {
            /// Returns the accelerations `v̇` and the gradient of their weighted sum; see
            /// [`pull_into`](Self::pull_into).
            ///
            /// # Errors
            ///
            /// Those of [`pull_into`](Self::pull_into).
            #(#[doc = #errors])*
            #[inline]
            #visibility fn pull(&self, #given) -> #returns {
                #checked
                let mut accelerations_ = #zeros;
                let mut gradient_ = <#variation<T> as ::core::default::Default>::default();
                self.pull_into(state_, inputs_, vector_, &mut accelerations_, &mut gradient_)?;
                ::core::result::Result::Ok((accelerations_, gradient_))
            }
        });
    }
    methods
}
