//! The compiler of `mstmm-codegen` as a procedural macro; use it through the crate `mstmm`.

use proc_macro::TokenStream;

/// What `mstmm::mstmm_chain!` stands for: the crate `mstmm` as a single token, by which generated
/// code calls it whatever its name is where the chain is written, and the description.
#[proc_macro]
pub fn mstmm_chain_by(input: TokenStream) -> TokenStream {
    let mut tokens = input.into_iter();
    let mstmm: TokenStream = tokens.next().into_iter().collect();
    let description: TokenStream = tokens.collect();
    let expansion = mstmm_codegen::expand(description.into(), &mstmm.into());
    expansion.items.into()
}
