//! The definitions of parts, independent of their uses.

use proc_macro2::Ident;
use std::collections::{HashMap, HashSet};
use std::rc::Rc;

use super::substitute::Substitution;
use crate::diag::Diagnostics;
use crate::model::lower::context::Context;
use crate::model::lower::hinge::KINDS;
use crate::model::lower::parameter::UNUSED;
use crate::syntax::{
    BlockKeyword, BlockSyntax, ChainSyntax, ContentSyntax, ExprKind, ExprSyntax, PartSyntax,
    RouteItemSyntax, RouteSyntax, SpanRange, StepSyntax,
};

/// Returns the parts by name, without those that cannot be set, and reports errors in them.
pub(super) fn parts<'a>(
    def: &'a ChainSyntax,
    diagnostics: &mut Diagnostics,
) -> HashMap<String, &'a PartSyntax> {
    let mut parts: HashMap<String, &PartSyntax> = HashMap::new();
    for part in &def.parts {
        let name = part.name.to_string();
        // These are reported with the names of body types.
        let blocks = def.content.blocks.iter().filter(|block| !block.after_route);
        let is_type = blocks.flat_map(|block| &block.names).any(|path| *path.end() == part.name);
        if is_type || KINDS.iter().any(|kind| kind.word == name) {
            continue;
        }
        if parts.contains_key(&name) {
            diagnostics.name(&part.name, format!("two parts have the name `{name}`"));
            continue;
        }
        if part.after_route {
            diagnostics.error(part.name.span(), "write a `part` before the first route");
        }
        check_parameters(part, def, diagnostics);
        check_routes(part, diagnostics);
        parts.insert(name, part);
    }
    parts
}

/// Reports parameters that are named twice, or as a parameter of the chain.
fn check_parameters(part: &PartSyntax, def: &ChainSyntax, diagnostics: &mut Diagnostics) {
    for (index, parameter) in part.parameters.iter().enumerate() {
        let name = &part.name;
        if part.parameters[..index].contains(parameter) {
            let message = format!("part `{name}` has two parameters `{parameter}`");
            diagnostics.error(parameter.span(), message);
        } else if def.parameters.iter().any(|other| other.field.name == *parameter) {
            let message = format!(
                "the parameter `{parameter}` of part `{name}` hides the `param` of the chain: \
                 rename one"
            );
            diagnostics.error(parameter.span(), message);
        }
    }
}

/// Reports a part without a route, and what only routes of a chain have.
fn check_routes(part: &PartSyntax, diagnostics: &mut Diagnostics) {
    let name = &part.name;
    let Some(first) = part.content.routes.first() else {
        if part.content.complete {
            let message = format!(
                "part `{name}` has no route: write its hinges and bodies, as in \
                 `pin(z) knee -> Shank shank;`"
            );
            diagnostics.error(name.span(), message);
        }
        return;
    };
    if let Some(start) = &first.start {
        let message = format!(
            "the first route of a part begins with a hinge or a body, not at a place: remove \
             `{start} ->`"
        );
        diagnostics.error_over(start.extent(), message);
    }
    for item in part.content.routes.iter().flat_map(RouteSyntax::items) {
        let (at, word, example) = match item {
            RouteItemSyntax::Ground { at, .. } => (at, "ground", "ground"),
            RouteItemSyntax::Moving { at, .. } => (at, "moving", "moving hand"),
            _ => continue,
        };
        let message = format!("`{word}` is written outside of parts: `{example} -> {name} name`");
        diagnostics.error(*at, message);
    }
}

