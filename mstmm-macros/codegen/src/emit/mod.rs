//! From programs to Rust: the only place that writes tokens.

mod arrays;
mod body;
mod checks;
mod closure;
mod construction;
mod docs;
mod drawing;
mod formula;
mod gravity;
mod inputs;
mod integrable;
mod loads;
mod loops;
mod methods;
mod names;
mod orders;
mod parameters;
mod places;
mod printer;
mod procedure;
mod quaternions;
mod references;
mod repeated;
mod sealed;
mod solution;
mod state;
mod statement;
mod streams;
mod warning;
mod workspace;
mod wrong;

use crate::compile::Compiled;
use crate::examine::Findings;
use crate::model::{Chain, Layout};
use crate::program::Argument;
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
    compiled: &'a Compiled,
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
    compiled: &Compiled,
    findings: &Findings,
    mstmm: &TokenStream,
) -> TokenStream {
    let names = Names::of(chain);
    let unknowns = compiled.unknowns.iter().map(|unknown| variable(&unknown.name)).collect();
    let plan = Plan { chain, surface, layout, compiled, findings, names, unknowns, mstmm };
    let construction = construction::emit(&plan);
    let methods = methods::emit(&plan);
    let state = state::emit(&plan);
    let inputs = inputs::emit(&plan);
    let workspace = workspace::emit(&plan);
    let references = references::emit(&plan);
    quote! {
        #construction
        #methods
        #state
        #inputs
        #workspace
        #references
    }
}

impl Plan<'_> {
    /// The variable of the length of an implicit step.
    fn step(&self) -> &Ident {
        &self.unknowns[self.compiled.unknowns.of(Argument::Step).start]
    }

    /// Statements that may fail and that make a workspace anew where they do.
    fn reset_where_it_fails(&self, statements: TokenStream) -> TokenStream {
        let mstmm = &self.mstmm;
        let reset = quote!(#mstmm::generated::take_back(at_, || self.workspace()););
        checks::failing(Some(&reset), statements)
    }
}
