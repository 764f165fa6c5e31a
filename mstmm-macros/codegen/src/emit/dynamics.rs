//! The functions that compute: accelerations, everything else, energy, and the chain as an
//! integrator sees it.

use super::Plan;
use super::block::{Results, body};
use super::docs;
use super::integrable::{generated, integrable};
use super::looped::{Target, usize_literal};
use super::quaternions;
use super::solution::solution;
use super::spread::Spread;
use crate::compile::groups;
use crate::model::HingeId;
use crate::program::Program;
use proc_macro2::{Group, Literal, TokenStream};
use quote::quote;
use std::collections::HashSet;

/// The chain's methods and its `Chain` implementation.
pub fn emit(plan: &Plan) -> TokenStream {
    let mstmm = &plan.mstmm;
    let name = &plan.names.chain;
    let accelerations = accelerations(plan);
    let solution = solution(plan);
    let energy = energy(plan);
    let integrable = integrable(plan);
    let generated = generated(plan);
    quote! {
        #[allow(dead_code, non_snake_case)]
        impl<T: #mstmm::Scalar> #name<T> {
            #accelerations
            #solution
            #energy
        }
        #integrable
        #generated
    }
}

fn accelerations(plan: &Plan) -> TokenStream {
    let mstmm = &plan.mstmm;
    let (state, inputs) = (&plan.names.state, &plan.names.inputs);
    let visibility = &plan.surface.visibility;
    let freedoms = usize_literal(Spread::freedoms(plan).total);
    let program = &plan.programs.accelerations;
    let block = plan.step(program, &[Target::new(0, Spread::freedoms(plan))], true);
    let body = checked(plan, program, block, &plan.programs.pivots);
    let cost = docs::cost(program);
    let implicit = implicit(plan);
    let (checked, errors) = (quaternions::checked(plan), quaternions::error(plan));
    let near_one = quaternions::near_one(plan);
    quote! {
        #implicit

        /// The accelerations `v̇` of all hinges, in the order of `v` of the state: the fast path.
        #(#[doc = #near_one])*
        ///
        #(#[doc = #cost])*
        ///
        /// # Errors
        ///
        /// `Error::Singular` if no inertia is left beyond a
        /// hinge, `Error::NotFinite` if a number of the state or the
        /// inputs is not finite. `accelerations` is not touched then.
        #[allow(unused_doc_comments, unused_variables, clippy::all)]
        #visibility fn accelerations_into(
            &self,
            state_: &#state<T>,
            inputs_: &#inputs<T>,
            accelerations_: &mut #mstmm::nalgebra::SVector<T, #freedoms>,
        ) -> ::core::result::Result<(), #mstmm::Error> #body

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
            state_: &#state<T>,
            inputs_: &#inputs<T>,
        ) -> ::core::result::Result<#mstmm::nalgebra::SVector<T, #freedoms>, #mstmm::Error> {
            #checked
            let mut accelerations_ =
                #mstmm::generated::vector([T::constant(0.0); #freedoms]);
            self.accelerations_into(state_, inputs_, &mut accelerations_)?;
            ::core::result::Result::Ok(accelerations_)
        }
    }
}

/// The accelerations of a linearly implicit step.
fn implicit(plan: &Plan) -> Option<TokenStream> {
    let mstmm = &plan.mstmm;
    let (program, pivots) = plan.programs.implicit.as_ref()?;
    let (state, inputs) = (&plan.names.state, &plan.names.inputs);
    let freedoms = usize_literal(Spread::freedoms(plan).total);
    let target = Target::new(0, Spread::freedoms(plan));
    let block = plan.step(program, &[target], true);
    let body = checked(plan, program, block, pivots);
    let cost = docs::cost(program);
    let step = &plan.unknowns[plan.programs.symbols.step().start];
    Some(quote! {
        /// The accelerations of a linearly implicit step of Euler's method.
        ///
        #(#[doc = #cost])*
        #[allow(unused_doc_comments, unused_variables, clippy::all)]
        fn implicit_accelerations_into(
            &self,
            state_: &#state<T>,
            inputs_: &#inputs<T>,
            #step: T,
            accelerations_: &mut #mstmm::nalgebra::SVector<T, #freedoms>,
        ) -> ::core::result::Result<(), #mstmm::Error> #body
    })
}

