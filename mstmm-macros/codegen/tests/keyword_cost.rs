//! The links of keywords for editors cost few tokens.

use proc_macro2::{TokenStream, TokenTree};
use quote::quote;

/// Chains with many and with few words for their size.
const CHAINS: &[(&str, &str)] = &[
    ("a single pendulum", include_str!("expand/pendulum.chain")),
    ("two pins", include_str!("expand/two_pins.chain")),
    ("a rope", include_str!("expand/rope.chain")),
    ("four bars", include_str!("expand/four_bar.chain")),
    ("a top", include_str!("expand/top.chain")),
    ("an arm", include_str!("expand/arm.chain")),
    ("HyQ", include_str!("../../../benches/src/models/trees/hyq.chain")),
    ("G1", include_str!("../../../benches/src/models/trees/g1.chain")),
];

fn count(tokens: TokenStream) -> usize {
    let of_tree = |tree| match tree {
        TokenTree::Group(group) => 2 + count(group.stream()),
        _ => 1,
    };
    tokens.into_iter().map(of_tree).sum()
}

/// Returns the description in a file, which may be a call of the macro.
fn description(text: &str) -> TokenStream {
    let tokens: TokenStream = text.parse().expect("tokens");
    let is_call = tokens.to_string().contains("mstmm_chain !");
    match tokens.clone().into_iter().last() {
        Some(TokenTree::Group(group)) if is_call => group.stream(),
        _ => tokens,
    }
}

/// Counts the imports of keywords and the types after them, with the blocks around them.
fn links(tokens: TokenStream) -> usize {
    let trees: Vec<TokenTree> = tokens.into_iter().collect();
    let word = |at: usize| trees.get(at).map(ToString::to_string).unwrap_or_default();
    let ends = |from: usize| (from..trees.len()).find(|&at| word(at) == ";").expect("an end");
    let mut sum = 0;
    for (at, tree) in trees.iter().enumerate() {
        if let TokenTree::Group(group) = tree {
            let inner = links(group.stream());
            let is_all = inner > 0 && inner == count(group.stream());
            // `const _ : () = { … };`
            sum += if is_all { inner + 9 } else { inner };
        }
        if word(at) == "use" && (at..ends(at)).any(|at| word(at) == "keywords") {
            let end = ends(ends(at) + 1);
            sum += count(trees[at..=end].iter().cloned().collect());
        }
    }
    sum
}

/// Returns the tokens of an expansion, and those of the links.
fn tokens(text: &str) -> (usize, usize) {
    let expansion = mstmm_codegen::expand(description(text), &quote!(::mstmm));
    assert!(expansion.errors.is_none(), "{:?}", expansion.errors);
    (count(expansion.items.clone()), links(expansion.items))
}

#[test]
fn links_of_keywords_are_at_most_two_percent_of_the_tokens() {
    let mut shares = Vec::new();
    for (name, text) in CHAINS {
        let (all, links) = tokens(text);
        assert!(links > 0, "{name}");
        let share = 100.0 * links as f64 / (all - links) as f64;
        println!("{name}: {links} of {all} tokens, {share:.2} %");
        shares.push(share);
    }
    assert!(shares.iter().all(|share| *share <= 2.0), "{shares:.2?}");
}
