//! Tokens that the generated items have unchanged.

use proc_macro2::{Ident, TokenStream};

/// Tokens that the compiler passes to the generated code unread.
#[derive(Debug)]
pub struct Passthrough {
    /// Visibility of the generated types.
    pub visibility: syn::Visibility,
    /// Attributes of the chain, including its doc comments.
    pub attributes: Vec<syn::Attribute>,
    /// The Rust paths of constants, in the order of [`crate::model::Symbol::Constant`].
    pub constants: Vec<TokenStream>,
    /// The instances of parts, in the order of the text.
    pub instances: Vec<PartInstance>,
    /// Uses of names.
    pub references: References,
}

/// An instance of a part.
#[derive(Debug)]
pub struct PartInstance {
    /// Its path: `rex.lf`.
    pub path: String,
    /// The name of the part.
    pub part: Ident,
    /// The doc comments of the part.
    pub docs: Vec<syn::Attribute>,
}

/// Uses of names that an editor can follow to their definitions.
#[derive(Debug, Default)]
pub struct References {
    /// Names of hinges and bodies in blocks after the route.
    pub elements: Vec<Ident>,
    /// The names of body types in their own blocks.
    pub types: Vec<Ident>,
    /// The same on the route.
    pub uses_of_types: Vec<Ident>,
}
