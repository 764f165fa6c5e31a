//! The names of the types that a file defines: structs, enums, unions, traits, type aliases and the ids of
//! `declare_id!`, in all modules and functions except tests. Associated types of traits are not among them.

use proc_macro2::TokenTree;
use syn::visit::{self, Visit};
use syn::{Attribute, Ident, Item, ItemMacro};

/// Returns the names of the types that a Rust file defines.
pub fn type_names(text: &str) -> Vec<String> {
    let mut names = TypeNames(Vec::new());
    names.visit_file(&syn::parse_file(text).expect("Rust"));
    names.0
}

struct TypeNames(Vec<String>);

impl TypeNames {
    fn add(&mut self, name: &Ident) {
        self.0.push(name.to_string());
    }
}

impl<'ast> Visit<'ast> for TypeNames {
    fn visit_item(&mut self, item: &'ast Item) {
        match item {
            Item::Struct(it) => self.add(&it.ident),
            Item::Enum(it) => self.add(&it.ident),
            Item::Union(it) => self.add(&it.ident),
            Item::Trait(it) => self.add(&it.ident),
            Item::Type(it) => self.add(&it.ident),
            Item::Macro(it) if it.mac.path.is_ident("declare_id") => {
                self.0.extend(declared_ids(it));
            }
            Item::Mod(it) if is_test(&it.attrs) => return,
            _ => {}
        }
        visit::visit_item(self, item);
    }
}

fn is_test(attributes: &[Attribute]) -> bool {
    let is_test = |it: &Attribute| it.path().is_ident("cfg") && it.parse_args::<Ident>().is_ok();
    attributes.iter().any(is_test)
}

/// Returns the names in `declare_id! { /// Docs. Name, … }`.
fn declared_ids(item: &ItemMacro) -> impl Iterator<Item = String> {
    item.mac.tokens.clone().into_iter().filter_map(|token| match token {
        TokenTree::Ident(name) => Some(name.to_string()),
        _ => None,
    })
}
