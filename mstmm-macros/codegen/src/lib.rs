//! The compiler behind `mstmm_chain!`: from the text of a chain to the code that computes it.
//!
//! ```text
//! tokens --syntax--> ChainSyntax --model--> Chain --equations--> Function --passes--> Procedure --emit--> tokens
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

/// The result of checking a text without expanding it.
#[derive(Debug)]
pub struct Checked {
    /// The chains; none if the text has errors.
    pub chains: Vec<CheckedChain>,
    /// All errors of the text in its order, each on the token to edit.
    pub errors: Option<syn::Error>,
    /// All warnings of the text in its order, each on its token.
    pub warnings: Vec<diag::Warning>,
}

/// A chain without errors.
#[derive(Debug)]
pub struct CheckedChain {
    /// The chain.
    pub chain: model::Chain,
    /// Its visibility, constants and names for the user's crate.
    pub passthrough: syntax::Passthrough,
    /// The results of its numerical evaluation.
    pub findings: examine::Findings,
}

/// Expands the text inside `mstmm_chain!`, phase by phase.
///
/// `mstmm` is the path of the crate `mstmm` in generated code.
pub fn expand(description: TokenStream, mstmm: &TokenStream) -> Expansion {
    expand_with(description, mstmm, false)
}

/// Expands the text as [`expand`] does, and adds to each function the form with limbs of one shape side by side, for scalar
/// types that have packs. It costs up to the same time again.
pub fn expand_packed(description: TokenStream, mstmm: &TokenStream) -> Expansion {
    expand_with(description, mstmm, true)
}

fn expand_with(description: TokenStream, mstmm: &TokenStream, is_packed: bool) -> Expansion {
    let (definitions, Checked { chains, errors, warnings }) = check_parsed(description);
    // The user's errors end here: the phases below cannot fail.
    let expand_chain = |CheckedChain { chain, passthrough, findings }: &CheckedChain| {
        let layout = model::Layout::of(chain);
        let compile = if is_packed { compile::compile_packed } else { compile::compile };
        let compiled = compile(chain, findings, &layout);
        emit::expand(chain, passthrough, &layout, &compiled, findings, mstmm)
    };
    let mut items: TokenStream = match &errors {
        None => chains.iter().map(expand_chain).collect(),
        Some(errors) => emit::error_types(&definitions, errors),
    };
    items.extend(warnings.iter().map(emit::warning));
    Expansion { items, errors, warnings }
}

/// Checks the text inside `mstmm_chain!`: finds the errors and warnings of [`expand`].
pub fn check(description: TokenStream) -> Checked {
    check_parsed(description).1
}

/// Parses, checks and numerically evaluates all chains of one macro call.
fn check_parsed(description: TokenStream) -> (Vec<syntax::ChainSyntax>, Checked) {
    let mut diagnostics = Diagnostics::default();
    let definitions = syntax::parse(description, &mut diagnostics);
    let understood = understand(&definitions, &mut diagnostics);
    let mut chains = Vec::new();
    if diagnostics.is_empty() {
        chains.extend(understood.into_iter().map(|(chain, passthrough)| {
            let findings = examine::examine(&chain, &mut diagnostics);
            CheckedChain { chain, passthrough, findings }
        }));
    }
    let warnings = diagnostics.warnings();
    let errors = diagnostics.finish().err();
    if errors.is_some() {
        chains.clear();
    }
    (definitions, Checked { chains, errors, warnings })
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
    let Checked { chains, errors, .. } = check(description);
    match errors {
        Some(errors) => Err(errors),
        None => Ok(chains.into_iter().map(|of| (of.chain, of.findings)).collect()),
    }
}

/// Lowers all chains; chains with errors are missing, and so are the chains after them.
fn understand(
    definitions: &[syntax::ChainSyntax],
    diagnostics: &mut Diagnostics,
) -> Vec<Understood> {
    definitions.iter().filter_map(|def| model::lower(def, diagnostics)).collect()
}
