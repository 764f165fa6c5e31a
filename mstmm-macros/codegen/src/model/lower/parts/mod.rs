//! Writes out parts: after this step there are only routes, body types and blocks, with paths as names.

mod arguments;
mod definitions;
mod substitute;
mod writer;

use proc_macro2::Ident;
use std::borrow::Cow;
use std::fmt;
use std::ops::Range;
use syn::ext::IdentExt;

use crate::diag::Diagnostics;
use crate::syntax::{
    BlockSyntax, ChainSyntax, PartInstance, PartSyntax, RepeatSyntax, RouteItemSyntax, RouteSyntax,
};
pub(super) use definitions::warn_of_unused;
use substitute::Substitution;
use writer::RouteWriter;

/// A description with its parts written out.
pub(crate) struct WrittenOut<'a> {
    /// The chain, then the instances of parts.
    pub scopes: Vec<Scope<'a>>,
    /// The names of all parts.
    pub parts: Vec<&'a Ident>,
    /// The names of the parts that are never set on a route.
    pub unused_parts: Vec<&'a Ident>,
    /// All items in the order of the text: route by route, in a repeated part its first route, then its branches.
    pub items: Vec<WrittenItem<'a>>,
    /// The routes. The first route of a part and that of a repeated part belong to the route that they continue.
    pub routes: Vec<WrittenRoute<'a>>,
    /// The repeated parts.
    pub repeats: Vec<WrittenRepeat<'a>>,
    /// The blocks: those of a part with the route that sets it.
    pub blocks: Vec<WrittenBlock<'a>>,
    /// Whether every item was readable. If not, nothing is reported as missing.
    pub complete: bool,
    /// Whether every route was readable.
    pub routes_are_complete: bool,
}

impl WrittenOut<'_> {
    /// Returns the instances of parts, in the order of the text.
    pub fn instances(&self) -> Vec<PartInstance> {
        let instance = |scope: &Scope| {
            let (name, part) = (scope.name.as_ref()?, scope.part?);
            let (path, docs) = (name.path.clone(), part.docs.clone());
            Some(PartInstance { path, part: part.name.clone(), docs })
        };
        self.scopes.iter().filter_map(instance).collect()
    }
}

/// The chain or an instance of a part: the names that its text may use.
pub(crate) struct Scope<'a> {
    /// The part; `None` for the chain.
    pub part: Option<&'a PartSyntax>,
    /// The scope that sets the part.
    pub parent: usize,
    /// The name of the instance.
    pub name: Option<ItemName>,
    /// Whether the name of the instance is written.
    pub is_named: bool,
    /// The beginning of paths: `rex.lf.`; empty for the chain.
    prefix: String,
    /// The beginning of joined names: `rex_lf_`.
    joined_prefix: String,
    /// The number of scopes around it.
    depth: usize,
    /// The arguments; `None` if there are no parameters.
    substitution: Option<Substitution>,
    /// The instances on each of its routes.
    instances: Vec<Vec<usize>>,
}

impl Scope<'_> {
    /// Returns the name of an item in this scope.
    pub fn item_name(&self, name: &Ident) -> ItemName {
        let joined = match self.part {
            None => name.clone(),
            Some(_) => Ident::new(&format!("{}{}", self.joined_prefix, name.unraw()), name.span()),
        };
        ItemName { joined, path: format!("{}{name}", self.prefix) }
    }

    /// Returns a path in this scope as seen from outside of all parts.
    pub fn path(&self, names: &[Ident]) -> String {
        let mut path = self.prefix.clone();
        for (index, name) in names.iter().enumerate() {
            let point = if index > 0 { "." } else { "" };
            path += &format!("{point}{name}");
        }
        path
    }

    /// Returns the number of scopes around it.
    pub fn depth(&self) -> usize {
        self.depth
    }

    /// Returns the beginning of the paths of its items: `rex.lf.`; empty for the chain.
    pub fn prefix(&self) -> &str {
        &self.prefix
    }
}

/// A name on a route.
#[derive(Clone, Debug)]
pub(crate) struct ItemName {
    /// The name in Rust: the names of the path joined by `_`, with the span of the last one.
    pub joined: Ident,
    /// The path: `rex.lf.knee`.
    pub path: String,
}

