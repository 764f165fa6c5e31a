//! Skeletons of wrong chains, whose names may be any: what would clash in a type is left out.

use proc_macro2::TokenStream;
use quote::{ToTokens, quote};
use std::collections::HashSet;
use syn::{ImplItem, Item};

/// The items of skeletons with one method of a name for each type: the first. What every chain has is
/// written before what is named after its elements.
pub fn without_clashes(items: TokenStream) -> TokenStream {
    let Ok(mut file) = syn::parse2::<syn::File>(items.clone()) else {
        unreachable!("mstmm bug: the expansion of a chain does not parse: {items}");
    };
    let mut taken = HashSet::new();
    for item in &mut file.items {
        let Item::Impl(block) = item else { continue };
        if block.trait_.is_some() {
            continue;
        }
        let owner = block.self_ty.to_token_stream().to_string();
        block.items.retain(|member| {
            let name = match member {
                ImplItem::Fn(method) => &method.sig.ident,
                ImplItem::Const(constant) => &constant.ident,
                _ => return true,
            };
            taken.insert((owner.clone(), name.to_string()))
        });
    }
    let items = file.items;
    quote!(#(#items)*)
}
