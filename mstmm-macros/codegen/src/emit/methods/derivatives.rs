//! The methods for the derivatives of inverse dynamics and of the accelerations.

use super::super::arrays::usize_literal;
use super::super::printer::Destination;
use super::super::{EmitContext, quaternions};
use super::dynamics::of_accelerations;
use super::{MethodTemplate, fallible, negative_products, of_state_and_inputs};
use crate::compile::outputs;
use crate::model::{Answer, Representation};
use crate::program::OutputId;
use proc_macro2::TokenStream;
use quote::quote;

/// Returns the docs of the derivatives of inverse dynamics.
pub(super) fn docs_of_derivatives(cx: &EmitContext) -> [TokenStream; 2] {
    let near_one = quaternions::near_one(cx);
    [
        quote! {
            #[doc(alias("computeRNEADerivatives", "mjd_inverseFD", "dtau_dq", "stiffness matrix"))]
            /// Computes the exact derivatives of inverse dynamics with respect to coordinates, rates and
            /// accelerations, at given accelerations `v̇`.
            ///
            /// Coordinates change along the rates: `dq = N(q) δ` with the `N(q)` of `q̇ = N(q) v`. For a pin
            /// `δ` is the change of its angle, for a ball a small rotation vector in outboard axes. At a kink
            /// of a friction or a limit the derivative is that of one side.
            #(#[doc = #near_one])*
        },
        quote! {
            ///
            /// # Errors
            ///
            /// `Error::NotFinite` if the state, the accelerations, the inputs or the derivatives by the coordinates
            /// are not finite. Entries of `derivatives` may then be overwritten. Other entries are not tested: they
            /// may overflow where a length or a rate exceeds 1e75, in `f32` 1e9, or where a friction speed is below 1e-150,
            /// in `f32` 1e-18.
        },
    ]
}

