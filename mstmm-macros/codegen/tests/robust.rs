//! Tests that no text makes the compiler panic: valid chains with one number replaced by an extreme one, or with one token
//! omitted, give code that parses or errors.

use mstmm_reference::{Ends, HingeChoice, Random, random_chain};
use proc_macro2::{TokenStream, TokenTree};
use quote::quote;

const CHAINS: u64 = 120;

const EXTREMES: [&str; 10] =
    ["0", "1e308", "1e-308", "1e-320", "-1e308", "1e200", "1e-200", "PI", "K", "(0 * K)"];

/// Replaces the token with index `place`, counted through all groups.
fn replace(
    tokens: TokenStream,
    place: &mut usize,
    with: &mut dyn FnMut(TokenTree) -> TokenStream,
) -> TokenStream {
    tokens
        .into_iter()
        .flat_map(|token| match token {
            TokenTree::Group(group) => {
                let inner = replace(group.stream(), place, with);
                let mut new = proc_macro2::Group::new(group.delimiter(), inner);
                new.set_span(group.span());
                TokenStream::from(TokenTree::Group(new))
            }
            token => {
                let here = *place == 0;
                *place = place.wrapping_sub(1);
                if here { with(token) } else { token.into() }
            }
        })
        .collect()
}

fn tokens_of(tokens: TokenStream) -> Vec<TokenTree> {
    let mut all = Vec::new();
    for token in tokens {
        match token {
            TokenTree::Group(group) => all.extend(tokens_of(group.stream())),
            token => all.push(token),
        }
    }
    all
}

/// Returns a valid chain with one token changed.
fn mutated(seed: u64) -> TokenStream {
    let mut random = Random::new(seed);
    let ends = *random.choose(&[Ends::HeldFree, Ends::FreeFree, Ends::FreeHeld]);
    let bodies = 1 + random.below(3);
    let kinds = [HingeChoice::Pin, HingeChoice::Ball, HingeChoice::Weld];
    let chain = random_chain(&mut random, "Random", bodies, ends, &kinds);
    let text = chain.to_macro_text(*random.choose(&[None, Some("transfer")]));
    let tokens: TokenStream = text.parse().expect("tokens");
    let all = tokens_of(tokens.clone());
    let numbers: Vec<usize> =
        (0..all.len()).filter(|&k| matches!(all[k], TokenTree::Literal(_))).collect();
    if random.chance(0.8) {
        let extreme = *random.choose(&EXTREMES);
        let mut place = *random.choose(&numbers);
        replace(tokens, &mut place, &mut |_| extreme.parse().expect("a number"))
    } else {
        let mut place = random.below(all.len());
        replace(tokens, &mut place, &mut |_| TokenStream::new())
    }
}

#[test]
fn every_text_gives_code_or_errors() {
    let (mut code, mut errors) = (0, 0);
    for seed in 0..CHAINS {
        let tokens = mutated(seed);
        let expansion = mstmm_codegen::expand(tokens.clone(), &quote!(::mstmm));
        let parsed = syn::parse2::<syn::File>(expansion.items);
        assert!(parsed.is_ok(), "seed {seed}: the code of\n{tokens}\ndoes not parse");
        match expansion.errors {
            None => code += 1,
            Some(_) => errors += 1,
        }
    }
    assert!(code > CHAINS / 10 && errors > CHAINS / 10, "{code} in code, {errors} in errors");
}
