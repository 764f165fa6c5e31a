//! The compiler behind `mstmm_chain!`: from the text of a chain to the code that computes it.
//!
//! ```text
//! tokens --syntax--> ChainDef --model--> Chain --equations--> Function --passes--> Procedure --emit--> tokens
//! ```
//!
//! | module | holds | may use |
//! |---|---|---|
//! | [`diag`] | collects errors and warnings | nothing of ours |
//! | [`ids`] | typed indices and the lists that they index | nothing of ours |
//! | [`syntax`] | the syntax tree, with spans | `diag` |
//! | [`model`] | the chain with resolved names and evaluated units and constants; the rules on models | `diag`, `ids`, `math`; `syntax` where it is lowered and checked |
//! | [`math`] | scalars, vectors, spatial blocks | nothing of ours |
//! | [`equations`] | the paper's equations, generic over [`math::Scalar`] | `ids`, `math`, `model` |
//! | [`examine`] | evaluates a chain numerically | `diag`, `equations`, `ids`, `math`, `model` |
//! | [`expr`] | formulas as a hash-consed graph | `ids`, `math` |
//! | [`program`] | programs and procedures, their operation counts and their text | `diag`, `ids` |
//! | [`function`] | functions over the graph, with repeated parts as loops | `diag`, `equations`, `expr`, `ids`, `program` |
//! | [`passes`] | one optimisation per file | `diag`, `expr`, `function`, `ids`, `math`, `program` |
//! | [`compile`](mod@compile) | compiles a model to procedures: the table of functions and the list of passes | `diag`, `equations`, `examine`, `expr`, `function`, `ids`, `math`, `model`, `passes`, `program` |
//! | [`emit`] | prints Rust items; the only `quote!` of items | `compile`, `diag`, `examine`, `ids`, `model`, `program`, `syntax` |

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

/// The result of expanding a macro call.
#[derive(Debug)]
pub struct Expansion {
    /// The types of all chains; if the text has errors, they are compile errors in these items.
    pub items: TokenStream,
    /// All errors of the text in its order, each on the token to edit; the items report them too.
    pub errors: Option<syn::Error>,
    /// All warnings of the text in its order, each on its token; the items report them too.
    pub warnings: Vec<diag::Warning>,
}

/// Expands the text inside `mstmm_chain!`, phase by phase.
///
/// `mstmm` is the path of the crate `mstmm` in generated code.
pub fn expand(description: TokenStream, mstmm: &TokenStream) -> Expansion {
    let mut diagnostics = Diagnostics::default();
    let definitions = syntax::parse(description, &mut diagnostics);
    let chains = understand(&definitions, &mut diagnostics);
    let mut findings = Vec::new();
    if diagnostics.is_empty() {
        let examine = |(chain, _): &Understood| examine::examine(chain, &mut diagnostics);
        findings.extend(chains.iter().map(examine));
    }
    let warnings = diagnostics.warnings();
    let errors = diagnostics.finish().err();
    // The user's errors end here: the phases below cannot fail.
    let expand_chain = |((chain, passthrough), findings): (&Understood, &examine::Findings)| {
        let layout = model::Layout::of(chain);
        let compiled = compile::compile(chain, findings, &layout);
        emit::expand(chain, passthrough, &layout, &compiled, findings, mstmm)
    };
    let mut items: TokenStream = match &errors {
        None => chains.iter().zip(&findings).map(expand_chain).collect(),
        Some(errors) => emit::error_types(&definitions, errors),
    };
    items.extend(warnings.iter().map(emit::warning));
    Expansion { items, errors, warnings }
}

/// A chain, and its visibility, constants and names for the user's crate.
type Understood = (model::Chain, syntax::Passthrough);

/// Parses and checks all chains of one macro call, without evaluating them numerically.
///
/// # Errors
///
/// All errors of the text, each on the token to edit.
pub fn read(description: TokenStream) -> syn::Result<Vec<(model::Chain, syntax::Passthrough)>> {
    let mut diagnostics = Diagnostics::default();
    let definitions = syntax::parse(description, &mut diagnostics);
    let chains = understand(&definitions, &mut diagnostics);
    diagnostics.finish().map(|()| chains)
}

/// Parses, checks and numerically evaluates all chains of one macro call, as [`expand`] does.
///
/// # Errors
///
/// The errors of [`read`], or those that the numerical evaluation finds.
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

/// Lowers all chains; chains with errors are missing, and so are the chains after them.
fn understand(
    definitions: &[syntax::ChainSyntax],
    diagnostics: &mut Diagnostics,
) -> Vec<Understood> {
    definitions.iter().filter_map(|def| model::lower(def, diagnostics)).collect()
}
