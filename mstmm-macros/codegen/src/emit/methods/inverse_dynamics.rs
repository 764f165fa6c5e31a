//! The methods of inverse dynamics, and the products with the mass matrix and the Coriolis matrix.

use super::super::printer::Destination;
use super::super::{EmitContext, docs, quaternions};
use super::dynamics::{in_workspace, lent_rates, of_accelerations, of_vector};
use super::{MethodTemplate, fallible, of_state_and_inputs};
use proc_macro2::TokenStream;
use quote::quote;

/// Returns the docs of an effort at the closing hinge, if the chain has one.
fn opened(cx: &EmitContext) -> Option<TokenStream> {
    (!cx.layout.loop_hinges.is_empty()).then(|| {
        quote! {
            ///
            /// The closing hinge is open: the efforts are those of the open chain. The effort of each rate of
            /// the closing hinge balances only its own springs, dampers, friction, limits and rotors.
        }
    })
}

/// Returns the docs of the errors of a method that solves no equations, with its arguments and its result.
fn not_finite(arguments: &str, result: &str) -> TokenStream {
    let doc =
        format!(" `Error::NotFinite` if {arguments} are not finite. `{result}` is then unchanged.");
    quote! {
        ///
        /// # Errors
        ///
        #[doc = #doc]
    }
}

