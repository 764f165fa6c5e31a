//! What the generated items take over from the description word for word.

use proc_macro2::{Ident, TokenStream};

/// Tokens that pass through the compiler unread.
#[derive(Debug)]
pub struct Passthrough {
    /// Visibility of the generated types.
    pub visibility: syn::Visibility,
    /// Attributes, doc comments among them, of the chain.
    pub attributes: Vec<syn::Attribute>,
    /// The Rust paths that stand for numbers, in the order of [`crate::model::Symbol::Constant`].
    pub constants: Vec<TokenStream>,
    /// Where names stand again.
    pub references: References,
}

/// Names that an editor can follow to where they are given.
#[derive(Debug, Default)]
pub struct References {
    /// Of hinges and bodies, in blocks behind the route.
    pub elements: Vec<Ident>,
    /// The names of all types of bodies where they are described.
    pub types: Vec<Ident>,
    /// The same on the route.
    pub uses_of_types: Vec<Ident>,
}