/// Returns whether every word on a route means what its author intended: no part lacks its route or has the name of a
/// type, and neither a part nor a type has that of a kind of hinge. All of these are reported.
pub(super) fn words_are_clear(def: &ChainSyntax, parts: &HashMap<String, &PartSyntax>) -> bool {
    let can_be_set = |part: &PartSyntax| {
        let part = parts.get(&part.name.to_string());
        part.is_some_and(|part| !part.content.routes.is_empty())
    };
    let contents = def.parts.iter().map(|part| &part.content).chain([&def.content]);
    let blocks = contents.flat_map(|content| &content.blocks);
    let is_type = |block: &&BlockSyntax| block.word == BlockKeyword::Body && !block.after_route;
    let mut types = blocks.filter(is_type).flat_map(|block| &block.names);
    let is_kind = |name: &Ident| KINDS.iter().any(|kind| name == kind.word);
    def.parts.iter().all(can_be_set) && !types.any(|path| is_kind(path.end()))
}

/// Returns the names of the parts that are never set on a route.
pub(super) fn unused<'a>(
    def: &'a ChainSyntax,
    parts: &HashMap<String, &'a PartSyntax>,
) -> Vec<&'a Ident> {
    let used = used_parts(def, parts);
    let is_unused = |part: &&PartSyntax| {
        let name = part.name.to_string();
        parts.contains_key(&name) && !used.contains(&name)
    };
    def.parts.iter().filter(is_unused).map(|part| &part.name).collect()
}

/// Warns of parameters that a part does not use, if everything else is readable. A name that begins
/// with `_` may be unused, as in Rust.
pub(in crate::model::lower) fn warn_of_unused(def: &ChainSyntax, context: &mut Context) {
    if !context.diagnostics.is_empty() || !context.complete {
        return;
    }
    for part in &def.parts {
        let unused = part.parameters.iter().filter(|parameter| !uses(part, parameter));
        for parameter in unused.filter(|parameter| !parameter.to_string().starts_with('_')) {
            let message = format!(
                "part `{}` does not use its parameter `{parameter}`: remove it, or write \
                 `_{parameter}`",
                part.name
            );
            context.diagnostics.warn(parameter.span(), UNUSED, message);
        }
    }
}

/// Returns whether the content of a part uses a parameter.
fn uses(part: &PartSyntax, parameter: &Ident) -> bool {
    let any = ExprSyntax { kind: ExprKind::Lost, extent: SpanRange::from(parameter) };
    let arguments = HashMap::from([(parameter.to_string(), Rc::new(any))]);
    let replaced = Substitution { arguments, instance: None };
    let ContentSyntax { blocks, routes, .. } = &part.content;
    blocks.iter().any(|block| replaced.block(block).is_some())
        || routes.iter().flat_map(RouteSyntax::items).any(|item| replaced.item(item).is_some())
}

/// Returns the names of all parts that are set by the chain or by another part.
fn used_parts(def: &ChainSyntax, parts: &HashMap<String, &PartSyntax>) -> HashSet<String> {
    let of_parts = parts.iter().flat_map(|(name, part)| {
        let names = set_parts(&part.content);
        names.into_iter().filter(move |other| other != name)
    });
    of_parts.chain(set_parts(&def.content)).collect()
}

/// Returns the words of all items that may be parts.
fn set_parts(content: &ContentSyntax) -> Vec<String> {
    let items = content.routes.iter().flat_map(RouteSyntax::items);
    let words = items.filter_map(|item| match item {
        RouteItemSyntax::Element { word, .. } => Some(word.to_string()),
        _ => None,
    });
    words.collect()
}

/// Returns whether a part has a repeated part, itself or through a part in it.
pub(super) fn has_repeat(part: &PartSyntax, parts: &HashMap<String, &PartSyntax>) -> bool {
    let mut seen: HashSet<String> = HashSet::new();
    let mut open = vec![part];
    while let Some(part) = open.pop() {
        let routes = &part.content.routes;
        if routes
            .iter()
            .flat_map(|route| &route.steps)
            .any(|step| matches!(step, StepSyntax::Repeat(_)))
        {
            return true;
        }
        let inner = set_parts(&part.content).into_iter().filter(|name| seen.insert(name.clone()));
        open.extend(inner.filter_map(|name| parts.get(&name).copied()));
    }
    false
}
