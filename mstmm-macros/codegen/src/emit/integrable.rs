//! The chain as integrators and generic code see it, and how a closed one is put back onto its
//! closure.

use super::Plan;
use super::docs;
use super::looped::Target;
use super::quaternions;
use super::spread::Spread;
use crate::program::{Operand, Program};
use proc_macro2::TokenStream;
use quote::quote;

/// The chain as integrators see it.
pub fn integrable(plan: &Plan) -> TokenStream {
    let mstmm = &plan.mstmm;
    let (name, state, inputs) = (&plan.names.chain, &plan.names.state, &plan.names.inputs);
    let rates = map(plan, &plan.programs.coordinate_rates);
    let normalized = map(plan, &plan.programs.normalized);
    let step = &plan.unknowns[plan.programs.symbols.step().start];
    let implicit = plan.programs.implicit.as_ref().map(|_| {
        quote! {
            #[inline]
            fn implicit_derivative_into(
                &self,
                state_: &#state<T>,
                inputs_: &#inputs<T>,
                #step: T,
                rate_: &mut #state<T>,
            ) -> ::core::result::Result<(), #mstmm::Error> {
                self.implicit_accelerations_into(state_, inputs_, #step, &mut rate_.v)?;
                self.configuration_rate_into(state_, rate_);
                ::core::result::Result::Ok(())
            }
        }
    });
    let checks = quaternions::checks(plan);
    let correction = correction(plan);
    let (correct, close, assemble) = (&correction.correct, &correction.close, &correction.assemble);
    quote! {
        impl<T: #mstmm::Scalar> #mstmm::Chain for #name<T> {
            type Scalar = T;
            type State = #state<T>;
            type Inputs = #inputs<T>;

            #[inline]
            #[allow(unused_doc_comments, unused_variables, clippy::all)]
            fn derivative_into(
                &self,
                state_: &#state<T>,
                inputs_: &#inputs<T>,
                rate_: &mut #state<T>,
            ) -> ::core::result::Result<(), #mstmm::Error> {
                self.accelerations_into(state_, inputs_, &mut rate_.v)?;
                self.configuration_rate_into(state_, rate_);
                ::core::result::Result::Ok(())
            }

            #implicit

            #[inline]
            #[allow(unused_doc_comments, unused_variables, clippy::all)]
            fn configuration_rate_into(&self, state_: &#state<T>, rate_: &mut #state<T>) {
                rate_.q.data.0 = { #rates };
            }

            #[inline]
            #[allow(unused_doc_comments, unused_variables, clippy::all)]
            fn normalize(&self, state_: &mut #state<T>) {
                state_.q.data.0 = { #normalized };
            }

            #checks

            #close
        }

        #correct
        #assemble
    }
}

/// How a closed chain is put back onto its closure.
struct Correction {
    correct: TokenStream,
    close: TokenStream,
    assemble: TokenStream,
}