/// Returns the method for one value at each rate, written to the caller's vector `result`.
fn at_rates(
    cx: &EmitContext,
    (name, given, result): (TokenStream, TokenStream, TokenStream),
    docs: [TokenStream; 2],
) -> MethodTemplate {
    let visibility = &cx.passthrough.visibility;
    let lent = lent_rates(cx, &result);
    let destination: fn(&EmitContext, _) -> Destination = if result.to_string() == "efforts_" {
        |_, _| Destination::Vector(quote!((*efforts_)))
    } else {
        |_, _| Destination::Vector(quote!((*product_)))
    };
    MethodTemplate {
        name: quote!(#visibility fn #name),
        docs,
        arguments: quote!(#given #lent),
        returns: fallible(cx, &quote!(())),
        opening: TokenStream::new(),
        end: quote!(::core::result::Result::Ok(())),
        destination,
    }
}

pub(super) fn inverse_dynamics(cx: &EmitContext) -> MethodTemplate {
    let (near_one, opened) = (quaternions::near_one(cx), opened(cx));
    at_rates(
        cx,
        (quote!(inverse_dynamics_into), of_accelerations(cx), quote!(efforts_)),
        [
            quote! {
                #[doc(alias("inverse dynamics", "rnea", "CalcInverseDynamics", "mj_inverse", "qfrc_inverse", "computed torque"))]
                /// Computes the efforts that the drives must supply for given accelerations `v̇` (inverse
                /// dynamics), in the order of `v` of the state, in N m and N.
                ///
                /// Gravity, Coriolis and centrifugal terms, springs, dampers, friction, limits, rotors, loads,
                /// moving ends and prescribed motions are taken into account: as efforts of the motors they
                /// give these accelerations. The efforts of motors in the inputs and constant efforts are not
                /// read. The wrench in a workspace is all that acts in a hinge, with its passive elements.
                #(#[doc = #near_one])*
                #opened
            },
            not_finite("the state, the inputs or the accelerations", "efforts"),
        ],
    )
}

pub(super) fn gravity_efforts(cx: &EmitContext) -> MethodTemplate {
    let near_one = quaternions::near_one(cx);
    at_rates(
        cx,
        (quote!(gravity_efforts_into), of_state_and_inputs(cx), quote!(efforts_)),
        [
            quote! {
                #[doc(alias("computeGeneralizedGravity", "CalcGravityGeneralizedForces", "gravity compensation", "computeStaticTorque"))]
                /// Computes the efforts that balance gravity only, for the chain at rest, in the order of `v`
                /// of the state, in N m and N. They are the part of the bias efforts due to gravity.
                #(#[doc = #near_one])*
            },
            not_finite("the state or the inputs", "efforts"),
        ],
    )
}

pub(super) fn passive_efforts(cx: &EmitContext) -> MethodTemplate {
    let near_one = quaternions::near_one(cx);
    at_rates(
        cx,
        (quote!(passive_efforts_into), of_state_and_inputs(cx), quote!(efforts_)),
        [
            quote! {
                #[doc(alias("mj_passive", "qfrc_passive"))]
                /// Computes the efforts of passive elements, in the order of `v` of the state, in N m and N:
                /// springs, dampers, friction and limits of hinges, and springs between bodies. They act
                /// in addition to the efforts of the drives, with the same sign.
                #(#[doc = #near_one])*
            },
            not_finite("the state or the inputs", "efforts"),
        ],
    )
}

pub(super) fn inverse_solution(cx: &EmitContext) -> MethodTemplate {
    let (workspace, visibility) = (&cx.names.workspace, &cx.passthrough.visibility);
    let doc = format!(
        " Computes into `at`, for given accelerations `v̇` (inverse dynamics): {}.",
        docs::results(cx)
    );
    let (given, errors) = (of_accelerations(cx), quaternions::error(cx));
    MethodTemplate {
        name: quote!(#visibility fn inverse_solve_into),
        docs: [
            quote! {
                #[doc(alias("CalcSpatialAccelerationsFromVdot"))]
                #[doc = #doc]
                ///
                /// The efforts are those that the drives must supply; those of motors in the inputs and
                /// constant efforts are not read.
            },
            quote! {
                ///
                /// # Errors
                ///
                /// `Error::NotFinite` if the state, the inputs or the accelerations are not finite. `at` is then
                /// an empty workspace, without the results of earlier calls.
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

pub(super) fn mass_matrix_times(cx: &EmitContext) -> MethodTemplate {
    let near_one = quaternions::near_one(cx);
    at_rates(
        cx,
        (quote!(mass_matrix_times_into), of_vector(cx), quote!(product_)),
        [
            quote! {
                #[doc(alias("mj_mulM", "mulM"))]
                /// Computes the product `M x` of the mass matrix with a vector, without the matrix. Both have
                /// one entry per rate, in the order of `v` of the state. Of the inputs only prescribed
                /// motions matter.
                #(#[doc = #near_one])*
            },
            not_finite("the state, the inputs or the vector", "product"),
        ],
    )
}

pub(super) fn inverse_mass_matrix_times(cx: &EmitContext) -> MethodTemplate {
    let near_one = quaternions::near_one(cx);
    at_rates(
        cx,
        (quote!(inverse_mass_matrix_times_into), of_vector(cx), quote!(product_)),
        [
            quote! {
                #[doc(alias("mj_solveM", "solveM"))]
                /// Computes the product `M⁻¹ x` of the inverse of the mass matrix with a vector, without the
                /// matrices: the accelerations that the efforts `x` add. Both have one entry per rate, in
                /// the order of `v` of the state. Of the inputs only prescribed motions matter.
                #(#[doc = #near_one])*
            },
            quote! {
                ///
                /// # Errors
                ///
                /// `Error::Singular` if the bodies outboard of a hinge have no inertia along one of its axes,
                /// `Error::NotFinite` if the state, the inputs or the given vector are not finite. `product` is
                /// then unchanged.
            },
        ],
    )
}

pub(super) fn coriolis_matrix_times(cx: &EmitContext) -> MethodTemplate {
    let near_one = quaternions::near_one(cx);
    at_rates(
        cx,
        (quote!(coriolis_matrix_times_into), of_vector(cx), quote!(product_)),
        [
            quote! {
                #[doc(alias("passivity", "Slotine-Li"))]
                /// Computes the product `C x` of the Coriolis matrix with a vector, without the matrix. Both
                /// have one entry per rate, in the order of `v` of the state. Of the inputs only prescribed
                /// motions matter.
                #(#[doc = #near_one])*
            },
            not_finite("the state, the inputs or the vector", "product"),
        ],
    )
}

pub(super) fn bias_efforts(cx: &EmitContext) -> MethodTemplate {
    let (near_one, opened) = (quaternions::near_one(cx), opened(cx));
    at_rates(
        cx,
        (quote!(bias_efforts_into), of_state_and_inputs(cx), quote!(efforts_)),
        [
            quote! {
                #[doc(alias("nle", "nonLinearEffects", "qfrc_bias", "mj_rne", "CalcBiasTerm", "Coriolis"))]
                /// Computes the bias efforts: the efforts of all rates at which no rate changes (inverse
                /// dynamics at `v̇ = 0`), in the order of `v` of the state, in N m and N.
                ///
                /// They balance gravity, Coriolis and centrifugal terms, springs, dampers, friction, limits,
                /// loads, moving ends and prescribed motions. The efforts of motors are not part of them:
                /// `M v̇ + bias = τ`, with the mass matrix `M`, rotors included, and the efforts `τ` of all
                /// motors, inputs and constants.
                #(#[doc = #near_one])*
                #opened
            },
            not_finite("the state or the inputs", "efforts"),
        ],
    )
}
