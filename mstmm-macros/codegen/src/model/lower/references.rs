//! Uses of names in a description, for editors.

use proc_macro2::Ident;
use std::collections::HashSet;

use super::body;
use super::keyword_uses;
use super::place::Resolved;
use super::route_item::RouteItem;
use crate::syntax::{BlockKeyword, ChainSyntax, References, ValueSyntax};

/// Returns all names of elements in blocks after the route, all names of body types, and all keywords and uses
/// of parameters. Of the instances of a part, only the first is used.
pub(super) fn references(def: &ChainSyntax, resolved: Resolved) -> References {
    let Resolved { written, items, names, types } = resolved;
    let mut parts: HashSet<String> = HashSet::new();
    let scopes = written
        .scopes
        .iter()
        .map(|scope| scope.part.is_none_or(|part| parts.insert(part.name.to_string())));
    let is_first: Vec<bool> = scopes.collect();
    let blocks = written.blocks.iter().filter(|block| is_first[block.scope]);
    let element = |scope: usize, path: &[Ident]| {
        let item = &items[names.item(written, scope, path)?];
        let is_element = item.is_hinge() || item.is_body();
        let name = item.name().filter(|_| is_element)?;
        Some(with_span(&name.joined, path.last()?))
    };
    let mut references = References::default();
    for block in blocks.filter(|block| !body::is_type(&block.syntax)) {
        let (scope, block) = (block.scope, &*block.syntax);
        if matches!(block.word, BlockKeyword::Body | BlockKeyword::Hinge) {
            let paths = block.names.iter();
            references.elements.extend(paths.filter_map(|path| element(scope, &path.names)));
        }
        for field in block.fields.iter().filter(|field| field.name == "on" || field.name == "to") {
            let path = match &field.value {
                Some(ValueSyntax::Path(path)) => &path.names[..],
                Some(value) => value.word().map_or(&[][..], std::slice::from_ref),
                None => continue,
            };
            let body = || element(scope, path.split_last()?.1);
            references.elements.extend(element(scope, path).or_else(body));
        }
    }
    let mut seen = HashSet::new();
    let names = types.all.iter().map(|body_type| &body_type.result_name);
    references.types = names.filter(|name| seen.insert(name.to_string())).cloned().collect();
    let used = items.iter().zip(&written.items).filter_map(|(item, at)| match item {
        RouteItem::Body { word, body_type: Some(body_type), named: true, .. }
            if is_first[at.scope] =>
        {
            Some(with_span(&types.all[*body_type].result_name, word))
        }
        _ => None,
    });
    references.uses_of_types = used.collect();
    (references.keywords, references.parameters) = keyword_uses::of_chain(def);
    references
}

/// Returns a name with the span of another token.
fn with_span(name: &Ident, at: &Ident) -> Ident {
    let mut name = name.clone();
    name.set_span(at.span());
    name
}
