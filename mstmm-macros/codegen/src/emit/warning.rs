//! Warnings of the macro. On stable Rust the only way is the use of a deprecated item.

use crate::diag::Warning;
use proc_macro2::{Ident, TokenStream};
use quote::quote;

/// Returns an item that makes rustc warn. Definition and use have the span of the user's token, so that the warning is
/// reported on the token and follows the lint levels there.
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
