//! Finds items and instances of parts by their paths.

use proc_macro2::Ident;
use std::collections::HashMap;

use super::parts::WrittenOut;
use super::route_item::RouteItem;

/// The names of a chain with its parts written out.
pub(crate) struct NameTable {
    /// The first item with each path.
    items: HashMap<String, usize>,
    /// The instances of parts.
    instances: HashMap<String, usize>,
    /// Whether an item has the name of an earlier one. It may be meant to have a different name.
    duplicates: Duplicates,
}

/// Which items have the name of another item.
#[derive(Clone, Copy, Default)]
pub(super) struct Duplicates {
    /// A body.
    pub body: bool,
    /// A hinge or an end.
    pub other: bool,
}

impl NameTable {
    /// Collects the names of all items.
    pub fn new(written: &WrittenOut, items: &[RouteItem]) -> Self {
        let mut names: HashMap<String, usize> = HashMap::new();
        let mut duplicates = Duplicates::default();
        for (index, item) in items.iter().enumerate() {
            let Some(name) = item.name() else { continue };
            let Some(&first) = names.get(&name.path) else {
                names.insert(name.path.clone(), index);
                continue;
            };
            for item in [item, &items[first]] {
                match item {
                    RouteItem::Body { .. } => duplicates.body = true,
                    _ => duplicates.other = true,
                }
            }
            // Of two items with one name, which is an error, the one that can have a block.
            if matches!(items[first], RouteItem::Moving { .. }) {
                names.insert(name.path.clone(), index);
            }
        }
        let scopes = written.scopes.iter().enumerate();
        let named =
            scopes.filter_map(|(index, scope)| Some((scope.name.as_ref()?.path.clone(), index)));
        NameTable { items: names, instances: named.collect(), duplicates }
    }

    /// Returns the item with a path in a scope.
    pub fn item(&self, written: &WrittenOut, scope: usize, path: &[Ident]) -> Option<usize> {
        self.items.get(&written.scopes[scope].path(path)).copied()
    }

    /// Returns the item with a path as seen from outside of all parts.
    pub fn by_path(&self, path: &str) -> Option<usize> {
        self.items.get(path).copied()
    }

    /// Returns the instance of a part with a path as seen from outside of all parts.
    pub fn instance_by_path(&self, path: &str) -> Option<usize> {
        self.instances.get(path).copied()
    }

    /// Returns the instance of a part with a path in a scope.
    pub fn instance(&self, written: &WrittenOut, scope: usize, path: &[Ident]) -> Option<usize> {
        self.instances.get(&written.scopes[scope].path(path)).copied()
    }

    /// Returns which items have the name of another item.
    pub(super) fn duplicates(&self) -> Duplicates {
        self.duplicates
    }
}
