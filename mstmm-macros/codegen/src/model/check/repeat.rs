//! Parts of routes that are repeated.

use super::route::{RouteView, called, readable_routes};
use crate::diag::Diagnostics;
use crate::model::lower::{Draft, RouteItem, WrittenRepeat};
use crate::syntax::RepeatSyntax;

/// Returns the repeated parts if all routes are readable.
fn repeats<'a>(draft: &Draft<'a>) -> impl Iterator<Item = &'a WrittenRepeat<'a>> {
    let is_readable = readable_routes(draft).next().is_some();
    draft.written.repeats.iter().filter(move |_| is_readable)
}

/// Returns the items of the first route of a repeated part.
fn first_route<'d, 'a>(
    draft: &'d Draft<'a>,
    repeat: &WrittenRepeat,
) -> impl DoubleEndedIterator<Item = &'d RouteItem<'a>> {
    let route = &draft.written.routes[repeat.route];
    route.items[repeat.on_route.clone()].iter().map(|&item| &draft.items[item])
}

/// Reports a repeated part at the beginning of a route: its first hinge needs an inboard body.
pub(super) fn repeats_follow_something(draft: &Draft, diagnostics: &mut Diagnostics) {
    for repeat in repeats(draft) {
        let route = &draft.written.routes[repeat.route];
        if repeat.on_route.start == 0 && route.syntax.start.is_none() {
            let message = "a route cannot begin with `repeat`: \
                           begin it with a body, with `ground` or with `moving`";
            diagnostics.error(repeat.syntax.at, message);
        }
    }
}

/// Reports repeated parts that do not begin with a hinge or do not end with a body.
pub(super) fn repeats_begin_with_a_hinge_and_end_with_a_body(
    draft: &Draft,
    diagnostics: &mut Diagnostics,
) {
    for repeat in repeats(draft) {
        let mut items = first_route(draft, repeat);
        let (first, last) = (items.next(), first_route(draft, repeat).next_back());
        let wrong = [
            (
                first.filter(|item| matches!(item, RouteItem::Body { body_type: Some(_), .. })),
                "begins with a hinge",
            ),
            (last.filter(|item| item.is_hinge()), "ends with a body"),
        ];
        // Both are one error.
        let mut wrong =
            wrong.into_iter().filter_map(|(item, verdict)| Some((called(item?)?, verdict)));
        if let Some(((at, name), verdict)) = wrong.next() {
            let example = RepeatSyntax::EXAMPLE;
            let message = format!("`repeat` {verdict}, not with {name}: {example}");
            diagnostics.error(at, message);
        }
    }
}

/// Reports ends of the chain in a repeated part.
pub(super) fn repeats_contain_no_ends(draft: &Draft, diagnostics: &mut Diagnostics) {
    for item in repeats(draft).flat_map(|repeat| &draft.items[repeat.items.clone()]) {
        let (at, word) = match item {
            RouteItem::Ground { at, .. } => (*at, "ground"),
            RouteItem::Moving { at, .. } => (*at, "moving"),
            _ => continue,
        };
        let message = format!("`{word}` cannot be in a `repeat`: it is an end of the route");
        diagnostics.error(at, message);
    }
}

/// Reports repeated parts in a chain that is held at its end only: repetitions are evaluated from
/// the held or floating start.
pub(super) fn repeats_follow_the_held_end(draft: &Draft, diagnostics: &mut Diagnostics) {
    let Some(first) = readable_routes(draft).next() else { return };
    let is_reversed = first.items().next().is_some_and(RouteItem::is_body)
        && first.items().next_back().is_some_and(RouteItem::is_end);
    if !is_reversed {
        return;
    }
    let on_first = |repeat: &&WrittenRepeat| {
        // An end inside a repeated part is reported there.
        repeat.route == RouteView::FIRST && repeat.on_route.end < first.len()
    };
    for repeat in repeats(draft).filter(on_first) {
        let message = "a chain with `repeat` must begin at the end that is held: reverse the \
                       route";
        diagnostics.error(repeat.syntax.at, message);
    }
}
