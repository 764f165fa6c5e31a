//! From programs to Rust: the only place that writes tokens.

mod block;
mod body;
mod closure;
mod construction;
mod delivery;
mod docs;
mod drawing;
mod dynamics;
mod formula;
mod gravity;
mod inputs;
mod integrable;
mod looped;
mod names;
mod orders;
mod parameters;
mod places;
mod quaternions;
mod references;
mod repeated;
mod sealed;
mod solution;
mod spread;
mod state;
mod statement;
mod warning;
mod workspace;
mod wrong;

use crate::compile::Programs;
use crate::examine::Findings;
use crate::model::{Chain, Layout};
use crate::syntax::Surface;
use names::{Names, variable};
use proc_macro2::{Ident, TokenStream};
use quote::quote;
pub use warning::warning;
pub use wrong::wrong;

/// All that the parts of the expansion are written from.
struct Plan<'a> {
    chain: &'a Chain,
    surface: &'a Surface,
    layout: &'a Layout,
    programs: &'a Programs,
    findings: &'a Findings,
    names: Names,
    /// The variables that unknowns are, by number.
    unknowns: Vec<Ident>,
    /// The path of the crate `mstmm`.
    mstmm: &'a TokenStream,
}

/// The items that stand for `chain` in the user's crate, which calls `mstmm` by this path.
pub fn expand(
    chain: &Chain,
    surface: &Surface,
    layout: &Layout,
    programs: &Programs,
    findings: &Findings,
    mstmm: &TokenStream,
) -> TokenStream {
    let names = Names::of(chain);
    let unknowns = programs.symbols.names().iter().map(|text| variable(text)).collect();
    let plan = Plan { chain, surface, layout, programs, findings, names, unknowns, mstmm };
    let construction = construction::emit(&plan);
    let dynamics = dynamics::emit(&plan);
    let state = state::emit(&plan);
    let inputs = inputs::emit(&plan);
    let workspace = workspace::emit(&plan);
    let references = references::emit(&plan);
    quote! {
        #construction
        #dynamics
        #state
        #inputs
        #workspace
        #references
    }
}
