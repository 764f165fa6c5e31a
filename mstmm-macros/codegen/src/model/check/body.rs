//! Bodies.

use super::route::whole_route;
use crate::diag::Diagnostics;
use crate::model::condition::Requirement;
use crate::model::lower::{Draft, POINTS, RouteItem, listed};
use crate::model::rules::MASS;

/// Reports body types that the route does not use: most likely an error in the route.
pub(super) fn types_are_used(draft: &Draft, diagnostics: &mut Diagnostics) {
    let lost = |item: &RouteItem| {
        matches!(
            item,
            RouteItem::Unknown { .. }
                | RouteItem::Duplicate { .. }
                | RouteItem::Body { body_type: None, .. }
        )
    };
    let items = whole_route(draft);
    if items.is_empty() || items.iter().any(lost) {
        return;
    }
    for body in &draft.types {
        let uses =
            |item: &RouteItem| matches!(item, RouteItem::Body { word, .. } if *word == body.name);
        if !draft.items.iter().any(uses) {
            let message = format!(
                "type `{}` is not used on the route: add a body of this type, \
                                   or remove the block",
                body.name
            );
            diagnostics.error(body.name.span(), message);
        }
    }
}

/// Reports missing fields: a body type has a mass, a centre of mass and an inertia, and an
/// output if a hinge follows it.
pub(super) fn fields_are_given(draft: &Draft, diagnostics: &mut Diagnostics) {
    // A hinge at the end, which is an error, needs no output.
    let is_hinge = |item: &RouteItem| matches!(item, RouteItem::Hinge { .. });
    let joined = draft.items.iter().rposition(|item| !is_hinge(item)).map_or(0, |last| last + 1);
    let (last, items) = match draft.items[..joined].split_last() {
        Some((last, items)) => (Some(last), items),
        None => (None, &draft.items[..]),
    };
    let last_is_followed = draft.def.route.iter().flat_map(|route| &route.repeats).any(|repeat| {
        // The next repetition follows, except after the last one.
        repeat.count.is_some_and(|count| count > 1) && repeat.items.end >= joined
    });
    // If the route has errors, it is unknown which bodies a hinge follows.
    let is_again = |item: &RouteItem| matches!(item, RouteItem::Duplicate { .. });
    let is_whole = draft.def.route.as_ref().is_some_and(|route| route.complete)
        && !draft.items.iter().any(is_again);
    for (index, body) in draft.types.iter().enumerate() {
        let is_it = |item: &RouteItem| matches!(item, RouteItem::Body { body_type, .. } if *body_type == Some(index));
        let is_followed = items.iter().any(is_it) || (last_is_followed && last.is_some_and(is_it));
        let missing: Vec<_> =
            body.missing(is_followed && is_whole).iter().map(|name| format!("`{name}`")).collect();
        if !missing.is_empty() {
            let message = format!("body `{}` needs {}", body.name, listed(&missing));
            diagnostics.error(body.name.span(), message);
        }
    }
}

/// Methods of the results at a body, which are no names for points.
const RESERVED: &[&str] = &["clone"];

/// Reports points with the name of another point of the type, or of a point that every body has.
pub(super) fn points_are_named_once(draft: &Draft, diagnostics: &mut Diagnostics) {
    for body in &draft.types {
        for (index, point) in body.points.iter().enumerate() {
            let name = point.name;
            let message = if POINTS.iter().any(|known| name == known) {
                format!("every body has a point `{name}` already: choose another name")
            } else if RESERVED.iter().any(|known| name == known) {
                format!("`{name}` is a method of the results at every body and cannot be a name")
            } else if body.points[..index].iter().any(|other| other.name == name) {
                format!("body `{}` has two points `{name}`", body.name)
            } else {
                continue;
            };
            diagnostics.name(name, message);
        }
    }
}

/// Requires positive masses.
pub(super) fn masses_are_positive(draft: &Draft) -> Vec<Requirement> {
    let masses = draft.types.iter().filter_map(|body| body.mass.as_ref());
    masses.map(|mass| vec![MASS.condition(mass.value.clone(), mass.at)]).collect()
}
