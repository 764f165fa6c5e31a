//! What the generated items take over from the description word for word.

use proc_macro2::TokenStream;

/// Tokens that pass through the compiler unread.
#[derive(Debug)]
pub struct Surface {
    /// Visibility of the generated types.
    pub visibility: syn::Visibility,
    /// Attributes, doc comments among them, of the chain.
    pub attributes: Vec<syn::Attribute>,
    /// The Rust paths that stand for numbers, in the order of [`crate::model::Symbol::Constant`].
    pub constants: Vec<TokenStream>,
}
