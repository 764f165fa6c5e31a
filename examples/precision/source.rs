//! Chains in a file, and the library made from the file. The code of the comparison follows the chain on
//! the same line, so that all line numbers are those of the user's file.

use std::ops::Range;

use mstmm_codegen::model::Chain;
use proc_macro2::{TokenStream, TokenTree};
use syn::spanned::Spanned;
use syn::visit::Visit;

use crate::glue;

/// A file with the chosen chain.
pub struct Source {
    /// The library.
    pub code: String,
    /// None if the file has an error and no chain can be chosen: the compiler reports the error.
    pub chain: Option<Chain>,
}

/// Reads a file that contains only chains.
pub fn chains(text: &str, name: Option<&str>) -> Result<Source, String> {
    let text = &with_all_results(text);
    let called = format!("mstmm::mstmm_chain! {{ {text}\n}}");
    let Ok(description) = text.parse() else { return Ok(Source { code: called, chain: None }) };
    Ok(match choose(vec![Call { description, end: text.len() }], name)? {
        None => Source { code: called, chain: None },
        Some((chain, _)) => {
            let code = format!("{called} {}\n{}", glue::code(&chain), glue::ANCHOR);
            Source { code, chain: Some(chain) }
        }
    })
}

/// Reads a Rust file.
pub fn rust(text: &str, name: Option<&str>) -> Result<Source, String> {
    let text = &with_all_results(text);
    let unread = || Source { code: text.to_owned(), chain: None };
    let tokens = text.parse::<TokenStream>().ok();
    let file = tokens.and_then(|tokens| syn::parse2::<syn::File>(tokens).ok());
    let Some(file) = file else { return Ok(unread()) };
    let mut calls = Calls(Vec::new());
    calls.visit_file(&file);
    Ok(match choose(calls.0, name)? {
        None => unread(),
        Some((chain, end)) => {
            // The semicolon after a call in parentheses is part of the call.
            let rest = &text[end..];
            let blank = rest.len() - rest.trim_start().len();
            let end = if rest.trim_start().starts_with(';') { end + blank + 1 } else { end };
            let code = format!("{} {} {}", &text[..end], glue::code(&chain), &text[end..]);
            Source { code: code + "\n" + glue::ANCHOR, chain: Some(chain) }
        }
    })
}

/// Returns the text with blanks in place of all settings `results`, since all results are compared.
fn with_all_results(text: &str) -> String {
    let mut settings = Vec::new();
    if let Ok(tokens) = text.parse() {
        find_results(tokens, false, &mut settings);
    }
    let mut text = text.to_owned();
    // From the end, so that earlier positions stay valid.
    for setting in settings.into_iter().rev() {
        let blanks = text[setting.clone()].replace(|c: char| c != '\n', " ");
        text.replace_range(setting, &blanks);
    }
    text
}

/// Returns the byte ranges of `results = …;` among the items of chains.
fn find_results(tokens: TokenStream, of_chain: bool, found: &mut Vec<Range<usize>>) {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    let is = |at: usize, text: &str| tokens.get(at).is_some_and(|token| token.to_string() == text);
    for (at, token) in tokens.iter().enumerate() {
        if let TokenTree::Group(group) = token {
            let of_chain = at >= 2 && is(at - 2, "chain");
            find_results(group.stream(), of_chain, found);
        }
        if of_chain
            && is(at, "results")
            && is(at + 1, "=")
            && let Some(end) = tokens[at..].iter().find(|token| token.to_string() == ";")
        {
            found.push(token.span().byte_range().start..end.span().byte_range().end);
        }
    }
}

/// A call of the macro.
struct Call {
    description: TokenStream,
    /// The byte offset of its end in the text.
    end: usize,
}

/// All calls in a file except those inside other macros.
struct Calls(Vec<Call>);

impl Visit<'_> for Calls {
    fn visit_macro(&mut self, call: &syn::Macro) {
        if call.path.segments.last().is_some_and(|name| name.ident == "mstmm_chain") {
            let end = call.delimiter.span().close().span().byte_range().end;
            self.0.push(Call { description: call.tokens.clone(), end });
        }
    }
}

/// Returns the chain of this name, or the only chain, and the end of its call; none if a call has
/// errors.
fn choose(calls: Vec<Call>, name: Option<&str>) -> Result<Option<(Chain, usize)>, String> {
    if calls.is_empty() {
        return Err("there is no chain in it; calls inside other macros are not found".to_owned());
    }
    let mut chains = Vec::new();
    for Call { description, end } in calls {
        let Ok(read) = mstmm_codegen::read(description) else { return Ok(None) };
        chains.extend(read.into_iter().map(|(chain, _)| (chain, end)));
    }
    let names: Vec<String> = chains.iter().map(|(chain, _)| chain.name.to_string()).collect();
    let mut fitting = chains
        .into_iter()
        .filter(|(chain, _)| name.is_none_or(|name| chain.name == name))
        .collect::<Vec<_>>();
    match (fitting.pop(), fitting.is_empty(), name) {
        (Some(chain), true, _) => Ok(Some(chain)),
        (_, _, None) => Err(format!("choose a chain with `--chain`: {}", names.join(", "))),
        (None, _, Some(name)) => {
            Err(format!("there is no chain `{name}` in it; it has {}", names.join(", ")))
        }
        (_, _, Some(name)) => Err(format!("there are several chains `{name}` in it")),
    }
}
