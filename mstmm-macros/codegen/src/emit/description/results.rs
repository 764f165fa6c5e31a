//! The results in a workspace by their indices.

use super::super::{EmitContext, initial_values};
use crate::compile::outputs;
use proc_macro2::TokenStream;
use quote::quote;

/// Returns the methods that read a workspace.
pub fn emit(cx: &EmitContext) -> TokenStream {
    let (mstmm, workspace) = (&cx.mstmm, &cx.names.workspace);
    let described = quote!(#mstmm::generated::description);
    let energy = match cx.chain.results.energies {
        true => quote!(::core::option::Option::Some(#mstmm::Energy {
            kinetic: at_.kinetic_energy,
            potential: at_.potential_energy,
        })),
        false => quote!(::core::option::Option::None),
    };
    let springs = match initial_values::length(cx, outputs::SPRINGS) {
        Some(_) => quote!(&at_.springs),
        None => quote!(&[]),
    };
    quote! {
        fn arrays_(at_: &#workspace<T>) -> #described::Arrays_<'_, T> {
            #described::Arrays_ {
                accelerations: at_.accelerations.as_slice(),
                efforts: at_.efforts.as_slice(),
                energy: #energy,
                springs: #springs,
                base_acceleration: &at_.base_acceleration,
            }
        }
        fn point_(
            at_: &#workspace<T>,
            index_: ::core::primitive::usize,
        ) -> #described::PointResult_<T> {
            ::core::convert::From::from(at_.point_(index_))
        }
    }
}