fn correction(plan: &Plan) -> Correction {
    let mstmm = &plan.mstmm;
    let Some(program) = &plan.programs.correction else {
        let [correct, close, assemble] = [(); 3].map(|()| TokenStream::new());
        return Correction { correct, close, assemble };
    };
    let (name, state, inputs) = (&plan.names.chain, &plan.names.state, &plan.names.inputs);
    let visibility = &plan.surface.visibility;
    let targets = [(0, Spread::coordinates(plan)), (1, Spread::freedoms(plan))];
    let targets = targets.map(|(group, spread)| Target::new(group, spread));
    let block = plan.step(program, &targets, false);
    let checked = quaternions::checked(plan);
    let (statements, q, v, residual) =
        (block.statements, &block.arrays[0], &block.arrays[1], &block.outputs[2]);
    let closing = plan.layout.closings.first();
    let closing = closing.unwrap_or_else(|| bug!("a chain without a closing hinge is corrected"));
    let hinge = plan.chain.hinges[*closing].name.to_string();
    let check = (program.outputs[2][1] != Operand::Number(0.0))
        .then(|| quote!(#mstmm::generated::check_closure(residual_, #hinge)?;));
    let (cost, errors) = (docs::cost(program), quaternions::error(plan));
    Correction {
        correct: quote! {
            #[allow(dead_code)]
            impl<T: #mstmm::Scalar> #name<T> {
                /// Corrects coordinates and rates once by the motion of least kinetic energy that
                /// closes the chain, and returns how far it was from closed and how much
                /// redundant directions of the closing hinge held.
                ///
                #(#[doc = #cost])*
                #[allow(unused_doc_comments, unused_variables, clippy::all)]
                fn correct(&self, state_: &mut #state<T>, inputs_: &#inputs<T>) -> [T; 2] {
                    #statements
                    let residual_ = [#(#residual),*];
                    state_.q.data.0 = [#q];
                    state_.v.data.0 = [#v];
                    residual_
                }
            }
        },
        close: quote! {
            #[inline]
            fn close<E: ::core::convert::From<#mstmm::Error>>(
                &self,
                state_: &mut #state<T>,
                inputs_: impl ::core::ops::FnOnce(
                    &#state<T>,
                ) -> ::core::result::Result<#inputs<T>, E>,
            ) -> ::core::result::Result<(), E> {
                let inputs_ = inputs_(state_)?;
                let residual_ = self.correct(state_, &inputs_);
                #check
                ::core::result::Result::Ok(())
            }
        },
        assemble: quote! {
            impl<T: #mstmm::Scalar> #name<T> {
                /// Closes the chain: moves `state` to coordinates and rates nearby that fulfil the
                /// closure.
                ///
                /// The coordinates are found by Newton's method. Of all small motions that close
                /// the gap to first order, each correction is the one with the least kinetic energy,
                /// ½ δᵀ M δ for a motion δ along the rates and the mass matrix M of bodies and rotors.
                /// The rates are changed along with them: of all changes that make the closing
                /// hinge's sides move alike, each is the one with the least kinetic energy, as
                /// an impulse in the closing hinge would make it. Each correction is minimal; the sum
                /// of several corrections is minimal up to the square of its length.
                ///
                /// # Errors
                ///
                /// `Error::NotAssembled` if the corrections do not converge, `Error::Closure` if they lead to
                /// a pose in which the closure has a higher rank than around the start;
                /// `state` is left as it was.
                #(#[doc = #errors])*
                #[allow(dead_code)]
                #visibility fn assemble(
                    &self,
                    state_: &mut #state<T>,
                    inputs_: &#inputs<T>,
                ) -> ::core::result::Result<(), #mstmm::Error> {
                    #checked
                    #mstmm::generated::assemble(state_, #hinge, |state_| self.correct(state_, inputs_))
                }
            }
        },
    }
}

/// The chain as generic code sees it.
pub fn generated(plan: &Plan) -> TokenStream {
    let mstmm = &plan.mstmm;
    let (name, state, inputs) = (&plan.names.chain, &plan.names.state, &plan.names.inputs);
    let workspace = &plan.names.workspace;
    let assemble = plan.programs.correction.as_ref().map(|_| {
        quote! {
            #[inline]
            fn assemble(
                &self,
                state_: &mut #state<T>,
                inputs_: &#inputs<T>,
            ) -> ::core::result::Result<(), #mstmm::Error> {
                self.assemble(state_, inputs_)
            }
        }
    });
    quote! {
        impl<T: #mstmm::Scalar> #mstmm::GeneratedChain for #name<T> {
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
                state_: &#state<T>,
                inputs_: &#inputs<T>,
                at_: &mut #workspace<T>,
            ) -> ::core::result::Result<(), #mstmm::Error> {
                self.solve_into(state_, inputs_, at_)
            }

            #assemble

            #[inline]
            fn energy(&self, state_: &#state<T>) -> #mstmm::Energy<T> {
                self.energy(state_)
            }
        }
    }
}

/// A program that maps coordinates, as the only column of a vector.
fn map(plan: &Plan, program: &Program) -> TokenStream {
    let target = Target::new(0, Spread::coordinates(plan));
    let block = plan.step(program, &[target], false);
    let (statements, results) = (block.statements, &block.arrays[0]);
    quote!(#statements [#results])
}
