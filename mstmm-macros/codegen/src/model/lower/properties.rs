//! What is said behind the route of the hinges and bodies on it.

use proc_macro2::Ident;

use super::body;
use super::context::Context;
use super::fields::Fields;
use super::hinge::{FLOATING_FIELDS, Motion, floating_motion};
use super::route::Stop;
use crate::diag::did_you_mean;
use crate::syntax::{Block, BlockWord, ChainDef, Route};

/// How the hinges move at first, one for each stop: of a hinge its own, of the first body of a
/// floating chain that of the implied hinge.
pub(super) fn motions(
    def: &ChainDef,
    stops: &[Stop],
    context: &mut Context,
) -> Vec<Option<Motion>> {
    let mut fields = vec![Fields::default(); stops.len()];
    for block in def.blocks.iter().filter(|block| !body::is_type(block)) {
        if !block.after_route && def.route.is_some() {
            context.diagnostics.error(block.at, "hinges are described after the route");
        }
        assign(block, def, stops, &mut fields, context);
    }
    let floats = floats(stops);
    let motion = |(index, (stop, fields)): (usize, (&Stop, &Fields))| match stop {
        Stop::Hinge { kind, .. } => (kind.motion)(fields, context),
        Stop::Body { .. } if index == 0 && floats => floating_motion(fields, context),
        _ => None,
    };
    stops.iter().zip(&fields).enumerate().map(motion).collect()
}

/// Whether no end of the chain is held.
pub(super) fn floats(stops: &[Stop]) -> bool {
    matches!(stops, [Stop::Body { .. }, .., Stop::Body { .. }] | [Stop::Body { .. }])
}

/// Hands the fields of a block to the stops that it names.
fn assign<'a>(
    block: &'a Block,
    def: &ChainDef,
    stops: &[Stop],
    fields: &mut [Fields<'a>],
    context: &mut Context,
) {
    // A field that is wrong for one hinge is not reported for the next one again.
    let mut refused = Vec::new();
    for name in &block.names {
        let Some(index) = target(block, name, def, stops, context) else { continue };
        let (known, owner) = match &stops[index] {
            Stop::Hinge { kind, .. } => (kind.fields, kind.name.to_owned()),
            Stop::Body { .. } => (FLOATING_FIELDS, format!("body `{name}`")),
            _ => continue,
        };
        for (at, field) in block.fields.iter().enumerate() {
            let accepted =
                refused.contains(&at) || fields[index].add(field, known, &owner, context).is_some();
            if !accepted {
                refused.push(at);
            }
        }
    }
}

/// The stop that a block means by a name; nothing where there is none to say something of.
fn target(
    block: &Block,
    name: &Ident,
    def: &ChainDef,
    stops: &[Stop],
    context: &mut Context,
) -> Option<usize> {
    let Some(index) = stops.iter().position(|stop| stop.name() == Some(name)) else {
        unknown_name(block, name, def, stops, context);
        return None;
    };
    match (block.word, &stops[index]) {
        (BlockWord::Body, Stop::Hinge { .. }) => {
            context.refuse(name, format!("`{name}` is a hinge: `hinge {name} {{ … }}`"))
        }
        (BlockWord::Hinge, Stop::Body { .. }) => {
            context.refuse(name, format!("`{name}` is a body: `body {name} {{ … }}`"))
        }
        (BlockWord::Body, Stop::Body { .. }) if index > 0 || !floats(stops) => {
            // Where the route has a mistake, so has this verdict.
            if !def.route.as_ref().is_some_and(|route| route.whole) {
                return None;
            }
            let message = format!(
                "nothing can be said of `{name}`: \
                 only the first body of a floating chain has a start"
            );
            context.refuse(name, message)
        }
        _ => Some(index),
    }
}

fn unknown_name(
    block: &Block,
    name: &Ident,
    def: &ChainDef,
    stops: &[Stop],
    context: &mut Context,
) {
    let Some(Route { whole: true, .. }) = def.route else { return };
    // It may be the name that a hinge on the route lacks.
    let nameless =
        |stop: &Stop| matches!(stop, Stop::Hinge { name: None, .. } | Stop::Unknown { name: None });
    if stops.iter().any(nameless) {
        return;
    }
    let is_body = |stop: &Stop| matches!(stop, Stop::Body { word, .. } if *word == name);
    let has_type =
        def.blocks.iter().any(|other| body::is_type(other) && other.names.contains(name));
    if block.word == BlockWord::Body && !has_type && stops.iter().any(is_body) {
        let message = "a type of body is described before the route";
        context.diagnostics.error(name.span(), message);
        return;
    }
    let (word, stops): (_, Vec<&Stop>) = match block.word {
        BlockWord::Body => {
            ("body", stops.iter().filter(|stop| matches!(stop, Stop::Body { .. })).collect())
        }
        BlockWord::Hinge => {
            ("hinge", stops.iter().filter(|stop| !matches!(stop, Stop::Body { .. })).collect())
        }
    };
    let known: Vec<String> =
        stops.iter().filter_map(|stop| stop.name()).map(ToString::to_string).collect();
    let hint = did_you_mean(&name.to_string(), known.iter().map(String::as_str));
    context.diagnostics.error(name.span(), format!("no {word} `{name}` on the route{hint}"));
}
