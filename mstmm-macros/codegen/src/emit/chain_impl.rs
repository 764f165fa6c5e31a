//! The implementations of `Chain` and `GeneratedChain`, with the projection of closed chains onto their loop constraints.

use super::EmitContext;
use super::{quaternions, rotations};
use crate::compile::{CompiledFunction, outputs};
use crate::model::Answer;
use crate::program::{ArrayRole, Operand, Step};
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

/// Returns the implementation of `Chain`, which integrators use.
pub fn chain_impl(cx: &EmitContext) -> TokenStream {
    let mstmm = &cx.mstmm;
    let (name, state, inputs) = (&cx.names.chain, &cx.names.state, &cx.names.inputs);
    let implicit = implicit_derivative(cx);
    let checks = quaternions::checks(cx);
    let correction = cx.compiled.find(Answer::Correction);
    let project = correction.map(|function| project(cx, function));
    let assembly = correction.map(|_| assembly(cx));
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
                self.coordinate_rates_into_(state_, &mut rate_.q);
            }

            #[inline]
            #[allow(unused_doc_comments, unused_variables, clippy::all)]
            fn normalize(&self, state_: &mut #state<T>) {
                state_.q.data.0 = [self.normalized_(state_)];
            }

            #checks

            #project
        }

        #assembly
    }
}

/// Returns the method for the derivative with implicit accelerations, if the chain computes them.
fn implicit_derivative(cx: &EmitContext) -> Option<TokenStream> {
    let (mstmm, state, inputs) = (&cx.mstmm, &cx.names.state, &cx.names.inputs);
    let step = cx.step();
    cx.compiled.find(Answer::ImplicitAccelerations).map(|_| {
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
    })
}

/// Returns the implementation of `Deref`: methods that the description does not ask for are errors that name the word.
/// Those of bodies are listed, since their names depend on the chain.
pub fn not_asked(cx: &EmitContext) -> TokenStream {
    let (mstmm, name) = (&cx.mstmm, &cx.names.chain);
    let has_jacobian = |id| cx.compiled.jacobians.iter().any(|(body, _)| *body == id);
    let others = cx.chain.physical_bodies().filter(|&id| !has_jacobian(id)).map(|id| {
        let body = &cx.chain.bodies[id].name;
        let [by_value, into] =
            ["_jacobian", "_jacobian_into"].map(|end| format_ident!("{body}{end}"));
        quote!(#by_value #into)
    });
    quote!(#mstmm::generated::not_asked! { #name #(#others)* })
}

/// Returns the method of `Chain` that projects a closed chain onto its loop constraints.
fn project(cx: &EmitContext, correction: &CompiledFunction) -> TokenStream {
    let (mstmm, state, inputs) = (&cx.mstmm, &cx.names.state, &cx.names.inputs);
    let hinge = closing_hinge(cx);
    let check =
        has_excess(correction).then(|| quote!(#mstmm::generated::check_rank(residual_, #hinge)?;));
    quote! {
        #[inline]
        fn project<E: ::core::convert::From<#mstmm::Error>>(
            &self,
            state_: &mut #state<T>,
            inputs_: impl ::core::ops::FnOnce(
                &#state<T>,
            ) -> ::core::result::Result<#inputs<T>, E>,
        ) -> ::core::result::Result<(), E> {
            let inputs_ = inputs_(state_)?;
            let before_ = state_.q;
            let residual_ = self.correct(state_, &inputs_);
            #mstmm::generated::check_rotations(
                before_.as_slice(),
                state_.q.as_slice(),
                Self::ROTATIONS_,
            )?;
            #check
            ::core::result::Result::Ok(())
        }
    }
}

/// Returns the methods that assemble a closed chain.
fn assembly(cx: &EmitContext) -> TokenStream {
    let (mstmm, name) = (&cx.mstmm, &cx.names.chain);
    let (assemble, closure_error) = (assemble(cx), closure_error(cx));
    let correct_nearby = correct_nearby(cx);
    quote! {
        impl<T: #mstmm::Scalar> #name<T> {
            #assemble

            #closure_error

            #correct_nearby
        }
    }
}

/// Returns the method that moves a state to one that satisfies the loop constraints.
fn assemble(cx: &EmitContext) -> TokenStream {
    let (mstmm, state, inputs) = (&cx.mstmm, &cx.names.state, &cx.names.inputs);
    let (visibility, hinge) = (&cx.passthrough.visibility, closing_hinge(cx));
    let (checked, errors) = (quaternions::checked(cx), quaternions::error(cx));
    quote! {
        /// Assembles the chain: moves `state` to nearby coordinates and rates that satisfy the loop
        /// constraints.
        ///
        /// The coordinates are found by Newton's method. Of all small motions that satisfy the
        /// linearised constraints, each correction is the one with the least kinetic energy,
        /// ½ δᵀ M δ for a motion δ along the rates and the mass matrix M of bodies and rotors. The
        /// sum of several corrections is minimal up to the square of its length. No hinge but a
        /// screw rotates by more than half a rad in one correction. With each
        /// correction the rates change, too: by the smallest change in kinetic energy that
        /// satisfies the constraints of the velocities, as an impulse in the closing hinge would
        /// change them.
        ///
        /// # Errors
        ///
        /// `Error::NotAssembled` if the corrections do not converge, `Error::ClosureRank` if the loop
        /// constraints have a higher rank at the result than around the start of the description, and
        /// `Error::NotFinite` if the state or the inputs are not finite; `state` is then unchanged.
        #(#[doc = #errors])*
        #[allow(dead_code)]
        #visibility fn assemble(
            &self,
            state_: &mut #state<T>,
            inputs_: &#inputs<T>,
        ) -> ::core::result::Result<(), #mstmm::Error> {
            #checked
            #mstmm::generated::assemble::<Self>(
                state_,
                inputs_,
                #hinge,
                |state_, inputs_| self.correct_nearby_(state_, inputs_),
            )
        }
    }
}

