//! The route: a chain of bodies with hinges between them.

use proc_macro2::Span;

use super::{branch, compound};
use crate::diag::Diagnostics;
use crate::model::Drive;
use crate::model::lower::{Draft, ItemProperties, RouteItem, listed};
use crate::syntax::RepeatSyntax;

/// Returns the items if the whole route is readable and has a body, and nothing otherwise.
pub(super) fn whole_route<'d, 'a>(draft: &'d Draft<'a>) -> &'d [RouteItem<'a>] {
    let items = readable_route(draft);
    if has_body(items) { items } else { &[] }
}

fn readable_route<'d, 'a>(draft: &'d Draft<'a>) -> &'d [RouteItem<'a>] {
    match &draft.def.route {
        Some(route) if route.complete => &draft.items,
        _ => &[],
    }
}

fn has_body(items: &[RouteItem]) -> bool {
    let is_body = |item: &RouteItem| {
        matches!(
            item,
            RouteItem::Body { .. } | RouteItem::Unknown { .. } | RouteItem::Duplicate { .. }
        )
    };
    items.iter().any(is_body)
}

/// Returns the span and the description of an item for a message.
pub(super) fn called(item: &RouteItem) -> Option<(Span, String)> {
    match item {
        RouteItem::Ground { at, .. } => Some((*at, "`ground`".into())),
        RouteItem::Moving { at, name } => Some((
            *at,
            name.map_or_else(|| "`moving`".into(), |name| format!("moving end `{name}`")),
        )),
        RouteItem::Hinge { word, name, .. } => Some(match name {
            Some(name) => (name.span(), format!("hinge `{name}`")),
            None => (word.span(), format!("`{word}`")),
        }),
        RouteItem::Body { name, .. } => Some((name.span(), format!("body `{name}`"))),
        RouteItem::Unknown { .. } | RouteItem::Duplicate { .. } => None,
    }
}

/// Reports a missing route, and a route without a body.
pub(super) fn there_is_a_route_with_a_body(draft: &Draft, diagnostics: &mut Diagnostics) {
    let name = &draft.def.name;
    if draft.def.route.is_none() && draft.def.complete {
        diagnostics.error(
            name.span(),
            format!(
                "chain `{name}` has no route: write one, as in \
                                                `ground -> slider joint -> Car car;`"
            ),
        );
    }
    let items = readable_route(draft);
    if let (Some((at, _)), false) = (items.first().and_then(called), has_body(items)) {
        diagnostics.error(at, "the route has no body: add at least one");
    }
}

/// Reports further routes.
pub(super) fn there_is_one_route(draft: &Draft, diagnostics: &mut Diagnostics) {
    let Some(route) = &draft.def.route else { return };
    let ends = route.further.iter().skip(1).map(|further| further.start);
    for (further, end) in route.further.iter().zip(ends.chain([draft.items.len()])) {
        let items = &draft.items[further.start..end];
        let message = branch::of_route(&draft.items[..route.first_end()], items);
        diagnostics.error(further.at, message);
    }
}

/// Returns the repeated part that contains an item.
pub(super) fn repeat_around<'d>(draft: &'d Draft, item: usize) -> Option<&'d RepeatSyntax> {
    let mut repeats = draft.def.route.iter().flat_map(|route| &route.repeats);
    repeats.find(|repeat| repeat.items.contains(&item))
}

/// Reports `ground` and moving ends within the route.
pub(super) fn ground_is_at_the_ends(draft: &Draft, diagnostics: &mut Diagnostics) {
    let [_, middle @ .., _] = whole_route(draft) else { return };
    for (index, item) in middle.iter().enumerate() {
        let (at, word) = match item {
            RouteItem::Ground { at, .. } => (*at, "ground"),
            RouteItem::Moving { at, .. } => (*at, "moving"),
            _ => continue,
        };
        // One in a repeated part is reported there.
        if repeat_around(draft, index + 1).is_none() {
            let message = format!(
                "`{word}` can only be at an end of the route: end this chain here, and write the \
                 rest as a second chain"
            );
            diagnostics.error(at, message);
        }
    }
}

