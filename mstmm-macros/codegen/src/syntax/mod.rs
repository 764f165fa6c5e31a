//! Parses a description into a syntax tree with spans. Only the grammar is checked here, not the meaning.
//!
//! In this grammar `[…]` is optional, `…*` may be repeated any number of times or omitted, and text in quotes is written
//! literally. The reference of the language has the same grammar; a test compares the two. The parser reads more than the
//! grammar has, so that one build reports all errors.
//!
#![doc = include_str!("grammar.md")]

mod attribute;
mod chain;
mod content;
mod cursor;
mod field;
mod lookahead;
mod number;
mod other_programs;
mod part;
mod passthrough;
mod path;
mod recover;
mod route;
mod route_item;
mod route_tree;
mod separators;
mod shape;
mod tree;
mod unit;
mod value;

pub use lookahead::SETTINGS;
pub use number::{FORMS, FUNCTIONS};
pub use other_programs::field as missing_field;
pub use passthrough::{KeywordGroup, KeywordUses, PartInstance, Passthrough, References};
pub use route_tree::*;
pub use shape::SHAPES;
pub use tree::*;

use proc_macro2::{Ident, Span, TokenStream, TokenTree};
use std::collections::HashMap;
use syn::buffer::TokenBuffer;

use crate::diag::Diagnostics;

/// Parses all chains of one macro call. Returns everything readable, even if there are errors.
pub fn parse(tokens: TokenStream, diagnostics: &mut Diagnostics) -> Vec<ChainSyntax> {
    if let Some(at) = too_deep(&tokens) {
        diagnostics.error(at, format!("more than {DEEPEST} nested groups"));
        return Vec::new();
    }
    let buffer = TokenBuffer::new2(tokens);
    let mut input = cursor::Cursor::new(buffer.begin());
    let mut chains = Vec::new();
    if input.is_empty() {
        diagnostics.error(input.next_span(), "expected `chain Name { … }`, found nothing");
    }
    while !input.is_empty() {
        let chain = chain::chain(&mut input, diagnostics);
        // Without a further chain the rest is part of what was not readable.
        if chain.is_none() && !has_chain(input) {
            break;
        }
        chains.extend(chain);
    }
    check_unique_types(&chains, diagnostics);
    chains
}

/// Returns whether the keyword of a chain follows, outside of all brackets.
fn has_chain(mut input: cursor::Cursor) -> bool {
    while !input.is_empty() {
        if input.word("chain").is_some() {
            return true;
        }
        input.any();
    }
    false
}

/// The maximum depth of nested groups in the input: `TokenBuffer` is filled by recursion, which
/// could overflow the stack. The cursor has a smaller limit, with better messages.
const DEEPEST: usize = 200;

/// Returns a group that is nested too deeply.
fn too_deep(tokens: &TokenStream) -> Option<Span> {
    let mut open = vec![tokens.clone().into_iter()];
    while let Some(inner) = open.last_mut() {
        match inner.next() {
            None => _ = open.pop(),
            Some(TokenTree::Group(group)) if open.len() > DEEPEST => {
                return Some(group.span_open());
            }
            Some(TokenTree::Group(group)) => open.push(group.stream().into_iter()),
            Some(_) => {}
        }
    }
    None
}

/// The suffixes of the types that a chain generates.
const TYPES: &[&str] = &["", "State", "Inputs", "Parameters", "Workspace"];

/// The suffix of the types of kinematics.
const KINEMATICS: &str = "Kinematics";

/// The words of the setting `answers` that may generate further types, and the suffixes of these types. Derivatives use
/// variations only for chains that are not short.
const ANSWER_TYPES: &[(&str, &[&str])] = &[
    ("kinematics", &[KINEMATICS]),
    ("jacobian", &[KINEMATICS]),
    ("basic", &[KINEMATICS]),
    ("push", &["Variation"]),
    ("pull", &["Variation"]),
    ("derivatives", &["InverseDynamicsDerivatives", "Variation"]),
    ("linearize", &["Linearization", "Variation"]),
];

/// Reports generated types with the same name: the types of all chains of one call are in one
/// module.
fn check_unique_types(chains: &[ChainSyntax], diagnostics: &mut Diagnostics) {
    let mut taken: HashMap<String, Ident> = HashMap::new();
    for chain in chains {
        let of_answers = answer_types(chain);
        let suffixes = TYPES.iter().chain(&of_answers);
        let types = suffixes.map(|suffix| format!("{}{suffix}", chain.name));
        let has_kinematics = of_answers.contains(&KINEMATICS);
        let types: Vec<String> = types.chain(result_types(chain, has_kinematics)).collect();
        let clash = types.iter().find_map(|name| Some((name, taken.get(name)?)));
        if let Some((name, other)) = clash {
            let message = match *other == chain.name {
                true => format!("two chains have the name `{name}`"),
                false => format!("chains `{other}` and `{}` both have a type `{name}`", chain.name),
            };
            diagnostics.error(chain.name.span(), message);
            continue;
        }
        taken.extend(types.into_iter().map(|name| (name, chain.name.clone())));
    }
}

/// Returns the suffixes of the types that the words of a chain's setting `answers` may generate.
pub fn answer_types(chain: &ChainSyntax) -> Vec<&'static str> {
    let settings = chain.settings.iter().filter(|field| field.name == "answers");
    let entries = settings.flat_map(|field| match &field.value {
        Some(ValueSyntax::Number(entry)) => std::slice::from_ref(entry),
        Some(ValueSyntax::Vector(list)) => &list.entries,
        _ => &[],
    });
    let words = entries.filter_map(|entry| match &entry.kind {
        ExprKind::Name(word) => Some(word),
        _ => None,
    });
    let of_word =
        words.flat_map(|word| ANSWER_TYPES.iter().filter(move |(known, _)| word == known));
    of_word.flat_map(|(_, types)| *types).copied().collect()
}

/// Returns the types of results and of kinematics at bodies with named points.
fn result_types(chain: &ChainSyntax, has_kinematics: bool) -> Vec<String> {
    let parts = chain.parts.iter().map(|part| (part.name.to_string(), &part.content));
    let contents = [(String::new(), &chain.content)].into_iter().chain(parts);
    let types = contents.flat_map(|(part, content)| {
        let bodies = content.blocks.iter().filter(|block| !block.points.is_empty());
        let names = bodies.flat_map(|block| &block.names);
        let suffixes = ["Result", KINEMATICS].into_iter().take(if has_kinematics { 2 } else { 1 });
        names.flat_map(move |name| {
            let start = format!("{}{part}{name}", chain.name);
            suffixes.clone().map(move |suffix| format!("{start}{suffix}"))
        })
    });
    types.collect()
}

/// Returns the keywords of the tables of the parser.
#[cfg(test)]
pub(crate) fn keywords() -> Vec<&'static str> {
    let blocks = content::BLOCKS.iter().map(|(word, _)| *word);
    let dimensions = chain::DIMENSIONS.iter().map(|(word, _)| *word);
    let lists = [lookahead::ITEMS, SETTINGS, FORMS, FUNCTIONS, SHAPES, route_item::AXES].concat();
    blocks.chain(dimensions).chain(lists).collect()
}
