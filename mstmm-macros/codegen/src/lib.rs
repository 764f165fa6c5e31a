//! The compiler behind `mstmm_chain!`: from the text of a chain to the code that computes it.
//!
//! ```text
//! tokens --syntax--> ChainDef --model--> Chain --equations--> Expr graph --passes--> Program --emit--> tokens
//! ```
//!
//! | module | holds | may use |
//! |---|---|---|
//! | [`syntax`] | what was written, with spans | `diag` |
//! | [`model`] | names resolved, units and constants evaluated, every rule on models | `syntax` (only `lower`), `diag` |
//! | [`math`] | scalars, vectors, spatial blocks | nothing of ours |
//! | [`equations`] | the paper, generic over [`math::Scalar`] | `math`, `model` |
//! | [`expr`] | formulas as a graph without repetitions | `math` |
//! | [`program`] | straight-line programs and their costs | nothing of ours |
//! | [`passes`] | one optimisation a file | `expr`, `program` |
//! | [`compile`](mod@compile) | the order of the phases | all |
//! | [`emit`] | the only `quote!` | `model`, `program`, `compile` |

#![deny(missing_docs)]

pub mod compile;
pub mod diag;
pub mod emit;
pub mod equations;
pub mod expr;
pub mod math;
pub mod model;
pub mod passes;
pub mod program;
mod symbols;
pub mod syntax;

use proc_macro2::TokenStream;

/// Compiles the text inside `mstmm_chain!`.
///
/// # Errors
///
/// All mistakes of the text, each on the token to edit.
pub fn compile(tokens: TokenStream) -> syn::Result<TokenStream> {
    let chains = model::read(tokens)?;
    Ok(chains.iter().map(|(chain, surface)| expand(chain, surface)).collect())
}

/// From here on no mistake of the user is possible.
fn expand(chain: &model::Chain, surface: &syntax::Surface) -> TokenStream {
    let layout = model::Layout::of(chain);
    let programs = compile::programs(chain, &layout);
    emit::expand(chain, surface, &layout, &programs)
}
