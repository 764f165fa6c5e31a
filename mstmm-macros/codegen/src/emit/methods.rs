//! The methods that compute: one for each function of the table.

use super::arrays::usize_literal;
use super::closure;
use super::names::helper;
use super::procedure::{Destination, body, field};
use super::{Plan, docs, integrable, quaternions};
use crate::compile::{CompiledFunction, outputs};
use crate::model::Answer;
use crate::program::OutputId;
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

/// How a function looks in Rust.
struct Method {
    /// Its name, with what it may be seen from.
    name: TokenStream,
    /// What its docs say before the table of operations, and behind it.
    docs: [TokenStream; 2],
    /// What it is given beside the chain.
    arguments: TokenStream,
    /// The type of what it returns.
    returns: TokenStream,
    /// What stands before its statements.
    opening: TokenStream,
    /// What it ends with.
    end: TokenStream,
    /// Where its results go.
    destination: fn(&Plan, OutputId) -> Destination,
}

/// The chain's methods and its implementations of traits.
pub fn emit(plan: &Plan) -> TokenStream {
    let mstmm = &plan.mstmm;
    let name = &plan.names.chain;
    let methods = plan.compiled.functions.iter().map(|function| method(plan, function));
    let by_value = accelerations_by_value(plan);
    let energy = integrable::energy(plan);
    let integrable = integrable::integrable(plan);
    let generated = integrable::generated(plan);
    quote! {
        #[allow(dead_code, non_snake_case)]
        impl<T: #mstmm::Scalar> #name<T> {
            #(#methods)*
            #by_value
            #energy
        }
        #integrable
        #generated
    }
}

