//! The methods for accelerations, the complete solution, energy and bias efforts.

use super::super::arrays::usize_literal;
use super::super::printer::Destination;
use super::super::procedure::field;
use super::super::{EmitContext, docs, quaternions};
use super::{MethodTemplate, fallible, new, of_state, of_state_and_inputs};
use crate::compile::outputs;
use crate::model::Answer;
use crate::program::OutputId;
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

/// Returns the argument for a vector of one entry per rate, which the caller owns.
fn lent_rates(cx: &EmitContext, name: &TokenStream) -> TokenStream {
    let (mstmm, count) = (&cx.mstmm, usize_literal(cx.rates().total));
    quote!(#name: &mut #mstmm::nalgebra::SVector<T, #count>,)
}

pub(super) fn accelerations(cx: &EmitContext) -> MethodTemplate {
    let visibility = &cx.passthrough.visibility;
    let near_one = quaternions::near_one(cx);
    let (given, lent) = (of_state_and_inputs(cx), lent_rates(cx, &quote!(accelerations_)));
    MethodTemplate {
        name: quote!(#visibility fn accelerations_into),
        docs: [
            quote! {
                #[doc(alias("forward dynamics", "aba", "qacc"))]
                /// Computes the accelerations `v̇` of all hinges, in the order of `v` of the state, in rad/s² and m/s²
                /// (forward dynamics). This is the fastest method.
                #(#[doc = #near_one])*
            },
            quote! {
                ///
                /// # Errors
                ///
                /// `Error::Singular` if the bodies outboard of a hinge have no inertia along one of its axes,
                /// `Error::NotFinite` if the state or the inputs are not finite. `accelerations` is then
                /// unchanged.
            },
        ],
        arguments: quote!(#given #lent),
        returns: fallible(cx, &quote!(())),
        opening: TokenStream::new(),
        end: quote!(::core::result::Result::Ok(())),
        destination: |_, _| Destination::Vector(quote!(accelerations_)),
    }
}

pub(super) fn implicit_accelerations(cx: &EmitContext) -> MethodTemplate {
    let step = cx.step();
    let (given, lent) = (of_state_and_inputs(cx), lent_rates(cx, &quote!(accelerations_)));
    MethodTemplate {
        name: quote!(fn implicit_accelerations_into),
        docs: [
            quote! {
                /// Computes the accelerations of a step of the linearly implicit Euler method.
            },
            TokenStream::new(),
        ],
        arguments: quote!(#given #step: T, #lent),
        ..accelerations(cx)
    }
}

/// Returns the methods that return by value the vector that their `_into` forms write.
pub(super) fn by_value(cx: &EmitContext) -> Vec<TokenStream> {
    let accelerations =
        by_value_of(cx, "accelerations", "Returns the accelerations `v̇` of all hinges");
    let bias = cx.compiled.find(Answer::BiasEfforts);
    let bias = bias.map(|_| by_value_of(cx, "bias_efforts", "Returns the bias efforts"));
    std::iter::once(accelerations).chain(bias).collect()
}

fn by_value_of(cx: &EmitContext, name: &str, what: &str) -> TokenStream {
    let mstmm = &cx.mstmm;
    let visibility = &cx.passthrough.visibility;
    let (given, count) = (of_state_and_inputs(cx), usize_literal(cx.rates().total));
    let (checked, errors) = (quaternions::checked(cx), quaternions::error(cx));
    let doc = format!(" {what}; see [`{name}_into`](Self::{name}_into).");
    let as_lent = format!(" Those of [`{name}_into`](Self::{name}_into).");
    let (name, into) = (format_ident!("{name}"), format_ident!("{name}_into"));
    quote! {
        #[doc = #doc]
        ///
        /// # Errors
        ///
        #[doc = #as_lent]
        #(#[doc = #errors])*
        #[inline]
        #visibility fn #name(
            &self,
            #given
        ) -> ::core::result::Result<#mstmm::nalgebra::SVector<T, #count>, #mstmm::Error> {
            #checked
            let mut rates_ = #mstmm::generated::vector([T::constant(0.0); #count]);
            self.#into(state_, inputs_, &mut rates_)?;
            ::core::result::Result::Ok(rates_)
        }
    }
}

pub(super) fn solution(cx: &EmitContext) -> MethodTemplate {
    let (workspace, visibility) = (&cx.names.workspace, &cx.passthrough.visibility);
    let doc = format!(" Computes into `at`: {}.", docs::results(cx));
    let (given, errors) = (of_state_and_inputs(cx), quaternions::error(cx));
    MethodTemplate {
        name: quote!(#visibility fn solve_into),
        docs: [
            quote!(#[doc = #doc]),
            quote! {
                ///
                /// # Errors
                ///
                /// Those of [`accelerations_into`](Self::accelerations_into). `at` is then an empty workspace, without
                /// the results of earlier calls.
                #(#[doc = #errors])*
            },
        ],
        arguments: quote!(#given at_: &mut #workspace<T>),
        returns: fallible(cx, &quote!(())),
        opening: cx.with_reset(quaternions::checked(cx)),
        end: quote!(::core::result::Result::Ok(())),
        destination: in_workspace,
    }
}

/// Returns the destination of a result in the workspace.
fn in_workspace(cx: &EmitContext, id: OutputId) -> Destination {
    match id {
        outputs::ACCELERATIONS => Destination::Vector(quote!(at_.accelerations)),
        outputs::ALL_ACCELERATIONS => {
            let name = cx.rate_accelerations();
            Destination::Vector(quote!(at_.#name))
        }
        outputs::EFFORTS => Destination::Vector(quote!(at_.efforts)),
        outputs::ENERGIES => {
            Destination::Fields(vec![field("kinetic_energy"), field("potential_energy")])
        }
        outputs::UNDETERMINED => Destination::Closure,
        outputs::POINT_NUMBERS => Destination::Array(quote!(at_.numbers)),
        outputs::BASE_ACCELERATION => Destination::Array(quote!(at_.base_acceleration)),
        outputs::SPRINGS => Destination::Array(quote!(at_.springs)),
        _ => bug!("a workspace has no place for `{}`", id.name),
    }
}

pub(super) fn energy(cx: &EmitContext) -> MethodTemplate {
    let (mstmm, visibility) = (&cx.mstmm, &cx.passthrough.visibility);
    let prescribed = cx.chain.has_prescribed_hinges();
    let name = format_ident!("{}", if prescribed { "energy_with" } else { "energy" });
    MethodTemplate {
        name: quote!(#[must_use] #visibility fn #name),
        docs: [
            quote! {
                /// Returns kinetic and potential energy in J.
                ///
                /// The potential energy of gravity is zero if all centres of mass are at the inertial origin.
            },
            TokenStream::new(),
        ],
        arguments: if prescribed { of_state_and_inputs(cx) } else { of_state(cx) },
        returns: quote!(#mstmm::Energy<T>),
        opening: TokenStream::new(),
        end: quote! {
            let [kinetic_, potential_] = energies_;
            #mstmm::Energy { kinetic: kinetic_, potential: potential_ }
        },
        destination: |_, _| new("energies"),
    }
}

pub(super) fn bias_efforts(cx: &EmitContext) -> MethodTemplate {
    let visibility = &cx.passthrough.visibility;
    let (given, lent) = (of_state_and_inputs(cx), lent_rates(cx, &quote!(efforts_)));
    let near_one = quaternions::near_one(cx);
    let opened = (!cx.layout.loop_hinges.is_empty()).then(|| {
        quote! {
            ///
            /// The closing hinge is open: the bias efforts are those of the open chain. The effort of each rate
            /// of the closing hinge balances only its own springs, dampers, friction, stops and rotors.
        }
    });
    MethodTemplate {
        name: quote!(#visibility fn bias_efforts_into),
        docs: [
            quote! {
                #[doc(alias("inverse dynamics", "rnea", "nle", "nonLinearEffects", "qfrc_bias"))]
                /// Computes the bias efforts: the efforts of all rates at which no rate changes (inverse
                /// dynamics at `v̇ = 0`), in the order of `v` of the state, in N m and N.
                ///
                /// They balance gravity, Coriolis and centrifugal terms, springs, dampers, friction, stops,
                /// loads, moving ends and prescribed motions. The efforts of motors are not part of them:
                /// `M v̇ + bias = τ`, with the mass matrix `M`, rotors included, and the efforts `τ` of all
                /// motors, inputs and constants.
                #(#[doc = #near_one])*
                #opened
            },
            quote! {
                ///
                /// # Errors
                ///
                /// `Error::NotFinite` if the state or the inputs are not finite. `efforts` is then unchanged.
            },
        ],
        arguments: quote!(#given #lent),
        returns: fallible(cx, &quote!(())),
        opening: TokenStream::new(),
        end: quote!(::core::result::Result::Ok(())),
        destination: |_, _| Destination::Vector(quote!((*efforts_))),
    }
}
