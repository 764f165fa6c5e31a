//! The macro [`mstmm_chain!`]; use it through the crate `mstmm`.

use proc_macro::TokenStream;

/// Turns a written chain of bodies and hinges into a type that computes its dynamics.
#[proc_macro]
pub fn mstmm_chain(input: TokenStream) -> TokenStream {
    match mstmm_codegen::compile(input.into()) {
        Ok(items) => items.into(),
        Err(errors) => errors.into_compile_error().into(),
    }
}
