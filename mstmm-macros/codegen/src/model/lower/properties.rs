//! Properties of hinges and bodies from the blocks after the route.

use proc_macro2::Ident;

use super::body;
use super::context::Context;
use super::fields::{FieldOwner, Fields};
use super::hinge::{self, HingeProperties, motion, of_everything};
use super::parts::{WrittenBlock, WrittenOut};
use super::place::Resolved;
use super::route_item::RouteItem;
use crate::diag::did_you_mean;
use crate::syntax::{BlockKeyword, BlockSyntax, PathSyntax};

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
    resolved: Resolved<'_, 'a>,
    context: &mut Context,
) -> Vec<ItemProperties<'a>> {
    let Resolved { written, items, .. } = resolved;
    let mut fields = vec![Fields::default(); items.len()];
    // The fields of blocks that name no item.
    let mut lost = Vec::new();
    let mut blocks: Vec<&'a WrittenBlock> =
        written.blocks.iter().filter(|block| !body::is_type(&block.syntax)).collect();
    // Blocks in a part come first, so that the error is outside if a field is given twice.
    blocks.sort_by_key(|block| std::cmp::Reverse(written.scopes[block.scope].depth()));
    for written_block in blocks {
        let block = &*written_block.syntax;
        if block.word != BlockKeyword::Body {
            refuse_points(block, context);
        }
        if !matches!(block.word, BlockKeyword::Body | BlockKeyword::Hinge) {
            continue;
        }
        if !block.after_route && !written.routes.is_empty() {
            context.diagnostics.error(block.at, "write the block of a hinge after the route");
        }
        if !assign(written_block, resolved, &mut fields, context) {
            lost.extend(block.fields.iter().map(|field| &field.name));
        }
    }
    for fields in &mut fields {
        fields.may_have(&lost);
        if !written.complete {
            fields.refuse();
        }
    }
    let floats = floats(written, items);
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

/// Returns whether the chain has a floating base: its first route begins and ends with a body.
pub(super) fn floats(written: &WrittenOut, items: &[RouteItem]) -> bool {
    let Some(route) = written.routes.first().filter(|route| route.syntax.start.is_none()) else {
        return false;
    };
    let is_body = |index: Option<&usize>| index.is_some_and(|&index| items[index].is_body());
    is_body(route.items.first()) && is_body(route.items.last())
}

/// Assigns the fields of a block to the items that it names. Returns whether it names items only.
fn assign<'a>(
    written_block: &'a WrittenBlock,
    resolved: Resolved<'_, 'a>,
    fields: &mut [Fields<'a>],
    context: &mut Context,
) -> bool {
    let block = &*written_block.syntax;
    let mut names_items = true;
    let part = resolved.written.scopes[written_block.scope].part.map(|part| &part.name);
    let kinds = kinds(written_block, resolved);
    // A field that is wrong for one hinge is not reported again for the next one.
    let mut refused = Vec::new();
    for (position, path) in block.names.iter().enumerate() {
        if block.names[..position].iter().any(|earlier| earlier.names == path.names) {
            let message = format!("`{path}` is in this block twice: remove one");
            context.diagnostics.error_over(path.extent(), message);
            continue;
        }
        let Some(index) = target(written_block, path, resolved, context) else {
            names_items = false;
            continue;
        };
        if block.word == BlockKeyword::Body {
            refuse_points(block, context);
        }
        let (known, owner) = match &resolved.items[index] {
            RouteItem::Hinge { kind, spec, .. } => (hinge::fields(spec), kind.name.to_owned()),
            RouteItem::Body { .. } => {
                let implied = of_everything(context.space).spec();
                (hinge::start_fields(implied), format!("body `{path}`"))
            }
            _ => continue,
        };
        let fields = &mut fields[index];
        if !block.complete {
            fields.refuse();
        }
        for (at, field) in block.fields.iter().enumerate() {
            let given = &block.fields;
            let owner = FieldOwner { name: &owner, path: Some(path), part, given, others: &kinds };
            if refused.contains(&at) {
                fields.refuse();
            } else if fields.add(field, &known, &owner, context).is_none() {
                refused.push(at);
            }
        }
    }
    names_items
}

/// Returns the kinds of the hinges that a block names, each with its fields.
fn kinds(
    written_block: &WrittenBlock,
    resolved: Resolved,
) -> Vec<(&'static str, Vec<&'static str>)> {
    let Resolved { written, items, names, .. } = resolved;
    let paths = written_block.syntax.names.iter();
    let named = paths.filter_map(|path| names.item(written, written_block.scope, &path.names));
    let kind = |item: usize| match &items[item] {
        RouteItem::Hinge { kind, spec, .. } => Some((kind.name, hinge::fields(spec))),
        _ => None,
    };
    named.filter_map(kind).collect()
}

