//! The methods that a chain does not have because its description does not ask for them
//! (`mstmm-runtime/src/generated/not_asked/`) are those that the words of `answers` add.

use mstmm_codegen::model::ANSWER_WORDS;
use quote::{ToTokens, quote};
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use syn::{ImplItem, ImplItemFn, Item};

/// A method's name, and the number of its arguments after `&self`.
type Method = (String, usize);

fn method(function: &ImplItemFn) -> Method {
    (function.sig.ident.to_string(), function.sig.inputs.len() - 1)
}

/// Returns the functions of all inherent implementations of a type.
fn functions<'a>(items: &'a [Item], name: &'a str) -> impl Iterator<Item = &'a ImplItemFn> {
    let blocks = items.iter().filter_map(move |item| match item {
        Item::Impl(block) if block.trait_.is_none() => {
            let of_type = block.self_ty.to_token_stream().to_string();
            (of_type.split(' ').next() == Some(name)).then_some(block)
        }
        _ => None,
    });
    blocks.flat_map(|block| &block.items).filter_map(|item| match item {
        ImplItem::Fn(function) => Some(function),
        _ => None,
    })
}

/// Returns the items of a chain with these answers.
fn items(answers: &str) -> Vec<Item> {
    let text = format!(
        "pub chain Arm {{
            gravity = [0, 0, -9.81] m/s^2;
            {answers}
            body Rod {{
                mass = 2 kg; com = [0.3, 0, 0] m; output = [0.6, 0, 0] m;
                inertia = diag(0.01, 0.02, 0.02) kg*m^2 about com;
            }}
            ground -> pin(y) shoulder -> Rod upper -> pin(y) elbow -> Rod lower;
            hinge shoulder, elbow {{ torque = input; }}
        }}"
    );
    let expansion = mstmm_codegen::expand(text.parse().expect("tokens"), &quote!(::mstmm));
    assert!(expansion.errors.is_none(), "{:?}", expansion.errors);
    syn::parse2::<syn::File>(expansion.items).expect("items").items
}

/// Returns the public methods of a chain with these answers.
fn generated(answers: &str) -> Vec<Method> {
    let items = items(answers);
    let functions = functions(&items, "Arm");
    let public = functions.filter(|function| matches!(function.vis, syn::Visibility::Public(_)));
    public.filter(|function| function.sig.receiver().is_some()).map(method).collect()
}

/// Returns the Jacobians of bodies that a chain with these answers lists as methods that it does not have.
fn of_bodies(answers: &str) -> Vec<String> {
    let lists = items(answers).into_iter().filter_map(|item| match item {
        Item::Macro(call) if call.mac.path.segments.last()?.ident == "not_asked" => {
            Some(call.mac.tokens.into_iter().map(|token| token.to_string()))
        }
        _ => None,
    });
    lists.flatten().skip(1).collect()
}

/// Returns the methods that are not asked for, with the trait that each needs.
fn not_asked() -> BTreeMap<Method, String> {
    let folder =
        Path::new(env!("CARGO_MANIFEST_DIR")).join("../../mstmm-runtime/src/generated/not_asked");
    let sources = fs::read_dir(folder).expect("a folder").map(|entry| {
        let source = fs::read_to_string(entry.expect("an entry").path()).expect("a source");
        syn::parse_file(&source).expect("items").items
    });
    let items: Vec<Item> = sources.flatten().collect();
    let methods = functions(&items, "NotAsked");
    methods
        .map(|function| {
            let needs = function.sig.generics.where_clause.to_token_stream().to_string();
            let (_, needed) = needs.rsplit_once("Asks").expect("a trait");
            (method(function), needed.trim_end_matches([' ', ',']).to_owned())
        })
        .collect()
}

/// `mass_matrix` is `MassMatrix`.
fn camel_case(word: &str) -> String {
    let parts = word.split('_');
    parts.map(|part| part[..1].to_uppercase() + &part[1..]).collect()
}

#[test]
fn a_method_that_a_word_adds_is_an_error_without_the_word() {
    let (always, not_asked, of_bodies) = (generated(""), not_asked(), of_bodies(""));
    let clashes: Vec<_> = always.iter().filter(|method| not_asked.contains_key(method)).collect();
    assert!(clashes.is_empty(), "every chain has {clashes:?}");
    for (word, _) in ANSWER_WORDS {
        let with = generated(&format!("answers = {word};"));
        for method in with.iter().filter(|method| !always.contains(method)) {
            let is_known = not_asked.contains_key(method) || of_bodies.contains(&method.0);
            assert!(is_known, "{word} adds {method:?}, which has no error");
        }
    }
}

#[test]
fn a_chain_lists_the_jacobians_of_bodies_that_it_lacks() {
    let names = |bodies: &[&str]| -> Vec<String> {
        let endings = ["jacobian", "jacobian_into"];
        bodies.iter().flat_map(|body| endings.map(|end| format!("{body}_{end}"))).collect()
    };
    assert_eq!(of_bodies(""), names(&["upper", "lower"]));
    assert_eq!(of_bodies("answers = kinematics;"), names(&["upper", "lower"]));
    assert_eq!(of_bodies("answers = jacobian;"), names(&["upper"]));
}

#[test]
fn errors_name_words_that_exist() {
    let words: Vec<String> = ANSWER_WORDS.iter().map(|(word, _)| camel_case(word)).collect();
    for (method, needed) in not_asked() {
        let needed = needed.split("Of").next().unwrap_or_default().to_owned();
        assert!(words.contains(&needed), "{method:?} needs {needed}");
    }
}
