//! Deprecated chains.

use super::EmitContext;
use proc_macro2::TokenStream;
use quote::quote;

/// Returns the items of a chain. If the chain is deprecated, the items use it without a warning; the warnings are for the
/// user's code.
pub fn without_warnings(cx: &EmitContext, items: TokenStream) -> TokenStream {
    let mut attributes = cx.passthrough.attributes.iter();
    if !attributes.any(|attribute| attribute.path().is_ident("deprecated")) {
        return items;
    }
    let file: syn::File = syn::parse2(items)
        .unwrap_or_else(|error| bug!("the items of a chain have a syntax error: {error}"));
    let items = file.items.iter().map(|item| match item {
        // Attributes of a macro call do not apply to the items that it makes.
        syn::Item::Macro(call) => quote! {
            #[allow(deprecated)]
            const _: () = { #call };
        },
        item => quote!(#[allow(deprecated)] #item),
    });
    items.collect()
}
