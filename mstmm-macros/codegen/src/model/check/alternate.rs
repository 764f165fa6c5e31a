//! Hinges and bodies alternate on a route.

use proc_macro2::Span;

use super::compound;
use super::route::{RouteView, called, instance_in, readable_routes, token_in};
use crate::diag::Diagnostics;
use crate::model::lower::{Draft, ItemName, RouteItem, listed};

/// Reports bodies without a hinge between them, and hinges without a body between them.
pub(super) fn hinges_and_bodies_alternate(draft: &Draft, diagnostics: &mut Diagnostics) {
    let defaults = draft.defaults();
    for route in readable_routes(draft) {
        let items: Vec<&RouteItem> = route.items().collect();
        for position in 0..items.len().saturating_sub(1) {
            if route.boundary_is_wrong(position) {
                continue;
            }
            let message = pair_message(&items, position, &defaults);
            if let Some((at, message)) = message {
                let (at, message) = at_part(draft, route, position).unwrap_or((at, message));
                diagnostics.error(at, message);
            }
        }
        check_start(draft, route, diagnostics);
    }
}

/// Reports a body after the place at which a route begins.
fn check_start(draft: &Draft, route: RouteView, diagnostics: &mut Diagnostics) {
    let (Some(start), Some(&first)) = (&route.route.syntax.start, route.route.items.first()) else {
        return;
    };
    let body = &draft.items[first];
    if let RouteItem::Body { body_type: Some(_), .. } = body
        && let Some((_, name)) = called(body)
        && let Some(at) = token_in(draft, route.route.scope, first)
    {
        let message = format!(
            "`{start}` and {name} have no hinge between them: add one, such as `weld name`"
        );
        diagnostics.error(at, message);
    }
}

/// Returns the span and the message if two items in a row are wrong, and the second one begins a part or the first one
/// ends one.
fn at_part(draft: &Draft, route: RouteView, position: usize) -> Option<(Span, String)> {
    let items = &route.route.items;
    let (first, second) = (items[position], items[position + 1]);
    let outer = common_scope(draft, first, second);
    let at = token_in(draft, outer, second)?;
    let shown = |item: usize| {
        let what = if draft.items[item].is_hinge() { "hinge" } else { "body" };
        let own = draft.items[item].name().map_or("ground", ItemName::own);
        format!("{what} `{own}`")
    };
    let part = |item: usize| {
        let instance = instance_in(draft, outer, item)?;
        Some(&draft.written.scopes[instance].part?.name)
    };
    let is_hinge = draft.items[first].is_hinge();
    let (first_shown, second_shown) = (shown(first), shown(second));
    let message = match (part(first), part(second)) {
        (None, None) => return None,
        (Some(before), Some(after)) => format!(
            "`{before}` ends with {first_shown} and `{after}` begins with {second_shown}: write a \
             {} between them",
            if is_hinge { "body" } else { "hinge" }
        ),
        (None, Some(after)) if is_hinge => {
            format!("`{after}` begins with {second_shown}: remove {first_shown} before it")
        }
        (Some(before), None) if is_hinge => {
            format!("`{before}` ends with {first_shown}: remove {second_shown} after it")
        }
        (None, Some(after)) => format!(
            "`{after}` begins with {second_shown}: add a hinge before it, such as `weld name`"
        ),
        (Some(before), None) => {
            format!("`{before}` ends with {first_shown}: add a hinge after it, such as `weld name`")
        }
    };
    Some((at, message))
}

/// Returns the innermost scope that contains both items.
fn common_scope(draft: &Draft, first: usize, second: usize) -> usize {
    let scopes = &draft.written.scopes;
    let (mut a, mut b) = (draft.written.items[first].scope, draft.written.items[second].scope);
    while a != b {
        if scopes[a].depth() > scopes[b].depth() {
            a = scopes[a].parent;
        } else {
            b = scopes[b].parent;
        }
    }
    a
}

/// Returns the span and the message if two items in a row are wrong.
fn pair_message(
    items: &[&RouteItem],
    position: usize,
    defaults: &[Option<f64>],
) -> Option<(Span, String)> {
    let (first, second) = (items[position], items[position + 1]);
    let ((_, first_name), (at, second_name)) = (called(first)?, called(second)?);
    let is_known_body =
        |item: &RouteItem| matches!(item, RouteItem::Body { body_type: Some(_), .. });
    if first.is_hinge() && second.is_hinge() {
        let hinges = hinges_in_a_row(items, position)?;
        return Some((at, bodies_are_missing(hinges, defaults)));
    }
    let (at_start, at_end) = (position == 0, position + 2 == items.len());
    let names = if is_known_body(first) && is_known_body(second) {
        let [first, second] =
            [&first_name, &second_name].map(|name| name.trim_start_matches("body "));
        format!("bodies {first} and {second}")
    } else if (first.is_end() && is_known_body(second) && at_start)
        || (is_known_body(first) && second.is_end() && at_end)
    {
        format!("{first_name} and {second_name}")
    } else {
        return None;
    };
    Some((at, format!("{names} have no hinge between them: add one, such as `weld name`")))
}

/// Returns the hinges in a row that begin at this position; `None` if it is not the first of them.
fn hinges_in_a_row<'i, 'd, 'a>(
    items: &'i [&'d RouteItem<'a>],
    first: usize,
) -> Option<&'i [&'d RouteItem<'a>]> {
    if items[..first].last().is_some_and(|item| item.is_hinge()) {
        return None;
    }
    let count = items[first..].iter().take_while(|item| item.is_hinge()).count();
    Some(&items[first..first + count])
}

fn bodies_are_missing(hinges: &[&RouteItem], defaults: &[Option<f64>]) -> String {
    let names = hinges.iter().filter_map(|hinge| called(hinge));
    let names: Vec<String> =
        names.map(|(_, name)| name.trim_start_matches("hinge ").to_owned()).collect();
    let advice = compound::advice(hinges, defaults);
    format!("hinges {} have no body between them{advice}", listed(&names))
}