/// Returns the item of a path in a block; `None` if no item of this path can have a block.
fn target(
    written_block: &WrittenBlock,
    path: &PathSyntax,
    resolved: Resolved,
    context: &mut Context,
) -> Option<usize> {
    let Resolved { written, items, names, .. } = resolved;
    let block = &*written_block.syntax;
    let Some(index) = names.item(written, written_block.scope, &path.names) else {
        unknown_name(written_block, path, resolved, context);
        return None;
    };
    let at = path.extent();
    match (block.word, &items[index]) {
        (BlockKeyword::Body, RouteItem::Hinge { .. }) => {
            context.refuse(at, format!("`{path}` is a hinge: write `hinge {path} {{ … }}`"))
        }
        (_, RouteItem::Moving { .. }) => {
            let message =
                format!("`{path}` is a moving end and has no properties: its motion is an input");
            context.refuse(at, message)
        }
        // It may be a hinge whose kind is not known.
        (BlockKeyword::Hinge, RouteItem::Body { body_type: None, .. }) => None,
        (BlockKeyword::Hinge, RouteItem::Body { .. }) => {
            let floats = index == 0 && floats(written, items);
            let before = index.checked_sub(1).map(|before| &items[before]);
            let message = match before {
                _ if floats => format!("`{path}` is a body: write `body {path} {{ … }}`"),
                Some(RouteItem::Hinge { name: Some(hinge), .. }) => {
                    let prefix = written.scopes[written_block.scope].prefix();
                    let hinge = hinge.path.strip_prefix(prefix).unwrap_or(&hinge.path);
                    format!("`{path}` is a body: write the name of its hinge, `{hinge}`")
                }
                _ => format!("`{path}` is a body: write the name of a hinge"),
            };
            context.refuse(at, message)
        }
        (BlockKeyword::Body, RouteItem::Body { word, .. })
            if index > 0 || !floats(written, items) =>
        {
            // If the route has an error, this rule may be wrong.
            if !written.routes_are_complete {
                return None;
            }
            context.refuse(at, no_block_of_body(path, word, block))
        }
        (BlockKeyword::Body, RouteItem::Body { name, .. }) if written_block.scope > 0 => {
            let message = format!(
                "write the start of a floating body outside of parts: `body {name} {{ … }}`"
            );
            context.refuse(at, message)
        }
        _ => Some(index),
    }
}

/// The message for a block after the route of a body whose start is that of its hinge.
fn no_block_of_body(path: &PathSyntax, body_type: &Ident, block: &BlockSyntax) -> String {
    if body::describes_type(block) {
        return format!(
            "`{path}` is a body of type `{body_type}`: write what describes the type in \
             `body {body_type} {{ … }}`, before the route"
        );
    }
    format!("`{path}` has no start: only the first body of a floating chain has one")
}

fn unknown_name(
    written_block: &WrittenBlock,
    path: &PathSyntax,
    resolved: Resolved,
    context: &mut Context,
) {
    let Resolved { written, items, .. } = resolved;
    let (block, scope, name) = (&*written_block.syntax, written_block.scope, path.end());
    if block.word == BlockKeyword::Body && body::describes_type(block) {
        let message = "write the block of a body type before the route";
        context.diagnostics.error(name.span(), message);
        return;
    }
    let is_lost = resolved.may_be_in_lost_part(scope, &path.names);
    if !written.routes_are_complete || written.routes.is_empty() || is_lost {
        return;
    }
    // It may be the missing name of a hinge.
    let nameless = |item: &RouteItem| {
        matches!(item, RouteItem::Hinge { name: None, .. } | RouteItem::Unknown { name: None, .. })
    };
    if items.iter().any(nameless) || resolved.names.duplicates().other {
        return;
    }
    let is_body = |item: &RouteItem| matches!(item, RouteItem::Body { word, .. } if *word == name);
    let has_type = resolved.types.find(scope, name).is_some();
    if block.word == BlockKeyword::Body && !has_type && items.iter().any(is_body) {
        let message = "write the block of a body type before the route";
        context.diagnostics.error(name.span(), message);
        return;
    }
    let wants_body = block.word == BlockKeyword::Body;
    let word = if wants_body { "body" } else { "hinge" };
    if resolved.names.instance(written, scope, &path.names).is_some() {
        let message = format!("`{path}` is a part: name a {word} in it, as in `{path}.name`");
        return context.diagnostics.error_over(path.extent(), message);
    }
    let prefix = written.scopes[scope].prefix();
    let names = items.iter().filter(|item| item.is_body() == wants_body);
    let hint = if context.diagnostics.is_full() {
        String::new()
    } else {
        let paths: Vec<&str> =
            names.filter_map(|item| item.name()?.path.strip_prefix(prefix)).collect();
        let hint = did_you_mean(&path.to_string(), paths.iter().copied());
        let own = name.to_string();
        let same = paths.iter().find(|path| path.rsplit('.').next() == Some(&*own));
        match same {
            Some(same) if hint.is_empty() => format!("; did you mean `{same}`?"),
            _ => hint,
        }
    };
    let message = format!("no {word} `{path}` on a route{hint}");
    if path.names.len() > 1 {
        return context.diagnostics.error_over(path.extent(), message);
    }
    let names = items.iter().filter(|item| item.is_body() == wants_body);
    let names = names.filter_map(|item| Some(&item.name()?.joined));
    context.diagnostics.unknown(name, message, names);
}
