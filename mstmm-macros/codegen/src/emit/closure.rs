//! Finds the rank of a loop closure when parameters are set.

use super::EmitContext;
use super::arrays::usize_literal;
use crate::model::ClosureRank;
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

/// Returns the number of directions that the closing hinge constrains, if their rank is found at run time.
pub fn directions(cx: &EmitContext) -> Option<usize> {
    match cx.findings.closure_rank {
        ClosureRank::FoundAtRunTime(directions) => Some(directions),
        ClosureRank::Unknown | ClosureRank::Known { .. } => None,
    }
}

/// Returns the private field of the parameters' type with the elimination steps; its name differs from all parameters.
pub fn steps(cx: &EmitContext) -> Ident {
    let mut name = "closure_steps_".to_owned();
    while cx.chain.parameters.iter().any(|parameter| parameter.name == name) {
        name.push('_');
    }
    format_ident!("{name}")
}

/// Returns the expression `chain`, or the chain with its rank found again if frames, axes or the start may have changed.
pub fn with_rank(cx: &EmitContext, may_have_changed: bool, chain: TokenStream) -> TokenStream {
    if may_have_changed && directions(cx).is_some() { quote!(#chain.find_rank_()) } else { chain }
}

/// Returns the method that finds the rank, if it is found at run time.
pub fn emit(cx: &EmitContext) -> TokenStream {
    let Some(directions) = directions(cx) else { return TokenStream::new() };
    let (mstmm, steps) = (&cx.mstmm, steps(cx));
    let count = usize_literal(directions);
    quote! {
        /// The chain with the rank of its closure, which frames and axes decide.
        #[allow(clippy::all)]
        fn find_rank_(self) -> Self {
            let mut parameters_ = *self.parameters();
            parameters_.#steps = [T::constant(1.0); #count];
            let (free_, _) = Self::derive(#mstmm::generated::Sealed::new(parameters_));
            let inputs_ = free_.no_inputs();
            parameters_.#steps = #mstmm::generated::rank_steps(
                &free_.initial_state(),
                |state_| #mstmm::Chain::normalize(&free_, state_),
                |state_| free_.correct_nearby_(state_, &inputs_),
                |state_| free_.closure_pivots_(state_),
            );
            let (chain_, _) = Self::derive(#mstmm::generated::Sealed::new(parameters_));
            chain_
        }
    }
}