/// Reports bodies without a hinge between them, and hinges without a body between them.
pub(super) fn hinges_and_bodies_alternate(draft: &Draft, diagnostics: &mut Diagnostics) {
    let items = whole_route(draft);
    let defaults = draft.defaults();
    for (index, pair) in items.windows(2).enumerate() {
        let [first, second] = pair else { continue };
        if boundary_is_wrong(draft, index) {
            continue;
        }
        let at_start = index == 0;
        let at_end = index + 2 == items.len();
        let (Some((_, first_name)), Some((at, second_name))) = (called(first), called(second))
        else {
            continue;
        };
        let message = match (first, second) {
            (RouteItem::Hinge { .. }, RouteItem::Hinge { .. }) => {
                match hinges_in_a_row(items, index) {
                    Some(hinges) => bodies_are_missing(hinges, &defaults),
                    None => continue,
                }
            }
            (
                RouteItem::Body { body_type: Some(_), .. },
                RouteItem::Body { body_type: Some(_), .. },
            ) => {
                let [first, second] =
                    [&first_name, &second_name].map(|name| name.trim_start_matches("body "));
                format!(
                    "bodies {first} and {second} have no hinge between them: add one, such \
                         as `weld name`"
                )
            }
            (
                RouteItem::Ground { .. } | RouteItem::Moving { .. },
                RouteItem::Body { body_type: Some(_), .. },
            ) if at_start => {
                format!(
                    "{first_name} and {second_name} have no hinge between them: add one, \
                         such as `weld name`"
                )
            }
            (
                RouteItem::Body { body_type: Some(_), .. },
                RouteItem::Ground { .. } | RouteItem::Moving { .. },
            ) if at_end => {
                format!(
                    "{first_name} and {second_name} have no hinge between them: add one, \
                         such as `weld name`"
                )
            }
            _ => continue,
        };
        diagnostics.error(at, message);
    }
}

/// Returns the hinges in a row that begin at this item; `None` if it is not the first of them.
fn hinges_in_a_row<'d, 'a>(
    items: &'d [RouteItem<'a>],
    first: usize,
) -> Option<&'d [RouteItem<'a>]> {
    let is_hinge = |item: &RouteItem| matches!(item, RouteItem::Hinge { .. });
    if items[..first].last().is_some_and(is_hinge) {
        return None;
    }
    let count = items[first..].iter().take_while(|item| is_hinge(item)).count();
    Some(&items[first..first + count])
}

fn bodies_are_missing(hinges: &[RouteItem], defaults: &[Option<f64>]) -> String {
    let names = hinges.iter().filter_map(called);
    let names: Vec<String> =
        names.map(|(_, name)| name.trim_start_matches("hinge ").to_owned()).collect();
    let advice = compound::advice(hinges, defaults);
    format!("hinges {} have no body between them{advice}", listed(&names))
}

/// Returns whether a repeated part begins or ends between this item and the next one with a wrong
/// item, which another rule reports.
fn boundary_is_wrong(draft: &Draft, item: usize) -> bool {
    let begins = repeat_around(draft, item + 1).filter(|repeat| repeat.items.start == item + 1);
    let ends = repeat_around(draft, item).filter(|repeat| repeat.items.end == item + 1);
    (begins.is_some() && !matches!(draft.items[item + 1], RouteItem::Hinge { .. }))
        || (ends.is_some() && !matches!(draft.items[item], RouteItem::Body { .. }))
}

/// Reports hinges at an end of the route.
pub(super) fn hinges_connect_two_sides(draft: &Draft, diagnostics: &mut Diagnostics) {
    let items = whole_route(draft);
    let Some(last) = items.len().checked_sub(1) else { return };
    for (index, verb) in [(0, "begin"), (last, "end")] {
        let item = &items[index];
        if !matches!(item, RouteItem::Hinge { .. }) || repeat_around(draft, index).is_some() {
            continue;
        }
        let Some((at, name)) = called(item) else { continue };
        let message =
            format!("{name} connects nothing: {verb} the route with a body or with `ground`");
        diagnostics.error(at, message);
    }
}

/// Reports closed chains without a hinge that is free to move.
pub(super) fn closed_chains_can_move(draft: &Draft, diagnostics: &mut Diagnostics) {
    let is_end =
        |item: &RouteItem| matches!(item, RouteItem::Ground { .. } | RouteItem::Moving { .. });
    let [first, middle @ .., last] = whole_route(draft) else { return };
    if !(is_end(first) && is_end(last)) {
        return;
    }
    let properties = draft.properties.iter().skip(1);
    let is_rigid = |(item, properties): (&RouteItem, &ItemProperties)| match item {
        RouteItem::Body { .. } => true,
        RouteItem::Hinge { spec, .. } => {
            let motion = properties.motion.as_ref();
            spec.groups.is_empty() || motion.is_some_and(|motion| motion.drive == Drive::Prescribed)
        }
        RouteItem::Ground { .. }
        | RouteItem::Moving { .. }
        | RouteItem::Unknown { .. }
        | RouteItem::Duplicate { .. } => false,
    };
    let has_body = middle.iter().any(|item| matches!(item, RouteItem::Body { .. }));
    if let Some((at, _)) = called(last)
        && has_body
        && middle.iter().zip(properties).all(is_rigid)
    {
        let message = "the chain is held at both ends and all its hinges are welds or \
                       prescribed: add a hinge that can move, or leave one end free";
        diagnostics.error(at, message);
    }
}
