//! Uses of names in a description, for editors.

use super::body;
use super::route::RouteItem;
use crate::syntax::{BlockKeyword, BlockSyntax, ChainSyntax, References};

/// Returns all names of elements in blocks after the route, and all names of body types.
pub(super) fn references(def: &ChainSyntax, items: &[RouteItem]) -> References {
    let is_element = |name: &&proc_macro2::Ident| {
        items.iter().any(|item| match item {
            RouteItem::Hinge { name: item_name, .. } => {
                item_name.is_some_and(|item_name| item_name == *name)
            }
            RouteItem::Body { name: item_name, .. } => item_name == *name,
            _ => false,
        })
    };
    let after_types = def.blocks.iter().filter(|block| !body::is_type(block));
    let named = after_types.flat_map(|block: &BlockSyntax| {
        let on = block.fields.iter().find(|field| field.name == "on");
        let on = on.and_then(|field| field.value.as_ref()?.word());
        let names =
            matches!(block.word, BlockKeyword::Body | BlockKeyword::Hinge).then_some(&block.names);
        names.into_iter().flatten().chain(on)
    });
    let used = items.iter().filter_map(|item| match item {
        RouteItem::Body { word, body_type: Some(_), named: true, .. } => Some((*word).clone()),
        _ => None,
    });
    let types = def.blocks.iter().filter(|block| body::is_type(block));
    References {
        elements: named.filter(is_element).cloned().collect(),
        types: types.filter_map(|block| block.names.first().cloned()).collect(),
        uses_of_types: used.collect(),
    }
}
