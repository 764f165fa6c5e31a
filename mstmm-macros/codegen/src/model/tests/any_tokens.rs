//! Whatever is written, the answer is a chain or a list of mistakes, never a panic.

use super::{PENDULUM, read};
use proc_macro2::{Group, TokenStream, TokenTree};

/// What a slip of the keyboard may leave behind, and what no one would write.
const SLIPS: &[&str] = &[
    "", ";", "->", "-", ",", "=", "::", "^", "*", "/", "#", "'a", "0", "1e999", "2kg", "\"text\"",
    "x", "X", "Self", "_", "r#x", "ground", "repeat", "turned", "about", "( )", "[1]", "{ }",
];

/// All streams in which one token is replaced.
fn replaced(tokens: &TokenStream, by: &TokenStream, each: &mut dyn FnMut(TokenStream)) {
    let trees: Vec<TokenTree> = tokens.clone().into_iter().collect();
    for (index, tree) in trees.iter().enumerate() {
        let with = |new: TokenStream| -> TokenStream {
            let before = trees[..index].iter().cloned();
            before.chain(new).chain(trees[index + 1..].iter().cloned()).collect()
        };
        each(with(by.clone()));
        if let TokenTree::Group(group) = tree {
            replaced(&group.stream(), by, &mut |inside| {
                let group = TokenTree::Group(Group::new(group.delimiter(), inside));
                each(with(group.into()));
            });
        }
    }
}

#[test]
fn one_token_replaced_by_anything() {
    let tokens: TokenStream = PENDULUM.parse().expect("tokens");
    let mut count = 0;
    for slip in SLIPS {
        replaced(&tokens, &slip.parse().expect("tokens"), &mut |wrong| {
            count += 1;
            // A chain, or mistakes with a message each.
            if let Err(errors) = read(wrong) {
                assert!(errors.into_iter().all(|error| !error.to_string().is_empty()));
            }
        });
    }
    assert!(count > 4000, "only {count} tries");
}
