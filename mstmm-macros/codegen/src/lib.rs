//! The compiler behind `mstmm_chain!`: from the text of a chain to the code that computes it.
//!
//! ```text
//! tokens --syntax--> ChainDef --model--> Chain --equations--> Function --passes--> Procedure --emit--> tokens
//! ```
//!
//! | module | holds | may use |
//! |---|---|---|
//! | [`diag`] | errors and warnings, collected | nothing of ours |
//! | [`ids`] | types of indices and the lists that they index | nothing of ours |
//! | [`syntax`] | what was written, with spans | `diag` |
//! | [`model`] | names resolved, units and constants evaluated, every rule on models | `diag`, `ids`, `math`; `syntax` where it is lowered and checked |
//! | [`math`] | scalars, vectors, spatial blocks | nothing of ours |
//! | [`equations`] | the paper, generic over [`math::Scalar`] | `ids`, `math`, `model` |
//! | [`examine`] | a chain tried out in numbers | `diag`, `equations`, `math`, `model` |
//! | [`expr`] | formulas as a graph without repetitions | `math` |
//! | [`program`] | programs and procedures, their costs and their text | `diag`, `ids` |
//! | [`function`] | functions as values, and repeated parts as loops | `diag`, `equations`, `expr`, `ids`, `program` |
//! | [`passes`] | one optimisation a file | `diag`, `expr`, `function`, `ids`, `math`, `program` |
//! | [`compile`](mod@compile) | from a model to its procedures: the table of functions and the list of passes | `diag`, `equations`, `examine`, `expr`, `function`, `ids`, `math`, `model`, `passes`, `program` |
//! | [`emit`] | the only `quote!` of items | `compile`, `diag`, `examine`, `ids`, `model`, `program`, `syntax` |

#![deny(missing_docs)]

#[macro_use]
pub mod diag;

pub mod compile;
pub mod emit;
pub mod equations;
pub mod examine;
pub mod expr;
pub mod function;
pub mod ids;
pub mod math;
pub mod model;
pub mod passes;
pub mod program;
pub mod syntax;

use diag::Diagnostics;
use proc_macro2::TokenStream;

/// What stands in place of a macro call.
#[derive(Debug)]
pub struct Expansion {
    /// The types of all chains, with all mistakes as errors where there are any.
    pub items: TokenStream,
    /// All errors of the text in its order, each on the token to edit; the items report them.
    pub mistakes: Option<syn::Error>,
    /// All warnings of the text in its order, each on its token; the items give them.
    pub warnings: Vec<diag::Warning>,
}

/// Expands the text inside `mstmm_chain!`: the phases in their order. Generated code calls the crate
/// `mstmm` by this path.
pub fn expand(description: TokenStream, mstmm: &TokenStream) -> Expansion {
    let mut diagnostics = Diagnostics::default();
    let written = syntax::parse(description, &mut diagnostics);
    let chains = understand(&written, &mut diagnostics);
    let mut findings = Vec::new();
    if diagnostics.is_empty() {
        let examine = |(chain, _): &Understood| examine::examine(chain, &mut diagnostics);
        findings.extend(chains.iter().map(examine));
    }
    let warnings = diagnostics.warnings();
    let mistakes = diagnostics.finish().err();
    // From here on no mistake of the user is possible.
    let right = |((chain, surface), findings): (&Understood, &examine::Findings)| {
        let layout = model::Layout::of(chain);
        let compiled = compile::compile(chain, findings, &layout);
        emit::expand(chain, surface, &layout, &compiled, findings, mstmm)
    };
    let mut items: TokenStream = match &mistakes {
        None => chains.iter().zip(&findings).map(right).collect(),
        Some(mistakes) => emit::error_types(&written, mistakes),
    };
    items.extend(warnings.iter().map(emit::warning));
    Expansion { items, mistakes, warnings }
}

/// A chain and how it is to look in the user's crate.
type Understood = (model::Chain, syntax::Surface);

/// Reads all chains of one macro call: what can be said of a text before anything is computed.
///
/// # Errors
///
/// All mistakes of the text, each on the token to edit.
pub fn read(description: TokenStream) -> syn::Result<Vec<(model::Chain, syntax::Surface)>> {
    let mut diagnostics = Diagnostics::default();
    let written = syntax::parse(description, &mut diagnostics);
    let chains = understand(&written, &mut diagnostics);
    diagnostics.finish().map(|()| chains)
}

/// Reads all chains of one macro call and tries them out in numbers, as [`expand`] does.
///
/// # Errors
///
/// As [`read`]; mistakes that the trial finds as well.
pub fn read_and_examine(
    description: TokenStream,
) -> syn::Result<Vec<(model::Chain, examine::Findings)>> {
    let chains = read(description)?;
    let mut diagnostics = Diagnostics::default();
    let examined = chains.into_iter().map(|(chain, _)| {
        let findings = examine::examine(&chain, &mut diagnostics);
        (chain, findings)
    });
    let examined = examined.collect();
    diagnostics.finish().map(|()| examined)
}

/// All chains; those with mistakes and those after them are missing.
fn understand(written: &[syntax::ChainDef], diagnostics: &mut Diagnostics) -> Vec<Understood> {
    written.iter().filter_map(|def| model::lower(def, diagnostics)).collect()
}
