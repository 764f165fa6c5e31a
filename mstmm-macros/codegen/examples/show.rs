//! Prints the functions of the chains in a file in the order of their equations:
//! `cargo run -p mstmm-codegen --example show -- FILE.chain [FUNCTION]`.

use mstmm_codegen::compile::chain_text;
use proc_macro2::{TokenStream, TokenTree};
use std::process::ExitCode;

/// Returns the text of one function or of all functions of all chains in a file, or the errors.
pub fn show(file: &str, function: Option<&str>) -> Result<String, String> {
    let text = std::fs::read_to_string(file).map_err(|error| format!("{file}: {error}"))?;
    let tokens = text.parse().map_err(|error| format!("{file}: {error}"))?;
    let tokens = inside_macro(tokens);
    let chains = mstmm_codegen::read_and_examine(tokens).map_err(|errors| {
        let lines = errors.into_iter().map(|error| {
            let start = error.span().start();
            format!("{file}:{}:{}: {error}", start.line, start.column + 1)
        });
        lines.collect::<Vec<_>>().join("\n")
    })?;
    let texts = chains.iter().map(|(chain, findings)| {
        chain_text(chain, findings, function).map_err(|functions| {
            format!("`{}` has the functions {}", chain.name, functions.join(", "))
        })
    });
    let texts: Vec<String> = texts.collect::<Result<_, _>>()?;
    Ok(texts.join("\n"))
}

/// Returns the content of `mstmm_chain! { … }`, or the tokens themselves.
fn inside_macro(tokens: TokenStream) -> TokenStream {
    let mut rest = tokens.clone().into_iter();
    match [rest.next(), rest.next(), rest.next()] {
        [
            Some(TokenTree::Ident(name)),
            Some(TokenTree::Punct(_)),
            Some(TokenTree::Group(group)),
        ] if name == "mstmm_chain" => group.stream(),
        _ => tokens,
    }
}

#[allow(dead_code, reason = "a test includes this file")]
fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let shown = match &arguments[..] {
        [file] => show(file, None),
        [file, function] => show(file, Some(function)),
        _ => Err("usage: show FILE.chain [FUNCTION]".to_owned()),
    };
    match shown {
        Ok(text) => {
            print!("{text}");
            ExitCode::SUCCESS
        }
        Err(message) => {
            eprintln!("{message}");
            ExitCode::FAILURE
        }
    }
}
