//! Warnings, which stable Rust lets a macro give in one way: by the use of something deprecated.

use crate::diag::Warning;
use proc_macro2::{Ident, TokenStream};
use quote::quote;

/// An item that makes the compiler warn. Both names have the place and the hygiene of the user's
/// token, so that the warning is on the token and is subject to the lint levels there.
pub fn warning(warning: &Warning) -> TokenStream {
    let Warning { at, rule, message } = warning;
    let name = Ident::new(rule, *at);
    quote! {
        const _: () = {
            #[deprecated(note = #message)]
            const #name: () = ();
            #name
        };
    }
}
