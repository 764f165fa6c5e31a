//! Prints procedures as Rust: the only module that writes items.

mod arguments;
mod arrays;
mod body;
mod chain_impl;
mod checks;
mod closure;
mod columns;
mod const_expr;
mod constructor;
mod deprecated;
mod derivatives;
mod description;
mod docs;
mod drawing;
mod error_types;
mod gravity;
mod ide_links;
mod indexed_access;
mod initial_values;
mod inputs;
mod kinematics;
mod kinematics_bodies;
mod loop_inputs;
mod loops;
mod methods;
mod motor_inputs;
mod names;
mod orders;
mod parameters;
mod point_access;
mod printer;
mod procedure;
mod quaternions;
mod rotations;
mod routes;
mod sealed;
mod spring;
mod state;
mod statement;
mod tables;
mod variation;
mod warning;
mod workspace;

use crate::compile::Compiled;
use crate::examine::Findings;
use crate::ids::{IdVec, SymbolId};
use crate::model::{Chain, Layout};
use crate::program::Argument;
use crate::syntax::Passthrough;
use arrays::ArrayLayouts;
use body::BodyReports;
pub use drawing::drawing_file;
pub use error_types::error_types;
use names::{TypeNames, variable};
use proc_macro2::{Ident, TokenStream};
use quote::quote;
pub use tables::{BodyRow, Entry, HingeRow, NamedArray, Tables, tables};
pub use warning::warning;

/// The inputs of all modules that write parts of the expansion.
struct EmitContext<'a> {
    chain: &'a Chain,
    passthrough: &'a Passthrough,
    layout: &'a Layout,
    compiled: &'a Compiled,
    findings: &'a Findings,
    names: TypeNames,
    layouts: ArrayLayouts,
    body_reports: BodyReports,
    /// The variables of the unknowns.
    unknowns: IdVec<SymbolId, Ident>,
    /// The path of the crate `mstmm`.
    mstmm: &'a TokenStream,
}

/// Returns the items of a chain. `mstmm` is the path of the crate `mstmm` in the user's crate.
pub fn expand(
    chain: &Chain,
    passthrough: &Passthrough,
    layout: &Layout,
    compiled: &Compiled,
    findings: &Findings,
    mstmm: &TokenStream,
) -> TokenStream {
    let cx = EmitContext {
        chain,
        passthrough,
        layout,
        compiled,
        findings,
        names: TypeNames::of(chain),
        layouts: ArrayLayouts::of(chain, layout, compiled),
        body_reports: BodyReports::of(chain, &compiled.point_storage.of),
        unknowns: compiled.unknowns.iter().map(|unknown| variable(&unknown.name)).collect(),
        mstmm,
    };
    let constructor = constructor::emit(&cx);
    let methods = methods::emit(&cx);
    let state = state::emit(&cx);
    let inputs = inputs::emit(&cx);
    let motor_inputs = motor_inputs::emit(&cx);
    let workspace = workspace::emit(&cx);
    let kinematics = kinematics::emit(&cx);
    let variation = variation::emit(&cx);
    let derivatives = derivatives::emit(&cx);
    let description = description::emit(&cx);
    let ide_links = ide_links::emit(&cx);
    let items = quote! {
        #constructor
        #methods
        #state
        #inputs
        #motor_inputs
        #workspace
        #kinematics
        #variation
        #derivatives
        #description
        #ide_links
    };
    deprecated::without_warnings(&cx, items)
}

impl EmitContext<'_> {
    /// Returns the variable of the length of an implicit step.
    fn step(&self) -> &Ident {
        &self.unknowns[self.compiled.unknowns.of(Argument::Step).first()]
    }

    /// Returns statements that may fail, so that the workspace is reset after a failure.
    fn with_reset(&self, statements: TokenStream) -> TokenStream {
        let mstmm = &self.mstmm;
        let reset = quote!(#mstmm::generated::reset(at_, || self.workspace()););
        checks::with_reset(Some(&reset), statements)
    }
}
