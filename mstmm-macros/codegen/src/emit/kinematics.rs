//! The type of kinematics, with access to bodies by name.

use super::arrays::usize_literal;
use super::{EmitContext, initial_values, kinematics_bodies};
use crate::compile::{RatePaths, outputs};
use crate::model::{Answer, Request};
use crate::program::{Array, ArrayRole, OutputId};
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

/// Returns `struct ChainKinematics<T>` and the types of bodies with named points, if they are requested.
pub fn emit(cx: &EmitContext) -> TokenStream {
    if cx.compiled.find(Answer::Kinematics).is_none() {
        return TokenStream::new();
    }
    let mstmm = &cx.mstmm;
    let (name, chain) = (&cx.names.kinematics, &cx.names.chain);
    let visibility = &cx.passthrough.visibility;
    let columns = if cx.has_columns() { ", and the columns of their Jacobians" } else { "" };
    let doc = format!(
        " The kinematics of [`{chain}`]: the motions of all bodies at `v̇ = 0`{columns}. \
         [`{chain}::kinematics_into`] computes them."
    );
    let arrays: Vec<(Ident, TokenStream)> = ARRAYS
        .iter()
        .filter_map(|&id| {
            let initial = initial_values::array_of(cx, Answer::Kinematics, id)?;
            Some((field(id), initial))
        })
        .collect();
    let fields = arrays.iter().map(|(field, _)| {
        let length = usize_literal(cx.kinematic_array(field).layout.total);
        quote!(#field: [T; #length],)
    });
    let initial = arrays.iter().map(|(field, initial)| quote!(#field: #initial,));
    let paths = RatePaths::of(cx.chain, cx.layout);
    let runs = cx.has_columns().then(|| table(cx, &paths));
    let bodies = cx
        .chain
        .physical_bodies()
        .map(|body| kinematics_bodies::accessor(cx, body, paths.of_body(cx.layout, body)));
    let types = kinematics_bodies::types(cx);
    quote! {
        #[doc = #doc]
        #[derive(Clone, Debug, PartialEq)]
        #[allow(dead_code, non_snake_case)]
        #visibility struct #name<T> {
            #(#fields)*
        }
        /// Empty kinematics. Their contents are unspecified until they are computed.
        impl<T: #mstmm::Scalar> ::core::default::Default for #name<T> {
            #[allow(clippy::all)]
            fn default() -> Self {
                Self { #(#initial)* }
            }
        }
        #[allow(dead_code, non_snake_case)]
        impl<T: #mstmm::Scalar> #name<T> {
            #runs
            #(#bodies)*
        }
        #types
    }
}

/// Returns the table of the rates on the paths from bodies to the ground.
fn table(cx: &EmitContext, paths: &RatePaths) -> TokenStream {
    let mstmm = &cx.mstmm;
    let rows = paths.rows().into_iter().map(|(rates, next)| {
        let (rates, next) = (rates.map(usize_literal), next.map(usize_literal));
        quote!(#mstmm::generated::RateRun::new([#(#rates),*], [#(#next),*]))
    });
    quote! {
        /// The rates on the paths from bodies to the ground.
        const RUNS_: &'static [#mstmm::generated::RateRun] = &[#(#rows),*];
    }
}

/// The results that the kinematics store.
const ARRAYS: [OutputId; 3] = [outputs::MOTIONS, outputs::COLUMNS, outputs::FRAMES];

/// Returns the field of a result.
pub fn field(id: OutputId) -> Ident {
    format_ident!("{}", id.name)
}

impl EmitContext<'_> {
    /// Returns whether the kinematics have the columns of all rates.
    pub fn has_columns(&self) -> bool {
        self.chain.requests.contains(&Request::Jacobian)
    }

    /// Returns the array of the kinematics with the name of a field.
    fn kinematic_array(&self, name: &Ident) -> &Array {
        let arrays = &self.compiled.function(Answer::Kinematics).procedure.arrays;
        let is_it = |role: &ArrayRole| match role {
            ArrayRole::Result(id) => name == id.name,
            _ => false,
        };
        let found = arrays.iter().find(|array| is_it(&array.role));
        found.unwrap_or_else(|| bug!("the kinematics have no `{name}`"))
    }
}
