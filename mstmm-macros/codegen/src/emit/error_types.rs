//! The types of chains with errors: rustc treats them as error types and reports no further errors where they are used.

use crate::syntax::{
    ChainSyntax, ContentSyntax, PathSyntax, RouteItemSyntax, RouteSyntax, answer_types,
};
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};
use std::collections::HashSet;
use syn::ext::IdentExt;

/// Returns the types of chains with errors, and the errors.
///
/// The inputs of the first chain are a type whose definition contains the errors. This type is the parameter of all other
/// types. rustc checks nothing that depends on an error type: neither methods and fields nor implemented traits. The other
/// types are structs, so that users can implement traits and methods for them.
pub fn error_types(chains: &[ChainSyntax], errors: &syn::Error) -> TokenStream {
    let errors = errors.to_compile_error();
    let Some(first) = chains.first() else { return errors };
    let error = format_ident!("{}Inputs", first.name);
    let visibility = &first.visibility;
    let mut types = quote! {
        #[allow(dead_code, non_camel_case_types)]
        #visibility type #error<T> = <[T; { #errors 0 }] as ::core::ops::Deref>::Target;
    };
    let mut taken = HashSet::from([error.to_string()]);
    for chain in chains {
        let (name, visibility) = (&chain.name, &chain.visibility);
        let inputs = format_ident!("{}Inputs", name);
        if taken.insert(inputs.to_string()) {
            types.extend(quote! {
                #[allow(dead_code, non_camel_case_types)]
                #visibility type #inputs<T> = #error<T>;
            });
        }
        for name in structs(chain).filter(is_identifier) {
            if !taken.insert(name.to_string()) {
                continue;
            }
            let of_error = format_ident!("{}OfErrors_", name);
            types.extend(quote! {
                #[doc(hidden)]
                #[allow(dead_code, non_snake_case, non_camel_case_types)]
                #visibility struct #of_error<T, E> {
                    #visibility q: E,
                    #visibility v: E,
                    #visibility t: T,
                }
                #[allow(dead_code, non_camel_case_types)]
                #visibility type #name<T> = #of_error<T, #error<T>>;
            });
        }
    }
    types
}

/// Returns the names of all types of a chain except its inputs, which users construct field by field. Any name of a block
/// or of the route may be a body type.
fn structs(chain: &ChainSyntax) -> impl Iterator<Item = Ident> {
    let name = &chain.name;
    let of_chain = ["State", "Parameters", "Workspace", "Kinematics"];
    let of_chain = of_chain.into_iter().chain(answer_types(chain));
    let of_chain = of_chain.map(move |suffix| format_ident!("{}{suffix}", name));
    let types = |part: &str, content: &ContentSyntax| {
        let described = content.blocks.iter().flat_map(|block| &block.names).map(PathSyntax::end);
        let items = content.routes.iter().flat_map(RouteSyntax::items);
        let used = items.filter_map(|item| match item {
            RouteItemSyntax::Element { word, .. } => Some(word),
            _ => None,
        });
        let results = described.chain(used);
        results.map(|body| format_ident!("{}{}{}Result", name, part, body)).collect::<Vec<_>>()
    };
    let parts = chain.parts.iter();
    let of_parts = parts.flat_map(|part| types(&part.name.unraw().to_string(), &part.content));
    let results: Vec<Ident> = types("", &chain.content).into_iter().chain(of_parts).collect();
    [name.clone()].into_iter().chain(of_chain).chain(results)
}

/// Returns whether a name is a valid identifier of a type.
fn is_identifier(name: &Ident) -> bool {
    let text = name.to_string();
    match text.strip_prefix("r#") {
        Some(raw) => !["self", "Self", "super", "crate", "_"].contains(&raw),
        None => text != "gen" && syn::parse_str::<Ident>(&text).is_ok(),
    }
}
