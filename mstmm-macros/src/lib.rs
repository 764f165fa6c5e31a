//! The compiler of `mstmm-codegen` as a procedural macro; use it through the crate `mstmm`.

use proc_macro::TokenStream;

/// Expands `mstmm::mstmm_chain!`. The first token is the path of the crate `mstmm` in generated code, which works under any
/// name of the crate; the description follows.
#[proc_macro]
pub fn mstmm_chain_by(input: TokenStream) -> TokenStream {
    let mut tokens = input.into_iter();
    let mstmm: TokenStream = tokens.next().into_iter().collect();
    let description: TokenStream = tokens.collect();
    let expand =
        if cfg!(feature = "wide") { mstmm_codegen::expand_packed } else { mstmm_codegen::expand };
    let expansion = expand(description.into(), &mstmm.into());
    expansion.items.into()
}