/// The body of a function that computes accelerations: tests around the statements of `block`.
fn checked(plan: &Plan, program: &Program, block: Results, pivots: &[HingeId]) -> Group {
    let check = check(plan, program, &block, pivots);
    let (results, found) = (&block.arrays[0], check.found());
    let mut statements = check.given;
    statements.extend(block.statements);
    body(
        statements,
        quote! {
            #found
            accelerations_.data.0 = [#results];
            ::core::result::Result::Ok(())
        },
    )
}

fn energy(plan: &Plan) -> TokenStream {
    let mstmm = &plan.mstmm;
    let (state, inputs) = (&plan.names.state, &plan.names.inputs);
    let visibility = &plan.surface.visibility;
    let program = &plan.programs.energy;
    let block = plan.step(program, &[], false);
    let (kinetic, potential) = (&block.outputs[0][0], &block.outputs[0][1]);
    let energy = quote!(#mstmm::Energy { kinetic: #kinetic, potential: #potential });
    let body = body(block.statements, energy);
    let cost = docs::cost(program);
    if !plan.chain.has_prescribed_hinges() {
        return quote! {
            /// Kinetic and potential energy in J; the potential of gravity is zero with every centre
            /// of mass at the inertial origin.
            ///
            #(#[doc = #cost])*
            #[must_use]
            #[allow(unused_doc_comments, unused_variables, clippy::all)]
            #visibility fn energy(&self, state_: &#state<T>) -> #mstmm::Energy<T> #body
        };
    }
    quote! {
        /// Kinetic and potential energy in J, with prescribed motions at rest in the zero position.
        #[inline]
        #[must_use]
        #visibility fn energy(&self, state_: &#state<T>) -> #mstmm::Energy<T> {
            self.energy_with(state_, &self.no_inputs())
        }

        /// Kinetic and potential energy in J; the potential of gravity is zero with every centre of
        /// mass at the inertial origin.
        ///
        #(#[doc = #cost])*
        #[must_use]
        #[allow(unused_doc_comments, unused_variables, clippy::all)]
        #visibility fn energy_with(
            &self,
            state_: &#state<T>,
            inputs_: &#inputs<T>,
        ) -> #mstmm::Energy<T> #body
    }
}

/// The test whether there are accelerations.
pub(super) struct Check {
    /// Statements that fail where something that is given is not finite. They stand first: behind others they
    /// would be a branch, over which the compiler moves some and not others.
    pub(super) given: TokenStream,
    /// Statements that fail where a pivot of a repeated part vanishes.
    pub(super) repeated_pivots: TokenStream,
    /// Whether pivots that stand once do not, and results are finite.
    pub(super) regular: TokenStream,
    /// The error if it is not so.
    pub(super) error: TokenStream,
    /// Statements that fail where a result of a chain with repeated parts is not finite.
    pub(super) repeated_results: Option<TokenStream>,
}

impl Check {
    /// All that stands behind the statements.
    pub(super) fn found(&self) -> TokenStream {
        let Check { repeated_pivots, regular, error, repeated_results, .. } = self;
        quote! {
            #repeated_pivots
            if !#regular {
                return ::core::result::Result::Err(#error);
            }
            #repeated_results
        }
    }
}

/// The test whether there are accelerations.
///
/// Of the numbers given, those are looked at that the results, which are looked at anyway, do not
/// show; of results those that no other shows.
pub(super) fn check(plan: &Plan, program: &Program, block: &Results, pivots: &[HingeId]) -> Check {
    let mstmm = &plan.mstmm;
    let name = |&hinge: &HingeId| plan.chain.hinges[hinge].name.to_string();
    let once = |number: &usize| block.masks.iter().all(|(repeated, _)| repeated != number);
    let numbers: Vec<usize> = (0..pivots.len()).filter(once).collect();
    let names = numbers.iter().map(|&number| name(&pivots[number]));
    let of = |group: usize| {
        let values = numbers.iter().map(|&number| &block.outputs[group][number]);
        quote!([#(#values),*])
    };
    let (values, scales) = (of(groups::PIVOTS), of(groups::SCALES));
    let results = &block.arrays[0];
    let shown = program.shown(groups::ACCELERATIONS);
    let (taken, inputs) = plan.input_slices(&shown.unknowns);
    let repeated = block.masks.iter().map(|(number, mask)| {
        let name = name(&pivots[*number]);
        quote!(#mstmm::generated::require(#mask, #name)?;)
    });
    let mut given = taken;
    if !inputs.is_empty() {
        given.extend(quote!(#mstmm::generated::finite::<T>(&[#(#inputs),*])?;));
    }
    let hidden = hidden_state(plan, &shown.unknowns);
    let (few, many) = if block.looped {
        let some = hidden.iter().filter(|(_, places)| !places.is_empty());
        let vectors = some.map(|(vector, _)| vector);
        given.extend(quote!(#(#mstmm::generated::all_finite::<T>(state_.#vectors.as_slice())?;)*));
        // An array of many numbers is not handed over by value.
        let many = quote!(#mstmm::generated::all_finite::<T>(#results.as_slice())?;);
        (quote!([state_.t]), Some(many))
    } else {
        let hidden = hidden.iter().flat_map(|(vector, places)| {
            places.iter().map(move |place| quote!(state_.#vector.data.0[0][#place]))
        });
        let telling = shown.telling.iter().map(|result| plan.operand(&block.variables, result));
        (quote!([state_.t, #(#hidden,)* #(#telling),*]), None)
    };
    Check {
        given,
        repeated_pivots: repeated.collect(),
        regular: quote!(#mstmm::generated::regular::<T, _, _>(#values, #scales, #few)),
        error: quote!(#mstmm::generated::irregular::<T, _>(&[#(#names),*], #values, #scales)),
        repeated_results: many,
    }
}

/// The vectors of the state with the places of coordinates and rates that no result shows.
fn hidden_state(plan: &Plan, shown: &HashSet<u32>) -> [(TokenStream, Vec<Literal>); 2] {
    let symbols = &plan.programs.symbols;
    [(symbols.q(), quote!(q)), (symbols.v(), quote!(v))].map(|(range, vector)| {
        let start = range.start;
        let hidden = range.filter(|&number| !shown.contains(&(number as u32)));
        (vector, hidden.map(|number| usize_literal(number - start)).collect())
    })
}
