//! Parts of the route that are repeated.

use super::route::{called, whole_route};
use crate::diag::Diagnostics;
use crate::model::lower::{Draft, RouteItem};
use crate::syntax::RepeatSyntax;

/// Returns the readable repeated parts of the route, each with its items.
fn repeats<'d, 'a>(
    draft: &'d Draft<'a>,
) -> impl Iterator<Item = (&'d RepeatSyntax, &'d [RouteItem<'a>])> {
    let items = whole_route(draft);
    let repeats = draft.def.route.iter().flat_map(|route| &route.repeats);
    repeats.filter_map(|repeat| Some((repeat, items.get(repeat.items.clone())?)))
}

/// Reports a repeated part at the beginning of a route: its first hinge needs an inboard body.
pub(super) fn repeats_follow_something(draft: &Draft, diagnostics: &mut Diagnostics) {
    for (repeat, _) in repeats(draft) {
        if repeat.items.start == 0 {
            let message = "a route cannot begin with `repeat`: \
                           begin it with a body, with `ground` or with `moving`";
            diagnostics.error(repeat.at, message);
        }
    }
}

/// Reports repeated parts that do not begin with a hinge or do not end with a body.
pub(super) fn repeats_begin_with_a_hinge_and_end_with_a_body(
    draft: &Draft,
    diagnostics: &mut Diagnostics,
) {
    for (_, items) in repeats(draft) {
        let (first, last) = (items.first(), items.last());
        let wrong = [
            (
                first.filter(|item| matches!(item, RouteItem::Body { body_type: Some(_), .. })),
                "begins with a hinge",
            ),
            (last.filter(|item| matches!(item, RouteItem::Hinge { .. })), "ends with a body"),
        ];
        for (item, verdict) in wrong {
            if let Some((at, name)) = item.and_then(called) {
                let example = RepeatSyntax::EXAMPLE;
                let message = format!("`repeat` {verdict}, not with {name}: {example}");
                diagnostics.error(at, message);
            }
        }
    }
}

/// Reports ends of the chain in a repeated part.
pub(super) fn repeats_contain_no_ends(draft: &Draft, diagnostics: &mut Diagnostics) {
    for item in repeats(draft).flat_map(|(_, items)| items) {
        let (at, word) = match item {
            RouteItem::Ground { at, .. } => (*at, "ground"),
            RouteItem::Moving { at, .. } => (*at, "moving"),
            _ => continue,
        };
        diagnostics.error(
            at,
            format!(
                "`{word}` cannot be in a `repeat`: it is an end of the \
                                       route"
            ),
        );
    }
}

/// Reports repeated parts in a chain that is held at its end only: repetitions are evaluated from
/// the held or floating start.
pub(super) fn repeats_follow_the_held_end(draft: &Draft, diagnostics: &mut Diagnostics) {
    let items = whole_route(draft);
    let [RouteItem::Body { .. }, .., RouteItem::Ground { .. } | RouteItem::Moving { .. }] = items
    else {
        return;
    };
    // An end inside a repeated part is reported there.
    for (repeat, _) in repeats(draft).filter(|(repeat, _)| repeat.items.end < items.len()) {
        let message = "a chain with `repeat` must begin at the end that is held: reverse the \
                       route";
        diagnostics.error(repeat.at, message);
    }
}
