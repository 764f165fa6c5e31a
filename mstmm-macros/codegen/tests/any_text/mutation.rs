//! Texts with some of their tokens changed.

use super::base;
use super::words::{NUMBERS, hostile, one_of};
use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::{Index, select};

/// Changes of one text at most.
const MOST: usize = 5;

/// A change at a place, which counts all tokens and groups.
#[derive(Clone, Debug)]
enum Mutation {
    LeaveOut(Index),
    Repeat(Index, usize),
    /// What stands here and there, the other way round.
    Swap(Index, Index),
    /// Something else in its place.
    Replace(Index, String),
    /// Another number in place of one.
    Number(Index, String),
    /// Something more in front of it.
    Insert(Index, String),
    /// What stands at a place of another text, in its place.
    Graft(Index, String, Index),
    /// Encloses it in nested groups.
    Enclose(Index, Delimiter, usize),
    /// Replaces a group by its contents.
    Open(Index),
}

fn mutation() -> BoxedStrategy<Mutation> {
    use Mutation::*;
    let place = any::<Index>;
    let delimiter =
        select(vec![Delimiter::Parenthesis, Delimiter::Bracket, Delimiter::Brace, Delimiter::None]);
    let depth = prop_oneof![8 => 1..3_usize, 1 => 25..40_usize, 1 => 200..300_usize];
    prop_oneof![
        2 => place().prop_map(LeaveOut),
        1 => (place(), prop_oneof![4 => 2..4_usize, 1 => 200..400_usize])
            .prop_map(|(here, count)| Repeat(here, count)),
        2 => (place(), place()).prop_map(|(here, there)| Swap(here, there)),
        3 => (place(), hostile()).prop_map(|(here, new)| Replace(here, new)),
        6 => (place(), one_of(NUMBERS, " ")).prop_map(|(here, new)| Number(here, new)),
        1 => (place(), hostile()).prop_map(|(here, new)| Insert(here, new)),
        4 => (place(), base::any(), place())
            .prop_map(|(here, other, there)| Graft(here, other, there)),
        1 => (place(), delimiter, depth)
            .prop_map(|(here, delimiter, depth)| Enclose(here, delimiter, depth)),
        1 => place().prop_map(Open),
    ]
    .boxed()
}

/// A text with up to so many changes.
pub fn changed(base: BoxedStrategy<String>) -> BoxedStrategy<String> {
    (base, vec(mutation(), 1..=MOST))
        .prop_map(|(text, mutations)| {
            let mut tokens = tokens_of(&text);
            for mutation in mutations {
                tokens = mutation.apply(tokens);
            }
            spaced(tokens)
        })
        .boxed()
}

impl Mutation {
    fn apply(self, tokens: TokenStream) -> TokenStream {
        let all = places(&tokens);
        let Some(last) = all.len().checked_sub(1) else { return tokens };
        let at = |here: Index| here.index(last + 1);
        let replaced = |place, new: TokenStream| replace(tokens.clone(), &mut { place }, &new);
        match self {
            Mutation::LeaveOut(here) => replaced(at(here), TokenStream::new()),
            Mutation::Repeat(here, count) => {
                let here = at(here);
                replaced(here, vec![all[here].clone(); count].into_iter().collect())
            }
            Mutation::Swap(here, there) => {
                let (first, second) = (at(here).min(at(there)), at(here).max(at(there)));
                // The later one first: the other place stays what it is.
                let once = replaced(second, all[first].clone().into());
                replace(once, &mut { first }, &all[second].clone().into())
            }
            Mutation::Replace(here, new) => replaced(at(here), tokens_of(&new)),
            Mutation::Number(here, new) => {
                let is_number = |&place: &usize| matches!(all[place], TokenTree::Literal(_));
                let numbers: Vec<usize> = (0..all.len()).filter(is_number).collect();
                match numbers.is_empty() {
                    true => tokens,
                    false => replaced(*here.get(&numbers), tokens_of(&new)),
                }
            }
            Mutation::Insert(here, new) => {
                let here = at(here);
                let new = tokens_of(&new).into_iter().chain([all[here].clone()]);
                replaced(here, new.collect())
            }
            Mutation::Graft(here, other, there) => {
                let others = places(&tokens_of(&other));
                replaced(at(here), there.get(&others).clone().into())
            }
            Mutation::Enclose(here, delimiter, depth) => {
                let here = at(here);
                let enclose = |inner, _| TokenStream::from(group(delimiter, inner));
                replaced(here, (0..depth).fold(all[here].clone().into(), enclose))
            }
            Mutation::Open(here) => {
                let here = at(here);
                match &all[here] {
                    TokenTree::Group(group) => replaced(here, group.stream()),
                    _ => tokens,
                }
            }
        }
    }
}

fn group(delimiter: Delimiter, inner: TokenStream) -> TokenTree {
    Group::new(delimiter, inner).into()
}

fn tokens_of(text: &str) -> TokenStream {
    text.parse().unwrap_or_else(|error| panic!("{error}\n{text}"))
}

/// All tokens and groups, each group in front of what is in it.
fn places(tokens: &TokenStream) -> Vec<TokenTree> {
    let mut all = Vec::new();
    for token in tokens.clone() {
        all.push(token.clone());
        if let TokenTree::Group(group) = token {
            all.extend(places(&group.stream()));
        }
    }
    all
}

/// The tokens with others at this place, which is counted down.
fn replace(tokens: TokenStream, place: &mut usize, new: &TokenStream) -> TokenStream {
    let each = |token: TokenTree| {
        let here = *place == 0;
        *place = place.wrapping_sub(1);
        match token {
            _ if here => new.clone(),
            TokenTree::Group(old) => {
                group(old.delimiter(), replace(old.stream(), place, new)).into()
            }
            token => token.into(),
        }
    };
    tokens.into_iter().flat_map(each).collect()
}

/// As text, with a word for brackets that are none.
fn spaced(tokens: TokenStream) -> String {
    named(tokens).to_string()
}

fn named(tokens: TokenStream) -> TokenStream {
    let each = |token: TokenTree| match token {
        TokenTree::Group(old) if old.delimiter() == Delimiter::None => {
            let inner = group(Delimiter::Parenthesis, named(old.stream()));
            tokens_of("invisible").into_iter().chain([inner]).collect()
        }
        TokenTree::Group(old) => group(old.delimiter(), named(old.stream())).into(),
        token => TokenStream::from(token),
    };
    tokens.into_iter().flat_map(each).collect()
}
