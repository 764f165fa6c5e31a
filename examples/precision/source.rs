//! Chains in a file, and the file as the library that is compiled: what belongs to the comparison
//! stands behind the chain on its own line, so that every place is where the user has it.

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
    /// None where a mistake leaves nothing to be chosen from: the compiler has the words for it.
    pub chain: Option<Chain>,
}

/// The text of chains alone.
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

/// A whole file of Rust.
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
            // The semicolon of a call in parentheses belongs to it.
            let rest = &text[end..];
            let blank = rest.len() - rest.trim_start().len();
            let end = if rest.trim_start().starts_with(';') { end + blank + 1 } else { end };
            let code = format!("{} {} {}", &text[..end], glue::code(&chain), &text[end..]);
            Source { code: code + "\n" + glue::ANCHOR, chain: Some(chain) }
        }
    })
}

/// The text with blanks in place of all settings `results`: everything is compared.
fn with_all_results(text: &str) -> String {
    let mut settings = Vec::new();
    if let Ok(tokens) = text.parse() {
        find_results(tokens, false, &mut settings);
    }
    let mut text = text.to_owned();
    // From the end, so that places before stay.
    for setting in settings.into_iter().rev() {
        let blanks = text[setting.clone()].replace(|c: char| c != '\n', " ");
        text.replace_range(setting, &blanks);
    }
    text
}

/// Where `results = …;` stands among the items of chains, in bytes.
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
    /// Where it ends in the text, in bytes.
    end: usize,
}

/// All calls in a file but for those inside other macros.
struct Calls(Vec<Call>);

impl Visit<'_> for Calls {
    fn visit_macro(&mut self, call: &syn::Macro) {
        if call.path.segments.last().is_some_and(|name| name.ident == "mstmm_chain") {
            let end = call.delimiter.span().close().span().byte_range().end;
            self.0.push(Call { description: call.tokens.clone(), end });
        }
    }
}

/// The chain of this name, or the only one, and where its call ends; none if a call has mistakes.
fn choose(calls: Vec<Call>, name: Option<&str>) -> Result<Option<(Chain, usize)>, String> {
    if calls.is_empty() {
        return Err("there is no chain in it; a call inside another macro is not seen".to_owned());
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
        (_, _, None) => Err(format!("say which chain with `--chain`: {}", names.join(", "))),
        (None, _, Some(name)) => {
            Err(format!("there is no chain `{name}` in it, but {}", names.join(", ")))
        }
        (_, _, Some(name)) => Err(format!("there are several chains `{name}` in it")),
    }
}
