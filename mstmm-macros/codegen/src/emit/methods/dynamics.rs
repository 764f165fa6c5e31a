//! The methods for accelerations, the complete solution and energy, and the forms of methods that return by value.

use super::super::arrays::usize_literal;
use super::super::printer::Destination;
use super::super::procedure::field;
use super::super::{EmitContext, docs, quaternions};
use super::{MethodTemplate, fallible, mass_matrix, new, of_state, of_state_and_inputs};
use crate::compile::outputs;
use crate::model::Answer;
use crate::program::OutputId;
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

/// Returns the argument for a vector of one entry per rate, which the caller owns.
pub(super) fn lent_rates(cx: &EmitContext, name: &TokenStream) -> TokenStream {
    let (mstmm, count) = (&cx.mstmm, usize_literal(cx.rates().total));
    quote!(#name: &mut #mstmm::nalgebra::SVector<T, #count>,)
}

/// Returns the arguments for the state, given accelerations and the inputs.
pub(super) fn of_accelerations(cx: &EmitContext) -> TokenStream {
    let (mstmm, count) = (&cx.mstmm, usize_literal(cx.rates().total));
    let (state, inputs) = (of_state(cx), &cx.names.inputs);
    quote!(#state accelerations_: &#mstmm::nalgebra::SVector<T, #count>, inputs_: &#inputs<T>,)
}

/// Returns the arguments for the state, the inputs and a given vector of one entry per rate.
pub(super) fn of_vector(cx: &EmitContext) -> TokenStream {
    let (mstmm, count) = (&cx.mstmm, usize_literal(cx.rates().total));
    let given = of_state_and_inputs(cx);
    quote!(#given vector_: &#mstmm::nalgebra::SVector<T, #count>,)
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
    let of = |(answer, what): &(Answer, &str)| {
        cx.compiled.find(*answer).map(|_| by_value_of(cx, *answer, what))
    };
    BY_VALUE.iter().filter_map(of).collect()
}

/// The functions with a form that returns by value, and what it does.
const BY_VALUE: [(Answer, &str); 11] = [
    (Answer::Accelerations, "Returns the accelerations `v̇` of all hinges"),
    (Answer::BiasEfforts, "Returns the bias efforts"),
    (Answer::InverseDynamics, "Returns the efforts that the drives must supply"),
    (Answer::GravityEfforts, "Returns the efforts that balance gravity"),
    (Answer::PassiveEfforts, "Returns the efforts of passive elements"),
    (Answer::MassMatrixTimes, "Returns the product of the mass matrix with a vector"),
    (
        Answer::InverseMassMatrixTimes,
        "Returns the product of the inverse of the mass matrix with a vector",
    ),
    (Answer::MassMatrix, "Returns the mass matrix"),
    (Answer::InverseMassMatrix, "Returns the inverse of the mass matrix"),
    (Answer::CoriolisMatrixTimes, "Returns the product of the Coriolis matrix with a vector"),
    (Answer::CoriolisMatrix, "Returns the Coriolis matrix"),
];

fn by_value_of(cx: &EmitContext, answer: Answer, what: &str) -> TokenStream {
    let name = answer.name();
    let mstmm = &cx.mstmm;
    let visibility = &cx.passthrough.visibility;
    let count = usize_literal(cx.rates().total);
    let (given, passed) = match answer {
        Answer::InverseDynamics => (of_accelerations(cx), quote!(state_, accelerations_, inputs_)),
        Answer::MassMatrixTimes | Answer::InverseMassMatrixTimes | Answer::CoriolisMatrixTimes => {
            (of_vector(cx), quote!(state_, inputs_, vector_))
        }
        _ => (of_state_and_inputs(cx), quote!(state_, inputs_)),
    };
    let (returned, zeros) = match answer {
        Answer::MassMatrix | Answer::InverseMassMatrix | Answer::CoriolisMatrix => (
            mass_matrix::square(cx),
            quote!(#mstmm::generated::matrix([[T::constant(0.0); #count]; #count])),
        ),
        _ => (
            quote!(#mstmm::nalgebra::SVector<T, #count>),
            quote!(#mstmm::generated::vector([T::constant(0.0); #count])),
        ),
    };
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
        ) -> ::core::result::Result<#returned, #mstmm::Error> {
            #checked
            let mut rates_ = #zeros;
            self.#into(#passed, &mut rates_)?;
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
pub(super) fn in_workspace(cx: &EmitContext, id: OutputId) -> Destination {
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
