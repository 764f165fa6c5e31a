//! Right chains.

use mstmm_reference::{Random, Recipe, random_mechanism};
use proptest::prelude::*;
use proptest::sample::select;
use std::path::Path;

/// Bodies of a random chain: more take longer and bring nothing new.
const BODIES: usize = 2;

/// Longer chains are left out of those whose operations are counted, in bytes.
const LONGEST: usize = 900;

/// All files of a folder beside this test that end so, with their names, in the order of these.
pub fn files(folder: &str, end: &str) -> Vec<(String, String)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests").join(folder);
    let entries = std::fs::read_dir(folder).expect("a folder");
    let paths = entries.map(|entry| entry.expect("an entry").path());
    let named =
        paths.map(|path| (path.file_name().expect("a name").to_string_lossy().into_owned(), path));
    let mut files: Vec<_> = named.filter(|(name, _)| name.ends_with(end)).collect();
    files.sort();
    let read = |path| std::fs::read_to_string(path).expect("a text");
    files.into_iter().map(|(name, path)| (name, read(path))).collect()
}

/// The chains that are committed as text.
pub fn committed() -> Vec<String> {
    let folders = ["expand", "../../../fuzz/seeds"].into_iter();
    let alone = folders.flat_map(|folder| files(folder, ".chain")).map(|(_, text)| text);
    let counted = files(".", "operation_counts.chains").remove(0).1;
    let counted = counted.split_inclusive("\n}\n").filter(|text| text.len() < LONGEST);
    alone.chain(counted.map(str::to_owned)).collect()
}

/// One of them, or a random one.
pub fn any() -> BoxedStrategy<String> {
    prop_oneof![select(committed()), proptest::num::u64::ANY.prop_map(random)].boxed()
}

fn random(seed: u64) -> String {
    let mut random = Random::new(seed);
    let recipe = Recipe::any(&mut random, BODIES);
    let method = *random.choose(&[None, None, Some("riccati"), Some("transfer")]);
    random_mechanism(&mut random, "Random", &recipe).to_macro_text(method)
}
