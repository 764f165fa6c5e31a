//! `cargo mstmm show`

use clap::Args;
use mstmm_codegen::CheckedChain;
use mstmm_codegen::compile::{chain_text, compile};
use mstmm_codegen::emit::drawing_file;
use mstmm_codegen::model::Layout;
use mstmm_codegen::program::Cost;
use proc_macro2::{Ident, Span, TokenStream};
use std::path::PathBuf;

use super::{Failure, write};
use crate::source::Source;

/// Show what the functions of chains compute, in the order of the equations
#[derive(Args, Debug)]
pub struct Show {
    /// A file with chains; `-` is standard input
    #[arg(value_name = "FILE")]
    file: PathBuf,
    /// Only this function, such as `accelerations`
    function: Option<String>,
    #[command(flatten)]
    form: Form,
    /// Write to this file instead of standard output
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

/// What is shown.
#[derive(Args, Clone, Copy, Debug, Default)]
#[group(multiple = false)]
pub struct Form {
    /// A table of the operations of each function
    #[arg(long)]
    pub counts: bool,
    /// The picture of the chain at its start, as SVG
    #[arg(long, conflicts_with = "function")]
    pub picture: bool,
    /// The Rust code that `mstmm_chain!` generates
    #[arg(long, alias = "tokens", conflicts_with = "function")]
    pub expand: bool,
}

/// Runs the command.
///
/// # Errors
///
/// If the file cannot be read or has errors, or a chain has no such function or picture.
pub fn run(arguments: &Show) -> Result<(), Failure> {
    let source = Source::read(&arguments.file)?;
    let chains = source.chains()?;
    let function = arguments.function.as_deref();
    let text = match arguments.form {
        Form { counts: true, .. } => counts(&chains, function)?,
        Form { picture: true, .. } => picture(&chains)?,
        Form { expand: true, .. } => expanded(&source)?,
        _ => functions(&chains, function)?,
    };
    write(&text, arguments.output.as_deref())
}

/// Returns the text of one function or of all functions of all chains.
///
/// # Errors
///
/// If a chain has no function of this name.
pub fn functions(chains: &[CheckedChain], function: Option<&str>) -> Result<String, Failure> {
    let texts = chains.iter().map(|CheckedChain { chain, findings, .. }| {
        chain_text(chain, findings, function).map_err(|known| unknown(&chain.name, &known))
    });
    let texts: Vec<String> = texts.collect::<Result<_, _>>()?;
    Ok(texts.join("\n"))
}

fn unknown(chain: &Ident, known: &[&str]) -> Failure {
    Failure(format!("`{chain}` has the functions {}", known.join(", ")))
}

/// Returns a table of the operations of one function or of all functions for each chain.
///
/// # Errors
///
/// If a chain has no function of this name.
pub fn counts(chains: &[CheckedChain], function: Option<&str>) -> Result<String, Failure> {
    let tables = chains.iter().map(|CheckedChain { chain, findings, .. }| {
        let compiled = compile(chain, findings, &Layout::of(chain));
        let functions = std::iter::once(&compiled.setup).chain(&compiled.functions);
        let functions = functions.map(|of| (of.name().to_owned(), of.procedure.cost()));
        let of_bodies = compiled.jacobians.iter().map(|(body, procedure)| {
            (format!("{}_jacobian", chain.bodies[*body].name), procedure.cost())
        });
        let all: Vec<(String, Cost)> = functions.chain(of_bodies).collect();
        let wanted = all.iter().filter(|(of, _)| function.is_none_or(|name| name == of));
        let rows: Vec<String> = wanted
            .map(|(of, cost)| {
                let Cost { mul, add, recip, sqrt, trig } = cost;
                let total = cost.arithmetic();
                format!("{mul:>6} {add:>6} {recip:>6} {sqrt:>5} {trig:>7} {total:>7}   {of}\n")
            })
            .collect();
        if rows.is_empty() {
            let known: Vec<&str> = all.iter().map(|(of, _)| &**of).collect();
            return Err(unknown(&chain.name, &known));
        }
        let head = "   mul    add  recip  sqrt  sincos   total   function";
        Ok(format!("{}\n{head}\n{}", chain.name, rows.concat()))
    });
    let tables: Vec<String> = tables.collect::<Result<_, _>>()?;
    Ok(tables.join("\n"))
}

/// Returns the picture of a chain at its start.
///
/// # Errors
///
/// If there are several chains, or Rust constants have an unknown value.
pub fn picture(chains: &[CheckedChain]) -> Result<String, Failure> {
    let [CheckedChain { chain, findings, .. }] = chains else {
        let count = chains.len();
        return Err(Failure(format!("a picture shows one chain, and the file has {count}")));
    };
    let name = &chain.name;
    let unknown = || Failure(format!("`{name}` has Rust constants, whose values are unknown here"));
    findings.start.as_ref().map(drawing_file).ok_or_else(unknown)
}

/// Returns the code that the macro generates.
///
/// # Errors
///
/// If the text has errors.
pub fn expanded(source: &Source) -> Result<String, Failure> {
    let tokens = source.tokens().map_err(|message| Failure(message.message))?;
    let mstmm = Ident::new("mstmm", Span::call_site());
    let mstmm: TokenStream = [proc_macro2::TokenTree::from(mstmm)].into_iter().collect();
    let items = mstmm_codegen::expand(tokens, &mstmm).items;
    let file = syn::parse2(items).map_err(|error| Failure(error.to_string()))?;
    Ok(prettyplease::unparse(&file))
}