/// Returns the method that computes how far a state is from satisfying the loop constraints.
fn closure_error(cx: &EmitContext) -> TokenStream {
    let (mstmm, state, inputs) = (&cx.mstmm, &cx.names.state, &cx.names.inputs);
    let visibility = &cx.passthrough.visibility;
    let (checked, errors) = (quaternions::checked(cx), quaternions::error(cx));
    quote! {
        /// Returns how far the chain is from being closed: the norm of the displacement, the rotation and the
        /// velocities across the closing hinge, in m, rad, m/s and rad/s. It is near the machine epsilon after
        /// `assemble`, and about the square of their error after steps. Other functions take the state as it is.
        ///
        /// # Errors
        ///
        /// `Error::NotFinite` if the state or the inputs are not finite.
        #(#[doc = #errors])*
        #[doc(alias("constraint violation", "constraint residual", "efc_pos"))]
        #[allow(dead_code)]
        #visibility fn closure_error(
            &self,
            state_: &#state<T>,
            inputs_: &#inputs<T>,
        ) -> ::core::result::Result<T, #mstmm::Error> {
            #checked
            let residual_ = self.correct(&mut ::core::clone::Clone::clone(state_), inputs_);
            #mstmm::generated::closure_error::<Self>(state_, inputs_, residual_)
        }
    }
}

/// Returns the private method for one correction with limited rotations, and the table of rotations.
fn correct_nearby(cx: &EmitContext) -> TokenStream {
    let (mstmm, state, inputs) = (&cx.mstmm, &cx.names.state, &cx.names.inputs);
    let rotations = rotations::table(cx);
    quote! {
        /// The coordinates that are rotations.
        const ROTATIONS_: &'static [#mstmm::generated::RotationCoordinates] = #rotations;

        /// Corrects the state once, with rotations of at most half a rad.
        fn correct_nearby_(
            &self,
            state_: &mut #state<T>,
            inputs_: &#inputs<T>,
        ) -> #mstmm::generated::Residual<T> {
            let before_ = state_.q;
            let residual_ = self.correct(state_, inputs_);
            if #mstmm::generated::limit_rotations(
                before_.as_slice(),
                state_.q.as_mut_slice(),
                Self::ROTATIONS_,
            ) {
                #mstmm::Chain::normalize(self, state_);
            }
            residual_
        }
    }
}

/// Returns the path of the hinge that closes the loop.
fn closing_hinge<'a>(cx: &'a EmitContext) -> &'a str {
    let closing = cx.layout.loop_hinges.first();
    let closing = closing.unwrap_or_else(|| bug!("a chain without a closing hinge is projected"));
    &cx.chain.hinges[*closing].path
}

/// Returns the implementation of `GeneratedChain`, which generic code uses.
pub fn generated(cx: &EmitContext) -> TokenStream {
    let mstmm = &cx.mstmm;
    let (name, state, inputs) = (&cx.names.chain, &cx.names.state, &cx.names.inputs);
    let workspace = &cx.names.workspace;
    let assemble = cx.compiled.find(Answer::Correction).map(|_| {
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

/// Returns the method `energy` without inputs, for a chain with prescribed hinges.
pub fn energy(cx: &EmitContext) -> Option<TokenStream> {
    let (mstmm, state, visibility) = (&cx.mstmm, &cx.names.state, &cx.passthrough.visibility);
    cx.chain.has_prescribed_hinges().then(|| {
        quote! {
            /// Returns kinetic and potential energy in J, with prescribed motions at rest in the zero position.
            #[inline]
            #[must_use]
            #visibility fn energy(&self, state_: &#state<T>) -> #mstmm::Energy<T> {
                self.energy_with(state_, &self.no_inputs())
            }
        }
    })
}

/// Returns whether directions of the closing hinge that count as redundant may constrain the chain.
fn has_excess(correction: &CompiledFunction) -> bool {
    let arrays = &correction.procedure.arrays;
    let residual = arrays.position(|it| it.role == ArrayRole::Result(outputs::RESIDUAL));
    correction.procedure.body.iter().any(|step| match step {
        Step::Store { to, values } if Some(to.array) == residual => {
            values.last() != Some(&Some(Operand::Number(0.0)))
        }
        _ => false,
    })
}
