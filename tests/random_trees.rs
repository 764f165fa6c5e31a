//! Random trees compiled by the macro and compared with the independent solver: accelerations, efforts,
//! springs, every quantity at every connection point, energies.
//!
//! `random/trees.rs` contains the trees printed from the seeds; a test compares it, and
//! `MSTMM_BLESS=1 cargo test --test random_trees` rewrites it.

mod random {
    pub mod compare;
    pub mod face;
    pub mod print;
    // Kept as printed.
    // Random starts of closed chains may give a warning.
    #[allow(deprecated)]
    #[rustfmt::skip]
    pub mod trees;
}
mod support;

use mstmm_reference::{
    Chain, Dimension, End, Ends, Features, Random, SpringEnd, TreeRecipe, random_described_tree,
    random_tree,
};
use random::compare::compare;
use random::print::{printed, printed_as};
use random::trees;

/// The tree of a seed: all ends and dimensions; everything may occur. One has forty bodies.
fn tree(seed: u64) -> Chain {
    let dimension = match seed {
        LARGE => Dimension::Plane,
        _ if seed % 6 == 5 => Dimension::Line,
        _ if seed % 3 == 1 => Dimension::Plane,
        _ => Dimension::Space,
    };
    let ends =
        if seed == LARGE { Ends::FreeFree } else { Ends::ALL[seed as usize % Ends::ALL.len()] };
    let bodies = if seed == LARGE { 40 } else { 3 + (seed as usize * 3) % 5 };
    let tree = |again: u64| {
        let mut random = Random::new(seed + 1000 * again);
        let mut recipe = TreeRecipe::rich(&mut random, dimension, bodies, ends);
        recipe.forest = 0.2;
        random_tree(&mut random, &format!("Tree{seed}"), &recipe)
    };
    let branches = |tree: &Chain| !tree.later_routes.is_empty();
    (0..).map(tree).find(branches).expect("one of many trees")
}

const LARGE: u64 = 13;

/// The tree of a seed with parts, and its text; names of elements in the tree are those of methods.
fn tree_of_parts(seed: u64) -> (String, Chain) {
    let mut random = Random::new(seed);
    let dimension = *random.choose(&[Dimension::Space, Dimension::Plane]);
    let ends = Ends::ALL[seed as usize % Ends::ALL.len()];
    let recipe = TreeRecipe::rich(&mut random, dimension, 1, ends);
    let features = Features { parts: true, repeats: false };
    random_described_tree(&mut random, &format!("Tree{seed}"), &recipe, features)
}

fn written_out(seed: u64) -> Chain {
    tree_of_parts(seed).1
}

fn text() -> String {
    let mut text = String::from(
        "//! Printed from the seeds in `../random_trees.rs`; not to be edited.\n\n\
         use super::face::printed;\nuse crate::support::motion::*;\n",
    );
    for seed in SEEDS {
        text.push_str(&printed(&tree(seed)));
    }
    for seed in SEEDS_OF_PARTS {
        let (description, tree) = tree_of_parts(seed);
        text.push_str(&printed_as(&tree, &description));
    }
    text
}

#[test]
fn the_trees_are_those_of_the_seeds() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/random/trees.rs");
    if std::env::var_os("MSTMM_BLESS").is_some() {
        std::fs::write(path, text()).expect("a writable folder");
    }
    let committed = std::fs::read_to_string(path).expect("the committed trees");
    assert!(committed == text(), "MSTMM_BLESS=1 cargo test --test random_trees prints them anew");
}

#[test]
fn the_seeds_have_everything() {
    let trees: Vec<Chain> = SEEDS.into_iter().map(tree).collect();
    let starts = || trees.iter().flat_map(|tree| &tree.later_routes).map(|route| &route.start);
    let has_place = |wanted: fn(&str) -> bool| {
        starts().any(|end| matches!(end, End::Place(place) if wanted(&place.point)))
    };
    let springs = || trees.iter().flat_map(|tree| &tree.springs);
    let missing: Vec<&str> = [
        ("input", has_place(|point| point == "input")),
        ("output", has_place(|point| point == "output")),
        ("named point", has_place(|point| point.starts_with('f'))),
        ("ground", starts().any(|end| matches!(end, End::Held(_)))),
        ("moving", starts().any(|end| matches!(end, End::Moving { .. }))),
        ("closed", trees.iter().any(Chain::closed)),
        ("floating", trees.iter().any(Chain::floats)),
        ("spring", springs().any(|spring| matches!(spring.to, SpringEnd::Body { .. }))),
        ("motion", trees.iter().flat_map(Chain::hinges).any(|hinge| hinge.prescribed)),
    ]
    .into_iter()
    .filter(|(_, there)| !there)
    .map(|(what, _)| what)
    .collect();
    assert!(missing.is_empty(), "missing: {missing:?}");
}

/// One test a seed.
macro_rules! seeds {
    ($seeds:ident $tree_of:ident; $($seed:literal $test:ident $tree:ident;)*) => {
        const $seeds: [u64; [$($seed),*].len()] = [$($seed),*];
        $(
            #[test]
            fn $test() {
                compare::<trees::$tree<f64>>(stringify!($tree), &$tree_of($seed), $seed);
            }
        )*
    };
}

seeds! {
    SEEDS tree;
    0 seed_0 Tree0;
    1 seed_1 Tree1;
    2 seed_2 Tree2;
    3 seed_3 Tree3;
    4 seed_4 Tree4;
    5 seed_5 Tree5;
    6 seed_6 Tree6;
    7 seed_7 Tree7;
    8 seed_8 Tree8;
    9 seed_9 Tree9;
    10 seed_10 Tree10;
    11 seed_11 Tree11;
    12 seed_12 Tree12;
    13 seed_13 Tree13;
}

seeds! {
    SEEDS_OF_PARTS written_out;
    20 seed_20 Tree20;
    21 seed_21 Tree21;
    22 seed_22 Tree22;
    23 seed_23 Tree23;
    24 seed_24 Tree24;
    25 seed_25 Tree25;
}
