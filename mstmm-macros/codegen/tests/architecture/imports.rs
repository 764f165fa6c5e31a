//! The imports between modules: paths that start with `super`, `self` or `crate`.
//!
//! Towards its neighbours a folder counts as one module. Its own `mod.rs` may name everything in it, and a name that it
//! re-exports counts for the file that defines it.

use std::collections::{BTreeMap, BTreeSet};

/// The path of a module.
type Module = Vec<String>;

/// The code of all modules, without tests and comments.
pub struct Imports(BTreeMap<Module, String>);

impl Imports {
    /// Reads files, each with its path below `src/` and its code.
    pub fn of<'a>(files: impl IntoIterator<Item = (&'a str, &'a str)>) -> Self {
        let module = |file: &str| {
            let names = file.trim_end_matches(".rs").split('/').map(str::to_owned);
            names.filter(|name| name != "mod" && name != "lib").collect()
        };
        Imports(files.into_iter().map(|(file, code)| (module(file), code.to_owned())).collect())
    }

    /// Returns the modules of each folder that import themselves through others.
    pub fn circles(&self) -> Vec<String> {
        let folders = self.0.keys().filter_map(|module| Some(module.split_last()?.1));
        let folders: BTreeSet<&[String]> = folders.collect();
        folders.into_iter().flat_map(|folder| self.circles_in(folder)).collect()
    }

    fn circles_in(&self, folder: &[String]) -> Vec<String> {
        let entry = |module: &[String]| module.strip_prefix(folder)?.first().cloned();
        let mut known: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
        for (module, code) in &self.0 {
            let Some(from) = entry(module) else { continue };
            let named = named(code).into_iter().map(|path| self.found(module, &path));
            known.entry(from).or_default().extend(named.filter_map(|module| entry(&module)));
        }
        for (from, direct) in &mut known {
            direct.remove(from);
        }
        let circle = |from: &String| {
            let all = reached(from, &known);
            let back = all.iter().filter(|other| reached(other, &known).contains(from));
            all.contains(from).then(|| back.map(String::as_str).collect::<Vec<_>>().join(", "))
        };
        let circles: BTreeSet<String> = known.keys().filter_map(circle).collect();
        let path = folder.join("/");
        circles.into_iter().map(|circle| format!("{path}/{{{circle}}}")).collect()
    }

    /// Returns the module that a path in `from` leads to.
    fn found(&self, from: &[String], path: &[&str]) -> Module {
        let mut at = from.to_vec();
        for &name in path {
            match name {
                "crate" => at.clear(),
                "self" => {}
                "super" => _ = at.pop(),
                _ => match self.inside(&at, name).or_else(|| self.handed_on(&at, name)) {
                    Some(inside) => at = inside,
                    None => break,
                },
            }
        }
        at
    }

    fn inside(&self, module: &[String], name: &str) -> Option<Module> {
        let inside = [module, &[name.to_owned()]].concat();
        self.0.contains_key(&inside).then_some(inside)
    }

    /// Returns the module inside `module` that defines a name which `module` re-exports.
    fn handed_on(&self, module: &[String], name: &str) -> Option<Module> {
        let words = words(self.0.get(module)?);
        let mut paths = Vec::new();
        for at in (0..words.len()).filter(|&at| words[at] == "use") {
            paths_from(&words, at + 1, &[], &mut paths);
        }
        paths.iter().find_map(|path| match path[..] {
            [inside, .., last] if last == name => self.inside(module, inside),
            _ => None,
        })
    }
}

/// Returns all modules that are imported directly or through others.
fn reached(from: &str, known: &BTreeMap<String, BTreeSet<String>>) -> BTreeSet<String> {
    let mut all = BTreeSet::new();
    let mut left = vec![from];
    while let Some(next) = left.pop() {
        let new = known.get(next).into_iter().flatten().filter(|name| all.insert((*name).clone()));
        left.extend(new.map(String::as_str));
    }
    all
}

/// Returns the paths in some code that start within the crate.
fn named(code: &str) -> Vec<Vec<&str>> {
    let words = words(code);
    let mut paths = Vec::new();
    let mut at = 0;
    while at < words.len() {
        let begins = ["crate", "super", "self"].contains(&words[at]);
        if begins && words.get(at + 1) == Some(&"::") {
            at = paths_from(&words, at, &[], &mut paths);
        }
        at += 1;
    }
    paths
}

/// Reads a path, or all paths in its braces; returns the index of the last word.
fn paths_from<'a>(
    words: &[&'a str],
    mut at: usize,
    before: &[&'a str],
    paths: &mut Vec<Vec<&'a str>>,
) -> usize {
    let mut path = before.to_vec();
    while words.get(at).is_some_and(|word| is_name(word)) {
        path.push(words[at]);
        if words.get(at + 1) != Some(&"::") {
            paths.push(path);
            return at;
        }
        at += 2;
    }
    if words.get(at) == Some(&"{") {
        at += 1;
        while words.get(at).is_some_and(|&word| word != "}") {
            at = 1 + if is_name(words[at]) { paths_from(words, at, &path, paths) } else { at };
        }
    } else {
        // A glob, or types in angle brackets.
        paths.push(path);
    }
    at
}

fn is_name(word: &str) -> bool {
    word.starts_with(|c: char| c.is_alphabetic() || c == '_')
}

/// Splits code into names, `::` and single characters.
fn words(code: &str) -> Vec<&str> {
    let mut words = Vec::new();
    let mut rest = code.trim_start();
    while let Some(first) = rest.chars().next() {
        let in_name = |c: char| c.is_alphanumeric() || c == '_';
        let length = match rest.find(|c| !in_name(c)) {
            Some(0) if rest.starts_with("::") => 2,
            Some(0) => first.len_utf8(),
            Some(length) => length,
            None => rest.len(),
        };
        words.push(&rest[..length]);
        rest = rest[length..].trim_start();
    }
    words
}
