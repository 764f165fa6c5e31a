//! No name of a description hides a method of the generated types: such names are refused.

use quote::{ToTokens, quote};
use std::collections::BTreeSet;
use syn::{ImplItem, Item, ItemImpl, TraitItem};

/// Returns a chain whose hinge, body, parameter, spring and point have these names.
fn text(hinge: &str, body: &str, parameter: &str, spring: &str, point: &str) -> String {
    format!(
        "pub chain Machine {{
            gravity = input;
            answers = [basic, momentum, regressor];
            param {parameter} = 1 kg;
            body Rod {{
                mass = {parameter}; com = [0.5, 0, 0] m; output = [1, 0, 0] m;
                inertia = diag(0.1, 0.2, 0.2) kg*m^2 about com;
                point {point} = [0, 0.1, 0] m;
            }}
            ground -> pin {hinge} -> Rod {body} -> ball own_second -> Rod own_end
                   -> ball own_closing -> ground at [1, 0, 0] m;
            spring {spring} {{ on = {body}.{point}; to = [1, 0, 0] m; stiffness = 1 N/m; }}
        }}"
    )
}

fn items(text: &str) -> Result<Vec<Item>, String> {
    let expansion = mstmm_codegen::expand(text.parse().expect("tokens"), &quote!(::mstmm));
    match expansion.errors {
        None => Ok(syn::parse2::<syn::File>(expansion.items).expect("items").items),
        Some(error) => Err(error.to_string()),
    }
}

/// Returns the functions of all implementations of a type.
fn functions_of(items: &[Item], name: &str) -> BTreeSet<String> {
    let is_of_type = |block: &&ItemImpl| {
        block.self_ty.to_token_stream().to_string().split(' ').next() == Some(name)
    };
    let blocks = items.iter().filter_map(|item| match item {
        Item::Impl(block) => Some(block),
        _ => None,
    });
    let entries = blocks.filter(is_of_type).flat_map(|block| &block.items);
    entries
        .filter_map(|entry| match entry {
            ImplItem::Fn(function) => Some(function.sig.ident.to_string()),
            _ => None,
        })
        .collect()
}

/// Returns the functions of a trait of the runtime, or of a type.
fn functions_in(file: &str, name: &str) -> BTreeSet<String> {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../mstmm-runtime/src");
    let source = std::fs::read_to_string(path.join(file)).expect("a source");
    let items = syn::parse_file(&source).expect("items").items;
    let of_traits = items.iter().filter_map(|item| match item {
        Item::Trait(found) if found.ident == name => Some(&found.items),
        _ => None,
    });
    let of_traits = of_traits.flatten().filter_map(|entry| match entry {
        TraitItem::Fn(function) => Some(function.sig.ident.to_string()),
        _ => None,
    });
    of_traits.chain(functions_of(&items, name)).collect()
}

/// Methods of traits of the standard library that a method of the same name only hides for a call by the name, and private
/// methods.
fn may_be_hidden(method: &str) -> bool {
    ["fmt", "deref"].contains(&method) || method.ends_with('_')
}

#[test]
fn names_that_hide_a_method_are_refused() {
    let usual = |at: usize, name: &str| {
        let mut names = ["own_hinge", "own_body", "own_parameter", "own_spring", "own_point"];
        names[at] = name;
        text(names[0], names[1], names[2], names[3], names[4])
    };
    let generated = items(&usual(0, "own_hinge")).expect("a valid chain");
    let of_type = |name: &str| functions_of(&generated, name);
    let union = |sets: [BTreeSet<String>; 2]| sets.into_iter().flatten().collect::<BTreeSet<_>>();
    // Methods by value of the prelude, which Rust prefers to methods by reference.
    let by_value = || BTreeSet::from(["into", "try_into"].map(str::to_owned));
    let of_state = union([of_type("MachineState"), functions_in("chain.rs", "ChainState")]);
    let of_state = union([of_state, by_value()]);
    let of_results = union([of_type("MachineWorkspace"), of_type("MachineKinematics")]);
    let of_results = union([of_results, by_value()]);
    let of_points = union([
        functions_in("body.rs", "BodyResult"),
        functions_in("kinematics/body.rs", "BodyKinematics"),
    ]);
    // Only generated code calls `new` and `frame`, on the types of the runtime.
    let of_points = of_points.into_iter().filter(|name| name != "new" && name != "frame");
    let setters = functions_in("description/described.rs", "Described");
    let setters = setters.iter().filter_map(|name| name.strip_prefix("set_"));
    let all = [
        (0, union([of_state, of_results.clone()])),
        (1, of_results.clone()),
        (2, union([of_type("MachineParameters"), setters.map(str::to_owned).collect()])),
        (3, of_results),
        (4, of_points.chain(["clone".to_owned()]).chain(by_value()).collect()),
    ];
    let mut count = 0;
    for (at, names) in all {
        let hidden = |name: &&String| !may_be_hidden(name) && !name.starts_with("own_");
        for name in names.iter().filter(hidden) {
            let refused = items(&usual(at, name)).err();
            let refused = refused.is_some_and(|error| error.contains(&format!("`{name}`")));
            assert!(refused, "{}", usual(at, name));
            count += 1;
        }
    }
    assert!(count > 20, "{count}");
}
