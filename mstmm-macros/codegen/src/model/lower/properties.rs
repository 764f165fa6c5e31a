//! Properties of hinges and bodies from the blocks after the route.

use proc_macro2::Ident;

use super::body;
use super::context::Context;
use super::fields::Fields;
use super::hinge::{self, HingeProperties, motion, of_everything};
use super::route::RouteItem;
use crate::syntax::{BlockKeyword, BlockSyntax, ChainSyntax, RouteSyntax};
use std::collections::HashMap;

/// The properties of a route item.
#[derive(Clone, Default)]
pub(crate) struct ItemProperties<'a> {
    /// As written.
    pub fields: Fields<'a>,
    /// The properties of a hinge, or of the implied hinge of the first body of a floating chain.
    pub motion: Option<HingeProperties>,
}

/// Reads the properties of each item.
pub(super) fn properties<'a>(
    def: &'a ChainSyntax,
    items: &[RouteItem],
    context: &mut Context,
) -> Vec<ItemProperties<'a>> {
    let mut fields = vec![Fields::default(); items.len()];
    let indices = indices(items);
    for block in def.blocks.iter().filter(|block| !body::is_type(block)) {
        refuse_points(block, context);
        if !matches!(block.word, BlockKeyword::Body | BlockKeyword::Hinge) {
            continue;
        }
        if !block.after_route && def.route.is_some() {
            context.diagnostics.error(block.at, "write the block of a hinge after the route");
        }
        assign(block, def, items, &indices, &mut fields, context);
    }
    let floats = floats(items);
    let read = |(index, (item, fields)): (usize, (&RouteItem, Fields<'a>))| {
        let spec = match item {
            RouteItem::Hinge { spec, .. } => Some(*spec),
            RouteItem::Body { .. } if index == 0 && floats => {
                Some(of_everything(context.space).spec())
            }
            _ => None,
        };
        let motion = spec.map(|spec| motion(spec, &fields, context));
        ItemProperties { fields, motion }
    };
    items.iter().zip(fields).enumerate().map(read).collect()
}

/// Only body types have points.
fn refuse_points(block: &BlockSyntax, context: &mut Context) {
    for point in &block.points {
        let message = "write points in the block of a body type, before the route";
        context.diagnostics.error(point.name.span(), message);
    }
}

/// Returns the index of the first item with each name.
fn indices(items: &[RouteItem]) -> HashMap<String, usize> {
    let is_end = |item: &RouteItem| matches!(item, RouteItem::Moving { .. });
    let mut names: Vec<_> = items.iter().enumerate().rev().collect();
    // Of two items with one name, which is an error, the one that can have a block.
    names.sort_by_key(|(_, item)| !is_end(item));
    let named = |(index, item): (usize, &RouteItem)| Some((item.name()?.to_string(), index));
    names.into_iter().filter_map(named).collect()
}

/// Returns whether the chain has a floating base.
pub(super) fn floats(items: &[RouteItem]) -> bool {
    matches!(items, [RouteItem::Body { .. }, .., RouteItem::Body { .. }] | [RouteItem::Body { .. }])
}

/// Assigns the fields of a block to the items that it names.
fn assign<'a>(
    block: &'a BlockSyntax,
    def: &ChainSyntax,
    items: &[RouteItem],
    indices: &HashMap<String, usize>,
    fields: &mut [Fields<'a>],
    context: &mut Context,
) {
    // A field that is wrong for one hinge is not reported again for the next one.
    let mut refused = Vec::new();
    for name in &block.names {
        let found = indices.get(&name.to_string()).copied();
        let Some(index) = target(block, name, found, def, items, context) else { continue };
        let (allowed, owner) = match &items[index] {
            RouteItem::Hinge { kind, spec, .. } => (hinge::fields(spec), kind.name.to_owned()),
            RouteItem::Body { .. } => {
                let implied = of_everything(context.space).spec();
                (hinge::start_fields(implied), format!("body `{name}`"))
            }
            _ => continue,
        };
        let fields = &mut fields[index];
        if !block.complete {
            fields.refuse();
        }
        for (at, field) in block.fields.iter().enumerate() {
            if refused.contains(&at) {
                fields.refuse();
            } else if fields.add(field, &allowed, &owner, context).is_none() {
                refused.push(at);
            }
        }
    }
}