impl ItemName {
    /// Returns the last name of the path.
    pub fn own(&self) -> &str {
        self.path.rsplit('.').next().unwrap_or(&self.path)
    }
}

impl fmt::Display for ItemName {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(&self.path)
    }
}

/// An item of a route.
pub(crate) struct WrittenItem<'a> {
    /// The item, with arguments in place of parameters.
    pub syntax: Cow<'a, RouteItemSyntax>,
    /// The scope in which it is written.
    pub scope: usize,
    /// The route that it is on.
    pub route: usize,
    /// The repeated part that it is in.
    pub repeat: Option<usize>,
}

/// A route.
pub(crate) struct WrittenRoute<'a> {
    /// As written, without what continues it.
    pub syntax: &'a RouteSyntax,
    /// The scope in which it is written.
    pub scope: usize,
    /// The repeated part of which it is a branch.
    pub repeat: Option<usize>,
    /// Its items.
    pub items: Vec<usize>,
}

/// A repeated part.
pub(crate) struct WrittenRepeat<'a> {
    /// As written.
    pub syntax: &'a RepeatSyntax,
    /// The scope in which it is written.
    pub scope: usize,
    /// The route that its first route continues.
    pub route: usize,
    /// Its items, including those of its branches.
    pub items: Range<usize>,
    /// The positions on the route of the items of its first route.
    pub on_route: Range<usize>,
}

/// A block.
pub(crate) struct WrittenBlock<'a> {
    /// The block, with arguments in place of parameters.
    pub syntax: Cow<'a, BlockSyntax>,
    /// The block as written: instances without parameters in it have the same block.
    pub source: &'a BlockSyntax,
    /// The scope in which it is written.
    pub scope: usize,
}

/// Writes out all parts of a description and reports errors in their definitions and their uses.
pub(in crate::model) fn write_out<'a>(
    def: &'a ChainSyntax,
    diagnostics: &mut Diagnostics,
) -> WrittenOut<'a> {
    let parts = definitions::parts(def, diagnostics);
    let unused_parts = definitions::unused(def, &parts);
    let words_are_clear = definitions::words_are_clear(def, &parts);
    let mut writer = RouteWriter::new(def, parts, diagnostics);
    writer.write_chain();
    let mut written = writer.written;
    written.unused_parts = unused_parts;
    let parts: Vec<&PartSyntax> = written.scopes.iter().filter_map(|scope| scope.part).collect();
    let parts_are_complete = parts.iter().all(|part| part.content.complete);
    written.complete &= def.content.complete && parts_are_complete;
    // An unreadable item of a part may be a route.
    written.routes_are_complete &= parts_are_complete && words_are_clear;
    let contents = parts.iter().map(|part| &part.content).chain([&def.content]);
    let mut routes = contents.flat_map(|content| &content.routes);
    written.routes_are_complete &= routes.all(RouteSyntax::is_complete);
    written
}

/// `UpperArm` is `upper_arm`, `L1` is `l1`, `IMUCase` is `imu_case`.
pub(super) fn snake_case(name: &Ident) -> Ident {
    let letters: Vec<char> = name.unraw().to_string().chars().collect();
    let mut snake = String::new();
    for (at, &letter) in letters.iter().enumerate() {
        let before = at.checked_sub(1).map(|before| letters[before]);
        let after = letters.get(at + 1);
        let begins_word = letter.is_uppercase()
            && before.is_some_and(|before| {
                before != '_'
                    && (!before.is_uppercase() || after.is_some_and(|after| after.is_lowercase()))
            });
        if begins_word {
            snake.push('_');
        }
        snake.extend(letter.to_lowercase());
    }
    Ident::new(&snake, name.span())
}

#[cfg(test)]
mod tests {
    use super::snake_case;

    #[test]
    fn type_names_become_names() {
        let snake = |name| snake_case(&quote::format_ident!("{name}")).to_string();
        let names = ["UpperArm", "L1", "IMUCase", "rod", "My_Rod"].map(snake);
        assert_eq!(names, ["upper_arm", "l1", "imu_case", "rod", "my_rod"]);
    }
}