/// The method of a function.
fn method(plan: &Plan, function: &CompiledFunction) -> TokenStream {
    let Some(answer) = function.answer else { bug!("the setup is no method") };
    let Method { name, docs, arguments, returns, opening, end, destination } = row(plan, answer);
    let procedure = &function.procedure;
    let [before, behind] = docs;
    let cost = docs::cost(procedure);
    let statements = plan.procedure(procedure, |id| destination(plan, id));
    let body = body(quote!(#opening #statements), end);
    quote! {
        #before
        #(#[doc = #cost])*
        #behind
        #[allow(unused_doc_comments, unused_variables, clippy::all)]
        #name(&self, #arguments) -> #returns #body
    }
}

/// How each function looks.
fn row(plan: &Plan, answer: Answer) -> Method {
    match answer {
        Answer::Accelerations => accelerations(plan),
        Answer::ImplicitAccelerations => implicit_accelerations(plan),
        Answer::Solution => solution(plan),
        Answer::Energy => energy(plan),
        Answer::CoordinateRates => coordinate_rates(plan),
        Answer::Normalized => normalized(plan),
        Answer::Correction => correction(plan),
        Answer::ClosurePivots => closure_pivots(plan),
        Answer::Start => start(plan),
    }
}

/// The type of a result, or the error of the chain.
fn fallible(plan: &Plan, ok: &TokenStream) -> TokenStream {
    let mstmm = &plan.mstmm;
    quote!(::core::result::Result<#ok, #mstmm::Error>)
}

fn of_state(plan: &Plan) -> TokenStream {
    let state = &plan.names.state;
    quote!(state_: &#state<T>,)
}

fn of_state_and_inputs(plan: &Plan) -> TokenStream {
    let (state, inputs) = (of_state(plan), &plan.names.inputs);
    quote!(#state inputs_: &#inputs<T>,)
}

/// A vector of all rates, which the caller lends.
fn lent_rates(plan: &Plan, name: &TokenStream) -> TokenStream {
    let (mstmm, count) = (&plan.mstmm, usize_literal(plan.rates().total));
    quote!(#name: &mut #mstmm::nalgebra::SVector<T, #count>,)
}

fn accelerations(plan: &Plan) -> Method {
    let visibility = &plan.surface.visibility;
    let near_one = quaternions::near_one(plan);
    let (given, lent) = (of_state_and_inputs(plan), lent_rates(plan, &quote!(accelerations_)));
    Method {
        name: quote!(#visibility fn accelerations_into),
        docs: [
            quote! {
                /// The accelerations `v̇` of all hinges, in the order of `v` of the state: the fast path.
                #(#[doc = #near_one])*
            },
            quote! {
                ///
                /// # Errors
                ///
                /// `Error::Singular` if no inertia is left beyond a
                /// hinge, `Error::NotFinite` if a number of the state or the
                /// inputs is not finite. `accelerations` is not touched then.
            },
        ],
        arguments: quote!(#given #lent),
        returns: fallible(plan, &quote!(())),
        opening: TokenStream::new(),
        end: quote!(::core::result::Result::Ok(())),
        destination: |_, _| Destination::Vector(quote!(accelerations_)),
    }
}

fn implicit_accelerations(plan: &Plan) -> Method {
    let step = plan.step();
    let (given, lent) = (of_state_and_inputs(plan), lent_rates(plan, &quote!(accelerations_)));
    Method {
        name: quote!(fn implicit_accelerations_into),
        docs: [
            quote! {
                /// The accelerations of a linearly implicit step of Euler's method.
            },
            TokenStream::new(),
        ],
        arguments: quote!(#given #step: T, #lent),
        ..accelerations(plan)
    }
}

/// The accelerations by value.
fn accelerations_by_value(plan: &Plan) -> TokenStream {
    let mstmm = &plan.mstmm;
    let visibility = &plan.surface.visibility;
    let (given, count) = (of_state_and_inputs(plan), usize_literal(plan.rates().total));
    let (checked, errors) = (quaternions::checked(plan), quaternions::error(plan));
    quote! {
        /// The accelerations `v̇` of all hinges by value; see
        /// [`accelerations_into`](Self::accelerations_into).
        ///
        /// # Errors
        ///
        /// As [`accelerations_into`](Self::accelerations_into).
        #(#[doc = #errors])*
        #[inline]
        #visibility fn accelerations(
            &self,
            #given
        ) -> ::core::result::Result<#mstmm::nalgebra::SVector<T, #count>, #mstmm::Error> {
            #checked
            let mut accelerations_ = #mstmm::generated::vector([T::constant(0.0); #count]);
            self.accelerations_into(state_, inputs_, &mut accelerations_)?;
            ::core::result::Result::Ok(accelerations_)
        }
    }
}

fn solution(plan: &Plan) -> Method {
    let (workspace, visibility) = (&plan.names.workspace, &plan.surface.visibility);
    let doc = format!(" Writes into `at`: {}.", docs::results(plan));
    let (given, errors) = (of_state_and_inputs(plan), quaternions::error(plan));
    Method {
        name: quote!(#visibility fn solve_into),
        docs: [
            quote!(#[doc = #doc]),
            quote! {
                ///
                /// # Errors
                ///
                /// As [`accelerations_into`](Self::accelerations_into); `at` is then as
                /// [`workspace`](Self::workspace) makes it: results of earlier calls are gone.
                #(#[doc = #errors])*
            },
        ],
        arguments: quote!(#given at_: &mut #workspace<T>),
        returns: fallible(plan, &quote!(())),
        opening: plan.reset_where_it_fails(quaternions::checked(plan)),
        end: quote!(::core::result::Result::Ok(())),
        destination: in_workspace,
    }
}

/// Where a workspace has its results.
fn in_workspace(plan: &Plan, id: OutputId) -> Destination {
    match id {
        outputs::ACCELERATIONS => Destination::Vector(quote!(at_.accelerations)),
        outputs::ALL_ACCELERATIONS => {
            let name = plan.rate_accelerations();
            Destination::Vector(quote!(at_.#name))
        }
        outputs::EFFORTS => Destination::Vector(quote!(at_.efforts)),
        outputs::ENERGIES => {
            Destination::Fields(vec![field("kinetic_energy"), field("potential_energy")])
        }
        outputs::UNDETERMINED => Destination::Closure,
        outputs::POINT_NUMBERS => Destination::Array(quote!(at_.numbers)),
        outputs::AT_REST => Destination::Array(quote!(at_.at_rest)),
        _ => bug!("a workspace has no place for `{}`", id.name),
    }
}

fn energy(plan: &Plan) -> Method {
    let (mstmm, visibility) = (&plan.mstmm, &plan.surface.visibility);
    let prescribed = plan.chain.has_prescribed_hinges();
    let name = format_ident!("{}", if prescribed { "energy_with" } else { "energy" });
    Method {
        name: quote!(#[must_use] #visibility fn #name),
        docs: [
            quote! {
                /// Kinetic and potential energy in J; the potential of gravity is zero with every centre
                /// of mass at the inertial origin.
            },
            TokenStream::new(),
        ],
        arguments: if prescribed { of_state_and_inputs(plan) } else { of_state(plan) },
        returns: quote!(#mstmm::Energy<T>),
        opening: TokenStream::new(),
        end: quote! {
            let [kinetic_, potential_] = energies_;
            #mstmm::Energy { kinetic: kinetic_, potential: potential_ }
        },
        destination: |_, _| new("energies"),
    }
}

/// A new array.
fn new(name: &str) -> Destination {
    Destination::New(helper(name))
}

fn coordinate_rates(plan: &Plan) -> Method {
    let (mstmm, count) = (&plan.mstmm, usize_literal(plan.coordinates().total));
    let given = of_state(plan);
    Method {
        name: quote!(#[inline] fn coordinate_rates_into_),
        docs: [
            quote! {
                /// The time derivatives of the coordinates.
            },
            TokenStream::new(),
        ],
        arguments: quote!(#given coordinates_: &mut #mstmm::nalgebra::SVector<T, #count>),
        returns: quote!(()),
        opening: TokenStream::new(),
        end: TokenStream::new(),
        destination: |_, _| Destination::Vector(quote!((*coordinates_))),
    }
}

fn normalized(plan: &Plan) -> Method {
    let count = usize_literal(plan.coordinates().total);
    Method {
        name: quote!(#[inline] fn normalized_),
        docs: [
            quote! {
                /// The coordinates with quaternions of unit length.
            },
            TokenStream::new(),
        ],
        arguments: of_state(plan),
        returns: quote!([T; #count]),
        opening: TokenStream::new(),
        end: quote!(coordinates_),
        destination: |_, _| new("coordinates"),
    }
}

fn correction(plan: &Plan) -> Method {
    let (state, inputs) = (&plan.names.state, &plan.names.inputs);
    Method {
        name: quote!(fn correct),
        docs: [
            quote! {
                /// Corrects coordinates and rates once by the motion of least kinetic energy that
                /// closes the chain, and returns how far it was from closed and how much
                /// redundant directions of the closing hinge held.
            },
            TokenStream::new(),
        ],
        arguments: quote!(state_: &mut #state<T>, inputs_: &#inputs<T>),
        returns: quote!([T; 2]),
        opening: TokenStream::new(),
        end: quote! {
            state_.q.data.0 = [coordinates_];
            state_.v.data.0 = [rates_];
            residual_
        },
        destination: |_, id| new(id.name),
    }
}

fn closure_pivots(plan: &Plan) -> Method {
    let count = closure::directions(plan).map(usize_literal);
    Method {
        name: quote!(fn closure_pivots_),
        docs: [
            quote! {
                /// How well each direction of the closing hinge is determined, the largest pivot first.
            },
            TokenStream::new(),
        ],
        arguments: of_state(plan),
        returns: quote!([T; #count]),
        opening: TokenStream::new(),
        end: quote!(pivots_),
        destination: |_, _| new("pivots"),
    }
}

fn start(plan: &Plan) -> Method {
    let mstmm = &plan.mstmm;
    let (state, visibility) = (&plan.names.state, &plan.surface.visibility);
    Method {
        name: quote!(#[must_use] #visibility fn initial_state),
        docs: [
            quote! {
                /// The state that the description starts from, at time zero.
            },
            TokenStream::new(),
        ],
        arguments: TokenStream::new(),
        returns: quote!(#state<T>),
        opening: TokenStream::new(),
        end: quote! {
            #state {
                q: #mstmm::generated::vector(coordinates_),
                v: #mstmm::generated::vector(rates_),
                t: T::constant(0.0),
            }
        },
        destination: |_, id| new(id.name),
    }
}