/// Returns the item of a name in a block; `None` if no item of this name can have a block.
fn target(
    block: &BlockSyntax,
    name: &Ident,
    found: Option<usize>,
    def: &ChainSyntax,
    items: &[RouteItem],
    context: &mut Context,
) -> Option<usize> {
    let Some(index) = found else {
        unknown_name(block, name, def, items, context);
        return None;
    };
    match (block.word, &items[index]) {
        (BlockKeyword::Body, RouteItem::Hinge { .. }) => {
            context.refuse(name, format!("`{name}` is a hinge: write `hinge {name} {{ … }}`"))
        }
        (_, RouteItem::Moving { .. }) => {
            let message =
                format!("`{name}` is a moving end and has no properties: its motion is an input");
            context.refuse(name, message)
        }
        // It may be a hinge whose kind is not known.
        (BlockKeyword::Hinge, RouteItem::Body { body_type: None, .. }) => None,
        (BlockKeyword::Hinge, RouteItem::Body { .. }) => {
            context.refuse(name, format!("`{name}` is a body: write `body {name} {{ … }}`"))
        }
        (BlockKeyword::Body, RouteItem::Body { .. }) if index > 0 || !floats(items) => {
            // If the route has an error, this rule may be wrong.
            if !def.route.as_ref().is_some_and(|route| route.complete) {
                return None;
            }
            let message =
                format!("`{name}` has no start: only the first body of a floating chain has one");
            context.refuse(name, message)
        }
        _ => Some(index),
    }
}

/// Returns whether one of these items has the name of another item. It may be meant to have a
/// different name.
pub(super) fn has_duplicates(items: &[RouteItem], these: impl Fn(&RouteItem) -> bool) -> bool {
    let mut names = HashMap::new();
    items.iter().filter_map(|item| Some((item, item.name()?))).any(|(item, name)| {
        let is_of_these = these(item);
        let before = names.insert(name.to_string(), is_of_these);
        before.is_some_and(|before| before || is_of_these)
    })
}

fn unknown_name(
    block: &BlockSyntax,
    name: &Ident,
    def: &ChainSyntax,
    items: &[RouteItem],
    context: &mut Context,
) {
    if block.word == BlockKeyword::Body && body::describes_type(block) {
        let message = "write the block of a body type before the route";
        context.diagnostics.error(name.span(), message);
        return;
    }
    let Some(RouteSyntax { complete: true, .. }) = def.route else { return };
    // It may be the missing name of a hinge.
    let nameless = |item: &RouteItem| {
        matches!(item, RouteItem::Hinge { name: None, .. } | RouteItem::Unknown { name: None, .. })
    };
    if items.iter().any(nameless)
        || has_duplicates(items, |item| !matches!(item, RouteItem::Body { .. }))
    {
        return;
    }
    let is_body = |item: &RouteItem| matches!(item, RouteItem::Body { word, .. } if *word == name);
    let has_type =
        def.blocks.iter().any(|other| body::is_type(other) && other.names.contains(name));
    if block.word == BlockKeyword::Body && !has_type && items.iter().any(is_body) {
        let message = "write the block of a body type before the route";
        context.diagnostics.error(name.span(), message);
        return;
    }
    let (word, items): (_, Vec<&RouteItem>) = match block.word {
        BlockKeyword::Body => {
            ("body", items.iter().filter(|item| matches!(item, RouteItem::Body { .. })).collect())
        }
        _ => {
            ("hinge", items.iter().filter(|item| !matches!(item, RouteItem::Body { .. })).collect())
        }
    };
    let hint = context.hint(name, items.iter().filter_map(|item| item.name()));
    let message = format!("no {word} `{name}` on the route{hint}");
    let names = items.iter().filter_map(|item| item.name());
    context.diagnostics.unknown(name, message, names);
}
