//! The functions that compute: accelerations, everything else, energy, and the chain as an
//! integrator sees it.

use super::Plan;
use super::docs;
use crate::model::{Effort, Results};
use crate::program::Program;
use proc_macro2::{Literal, TokenStream};
use quote::quote;

/// The chain's methods and its `Chain` implementation.
pub fn emit(plan: &Plan) -> TokenStream {
    let name = &plan.names.chain;
    let accelerations = accelerations(plan);
    let solution = solution(plan);
    let energy = energy(plan);
    let integrable = integrable(plan);
    let generated = generated(plan);
    quote! {
        #[allow(dead_code, non_snake_case)]
        impl<T: ::mstmm::Scalar> #name<T> {
            #accelerations
            #solution
            #energy
        }
        #integrable
        #generated
    }
}

fn accelerations(plan: &Plan) -> TokenStream {
    let (state, inputs) = (&plan.names.state, &plan.names.inputs);
    let visibility = &plan.surface.visibility;
    let freedoms = Literal::usize_unsuffixed(plan.layout.freedoms());
    let program = &plan.programs.accelerations;
    let block = plan.step_block(program);
    let (statements, results) = (block.statements, &block.outputs[0]);
    let check = check(plan, &block.outputs);
    let cost = docs::cost(program);
    quote! {
        /// The accelerations `v̇` of all hinges, in the order of the rates: the fast path.
        ///
        #(#[doc = #cost])*
        ///
        /// # Errors
        ///
        /// [`Error::Singular`](::mstmm::Error::Singular) if nothing with inertia lies beyond a
        /// hinge, [`Error::NotFinite`](::mstmm::Error::NotFinite) if a number of the state or the
        /// inputs is not finite. `accelerations` is not touched then.
        #[allow(unused_doc_comments, unused_variables, clippy::all)]
        #visibility fn accelerations_into(
            &self,
            state: &#state<T>,
            inputs: &#inputs<T>,
            accelerations: &mut ::mstmm::nalgebra::SVector<T, #freedoms>,
        ) -> ::core::result::Result<(), ::mstmm::Error> {
            #statements
            #check
            accelerations.data.0 = [[#(#results),*]];
            ::core::result::Result::Ok(())
        }

        /// The accelerations `v̇` of all hinges by value; see
        /// [`accelerations_into`](Self::accelerations_into).
        ///
        /// # Errors
        ///
        /// As [`accelerations_into`](Self::accelerations_into).
        #[inline]
        #visibility fn accelerations(
            &self,
            state: &#state<T>,
            inputs: &#inputs<T>,
        ) -> ::core::result::Result<::mstmm::nalgebra::SVector<T, #freedoms>, ::mstmm::Error> {
            let mut accelerations =
                ::mstmm::generated::vector([T::constant(0.0); #freedoms]);
            self.accelerations_into(state, inputs, &mut accelerations)?;
            ::core::result::Result::Ok(accelerations)
        }
    }
}

fn solution(plan: &Plan) -> TokenStream {
    let (state, inputs) = (&plan.names.state, &plan.names.inputs);
    let (workspace, visibility) = (&plan.names.workspace, &plan.surface.visibility);
    let program = &plan.programs.solution;
    let block = plan.step_block(program);
    let statements = block.statements;
    let check = check(plan, &block.outputs);
    let (results, efforts, energies) = (&block.outputs[0], &block.outputs[3], &block.outputs[4]);
    let (kinetic, potential) = (&energies[0], &energies[1]);
    let points = block.outputs[5..].iter().map(|group| point(group));
    let cost = docs::cost(program);
    quote! {
        /// Everything: accelerations, efforts, energies and, at every connection point, pose,
        /// velocity and the state vector `z`, written into `at`.
        ///
        #(#[doc = #cost])*
        ///
        /// # Errors
        ///
        /// As [`accelerations_into`](Self::accelerations_into); `at` is not touched then.
        #[allow(unused_doc_comments, unused_variables, clippy::all)]
        #visibility fn solve_into(
            &self,
            state: &#state<T>,
            inputs: &#inputs<T>,
            at: &mut #workspace<T>,
        ) -> ::core::result::Result<(), ::mstmm::Error> {
            #statements
            #check
            at.accelerations.data.0 = [[#(#results),*]];
            at.efforts.data.0 = [[#(#efforts),*]];
            at.kinetic_energy = #kinetic;
            at.potential_energy = #potential;
            at.points = [#(#points),*];
            ::core::result::Result::Ok(())
        }
    }
}

/// A connection point from its thirty numbers: position, rotation by rows, velocity, `Ω`, `z`.
fn point(numbers: &[TokenStream]) -> TokenStream {
    let triple = |start: usize| {
        let entries = &numbers[start..start + 3];
        quote!([#(#entries),*])
    };
    let (position, rows) = (triple(0), [triple(3), triple(6), triple(9)]);
    let (velocity, omega) = (triple(12), triple(15));
    let z = [triple(18), triple(21), triple(24), triple(27)];
    quote! {
        ::mstmm::Point::new(
            #position,
            [#(#rows),*],
            #velocity,
            #omega,
            ::mstmm::StateVector::new(#(#z),*),
        )
    }
}

fn energy(plan: &Plan) -> TokenStream {
    let (state, visibility) = (&plan.names.state, &plan.surface.visibility);
    let program = &plan.programs.energy;
    let block = plan.step_block(program);
    let (statements, kinetic, potential) =
        (block.statements, &block.outputs[0][0], &block.outputs[0][1]);
    let cost = docs::cost(program);
    quote! {
        /// Kinetic and potential energy in J; the potential is zero with every centre of mass at
        /// the inertial origin.
        ///
        #(#[doc = #cost])*
        #[must_use]
        #[allow(unused_doc_comments, unused_variables, clippy::all)]
        #visibility fn energy(&self, state: &#state<T>) -> ::mstmm::Energy<T> {
            #statements
            ::mstmm::Energy { kinetic: #kinetic, potential: #potential }
        }
    }
}

/// The test that comes before any result is written.
fn check(plan: &Plan, outputs: &[Vec<TokenStream>]) -> TokenStream {
    let (results, pivots, scales) = (&outputs[0], &outputs[1], &outputs[2]);
    let names = hinge_names(plan, &plan.programs.pivots);
    let inputs = plan.chain.hinges.iter().filter(|hinge| matches!(hinge.effort, Effort::Input));
    let inputs = inputs.map(|hinge| {
        let name = &hinge.name;
        match hinge.kind.shape().results {
            Results::Nothing => quote!(),
            Results::Number => quote!(&[inputs.#name],),
            Results::Vector => quote!(inputs.#name.as_slice(),),
        }
    });
    quote! {
        ::mstmm::generated::finite::<T>(&[
            state.q.as_slice(),
            state.v.as_slice(),
            #(#inputs)*
        ])?;
        ::mstmm::generated::regular::<T, _, _>(
            &[#(#names),*],
            [#(#pivots),*],
            [#(#scales),*],
            [#(#results),*],
        )?;
    }
}

fn hinge_names(plan: &Plan, links: &[usize]) -> Vec<String> {
    let hinge = |&link: &usize| &plan.chain.hinges[plan.layout.links[link].hinge];
    links.iter().map(|link| hinge(link).name.to_string()).collect()
}

/// The chain as integrators see it.
fn integrable(plan: &Plan) -> TokenStream {
    let (name, state, inputs) = (&plan.names.chain, &plan.names.state, &plan.names.inputs);
    let rates = map(plan, &plan.programs.coordinate_rates);
    let normalized = map(plan, &plan.programs.normalized);
    quote! {
        impl<T: ::mstmm::Scalar> ::mstmm::Chain for #name<T> {
            type Scalar = T;
            type State = #state<T>;
            type Inputs = #inputs<T>;

            #[inline]
            #[allow(unused_doc_comments, unused_variables, clippy::all)]
            fn derivative_into(
                &self,
                state: &#state<T>,
                inputs: &#inputs<T>,
                rate: &mut #state<T>,
            ) -> ::core::result::Result<(), ::mstmm::Error> {
                self.accelerations_into(state, inputs, &mut rate.v)?;
                rate.q.data.0 = { #rates };
                ::core::result::Result::Ok(())
            }

            #[inline]
            #[allow(unused_doc_comments, unused_variables, clippy::all)]
            fn normalize(&self, state: &mut #state<T>) {
                state.q.data.0 = { #normalized };
            }
        }
    }
}

/// The chain as generic code sees it.
fn generated(plan: &Plan) -> TokenStream {
    let (name, state, inputs) = (&plan.names.chain, &plan.names.state, &plan.names.inputs);
    let workspace = &plan.names.workspace;
    quote! {
        impl<T: ::mstmm::Scalar> ::mstmm::GeneratedChain for #name<T> {
            type Workspace = #workspace<T>;

            #[inline]
            fn initial_state(&self) -> #state<T> {
                self.initial_state()
            }

            #[inline]
            fn no_inputs(&self) -> #inputs<T> {
                self.no_inputs()
            }

            #[inline]
            fn workspace(&self) -> #workspace<T> {
                self.workspace()
            }

            #[inline]
            fn solve_into(
                &self,
                state: &#state<T>,
                inputs: &#inputs<T>,
                at: &mut #workspace<T>,
            ) -> ::core::result::Result<(), ::mstmm::Error> {
                self.solve_into(state, inputs, at)
            }

            #[inline]
            fn energy(&self, state: &#state<T>) -> ::mstmm::Energy<T> {
                self.energy(state)
            }
        }
    }
}

/// A program with one group of results, as the only column of a vector.
fn map(plan: &Plan, program: &Program) -> TokenStream {
    let block = plan.step_block(program);
    let (statements, results) = (block.statements, &block.outputs[0]);
    quote!(#statements [[#(#results),*]])
}