pub(super) fn inverse_dynamics_derivatives(cx: &EmitContext) -> MethodTemplate {
    let visibility = &cx.passthrough.visibility;
    let (given, derivatives) = (of_accelerations(cx), &cx.names.derivatives);
    MethodTemplate {
        name: quote!(#visibility fn inverse_dynamics_derivatives_into),
        docs: docs_of_derivatives(cx),
        arguments: quote!(#given derivatives_: &mut #derivatives<T>,),
        returns: fallible(cx, &quote!(())),
        opening: TokenStream::new(),
        end: quote!(::core::result::Result::Ok(())),
        destination: |cx, id: OutputId| {
            let place = match id {
                outputs::BY_COORDINATES => quote!(derivatives_.by_coordinates),
                outputs::BY_RATES => quote!(derivatives_.by_rates),
                outputs::BY_ACCELERATIONS => quote!(derivatives_.by_accelerations),
                _ => bug!("the derivatives have no place for `{}`", id.name),
            };
            Destination::Matrix(place, cx.rates().total)
        },
    }
}

/// Returns the docs of the linearisation.
pub(super) fn docs_of_linearization(cx: &EmitContext) -> [TokenStream; 2] {
    let near_one = quaternions::near_one(cx);
    [
        quote! {
            #[doc(alias("computeABADerivatives", "mjd_transitionFD", "ddq_dq", "FirstOrderTaylorApproximation", "state space"))]
            /// Computes the accelerations and their exact derivatives with respect to coordinates, rates, inputs
            /// and parameters. `a()` and `b()` of the result are the matrices of `ẋ = A x + B u`.
            ///
            /// Coordinates change along the rates: `dq = N(q) δ` with the `N(q)` of `q̇ = N(q) v`. For a pin
            /// `δ` is the change of its angle, for a ball a small rotation vector in outboard axes. At a kink
            /// of a friction or a limit the derivative is that of one side. Operations of a short chain below do not include the products with
            /// `−M⁻¹`, which are loops.
            #(#[doc = #near_one])*
        },
        quote! {
            ///
            /// # Errors
            ///
            /// `Error::Singular` if the bodies outboard of a hinge have no inertia along one of its axes,
            /// `Error::NotFinite` if the state, the inputs or the accelerations are not finite. Entries of
            /// `linearization` may then be overwritten. The derivatives are not tested: they may overflow where a
            /// length or a rate exceeds 1e75, in `f32` 1e9, or where a friction speed is below 1e-150, in `f32` 1e-18.
        },
    ]
}

pub(super) fn linearization(cx: &EmitContext) -> MethodTemplate {
    let visibility = &cx.passthrough.visibility;
    let (given, linearization) = (of_state_and_inputs(cx), &cx.names.linearization);
    let (products, state) = (negative_products::products(cx), set_state(cx));
    MethodTemplate {
        name: quote!(#visibility fn linearize_into),
        docs: docs_of_linearization(cx),
        arguments: quote!(#given linearization_: &mut #linearization<T>,),
        returns: fallible(cx, &quote!(())),
        opening: negative_products::factors(cx),
        end: quote!(#products #state ::core::result::Result::Ok(())),
        destination: |cx, id: OutputId| {
            let place = match id {
                outputs::ACCELERATIONS => {
                    return Destination::Vector(quote!(linearization_.accelerations));
                }
                outputs::INVERSE_MASS_MATRIX => quote!(linearization_.inverse_mass_matrix),
                outputs::BY_COORDINATES => quote!(by_coordinates_),
                outputs::BY_RATES => quote!(by_rates_),
                outputs::BY_INPUTS => quote!(linearization_.by_inputs),
                outputs::BY_PARAMETERS => quote!(by_parameters_),
                _ => bug!("a linearization has no place for `{}`", id.name),
            };
            Destination::Matrix(place, cx.rates().total)
        },
    }
}

/// Returns the statement that sets what `a()` needs: the rates, and where those of rotations in space are.
pub(super) fn set_state(cx: &EmitContext) -> TokenStream {
    let layout = cx.rates();
    let mut rotations = Vec::new();
    for (hinge, free) in cx.chain.hinges.enumerate().filter(|(_, hinge)| !hinge.is_prescribed()) {
        for group in free.kind.spec().groups {
            let is_angular_velocity = group.representation != Representation::Numbers;
            if group.rotational && group.rates.len() == 3 && is_angular_velocity {
                let first = cx.layout.v[hinge].start + group.rates.start;
                let segment = layout.segment_of(first);
                let start = segment.offset + first - segment.first;
                let [start, step, count] =
                    [start, segment.count, segment.repetitions].map(usize_literal);
                rotations.push(quote!([#start, #step, #count]));
            }
        }
    }
    quote!(linearization_.set_state(&state_.v, &[#(#rotations),*]);)
}

/// Returns the methods that return derivatives by value.
pub(super) fn by_value(cx: &EmitContext) -> TokenStream {
    let visibility = &cx.passthrough.visibility;
    let (checked, errors) = (quaternions::checked(cx), quaternions::error(cx));
    let (accelerations, given) = (of_accelerations(cx), of_state_and_inputs(cx));
    let (derivatives, linearization) = (&cx.names.derivatives, &cx.names.linearization);
    let mut methods = TokenStream::new();
    if cx.compiled.find(Answer::InverseDynamicsDerivatives).is_some() {
        let returns = fallible(cx, &quote!(#derivatives<T>));
        methods.extend(quote! {
            /// Returns the derivatives of inverse dynamics; see
            /// [`inverse_dynamics_derivatives_into`](Self::inverse_dynamics_derivatives_into).
            ///
            /// # Errors
            ///
            /// Those of [`inverse_dynamics_derivatives_into`](Self::inverse_dynamics_derivatives_into).
            #(#[doc = #errors])*
            #[inline]
            #visibility fn inverse_dynamics_derivatives(&self, #accelerations) -> #returns {
                #checked
                let mut derivatives_ = <#derivatives<T> as ::core::default::Default>::default();
                self.inverse_dynamics_derivatives_into(
                    state_, accelerations_, inputs_, &mut derivatives_,
                )?;
                ::core::result::Result::Ok(derivatives_)
            }
        });
    }
    if cx.compiled.find(Answer::Linearization).is_some() {
        let returns = fallible(cx, &quote!(#linearization<T>));
        methods.extend(quote! {
            /// Returns the accelerations and their derivatives; see [`linearize_into`](Self::linearize_into).
            ///
            /// # Errors
            ///
            /// Those of [`linearize_into`](Self::linearize_into).
            #(#[doc = #errors])*
            #[inline]
            #visibility fn linearize(&self, #given) -> #returns {
                #checked
                let mut linearization_ = <#linearization<T> as ::core::default::Default>::default();
                self.linearize_into(state_, inputs_, &mut linearization_)?;
                ::core::result::Result::Ok(linearization_)
            }
        });
    }
    methods
}
