//! Bodies.

use super::route::readable_routes;
use crate::diag::Diagnostics;
use crate::model::condition::Requirement;
use crate::model::lower::{Draft, POINTS, PlacePoint, RouteItem, RouteStart, listed};
use crate::model::rules::MASS;

/// Reports body types and parts that no route uses: most likely an error in a route.
pub(super) fn types_and_parts_are_used(draft: &Draft, diagnostics: &mut Diagnostics) {
    let is_lost = |item: &RouteItem| {
        matches!(
            item,
            RouteItem::Unknown { .. }
                | RouteItem::Duplicate { .. }
                | RouteItem::Body { body_type: None, .. }
        )
    };
    if readable_routes(draft).next().is_none() || draft.items.iter().any(is_lost) {
        return;
    }
    for part in &draft.written.unused_parts {
        diagnostics.error(part.span(), format!("part `{part}` is never set on a route"));
    }
    let mut is_used = vec![false; draft.types.all.len()];
    for item in &draft.items {
        if let RouteItem::Body { body_type: Some(index), .. } = item {
            is_used[*index] = true;
        }
    }
    for (body, is_used) in draft.types.all.iter().zip(is_used) {
        if !is_used {
            let message = format!(
                "type `{}` is not used on the route: add a body of this type, or remove the block",
                body.name
            );
            diagnostics.error(body.name.span(), message);
        }
    }
}

/// Reports missing fields: a body type has a mass, a centre of mass and an inertia, and an
/// output if a hinge leaves it.
pub(super) fn fields_are_given(draft: &Draft, diagnostics: &mut Diagnostics) {
    // If a route has errors, it is unknown which bodies a hinge leaves.
    let is_again = |item: &RouteItem| matches!(item, RouteItem::Duplicate { .. });
    let is_whole = draft.written.routes_are_complete && !draft.items.iter().any(is_again);
    let is_left = outputs_with_a_hinge(draft);
    for (body, is_left) in draft.types.all.iter().zip(is_left) {
        let missing: Vec<_> =
            body.missing(is_left && is_whole).iter().map(|name| format!("`{name}`")).collect();
        if !missing.is_empty() {
            let message = format!("body `{}` needs {}", body.name, listed(&missing));
            diagnostics.error(body.name.span(), message);
        }
    }
}

/// Returns whether a hinge leaves the output of a body of each type.
fn outputs_with_a_hinge(draft: &Draft) -> Vec<bool> {
    let mut is_left = vec![false; draft.types.all.len()];
    let mut leave = |item: usize| {
        if let RouteItem::Body { body_type: Some(index), .. } = &draft.items[item] {
            is_left[*index] = true;
        }
    };
    for (route, start) in draft.written.routes.iter().zip(&draft.starts) {
        // A hinge at the end, which is an error, needs no output.
        let last = route.items.iter().rposition(|&item| !draft.items[item].is_hinge());
        let Some(last) = last else { continue };
        route.items[..last].iter().for_each(|&item| leave(item));
        let places = match start {
            RouteStart::Item => [None, None],
            RouteStart::Place(place) => [*place, None],
            RouteStart::Previous(place) => {
                [place.map(|place| place.previous), place.map(|place| place.first)]
            }
        };
        let outputs =
            places.into_iter().flatten().filter(|place| place.point == PlacePoint::Output);
        outputs.for_each(|place| leave(place.item));
    }
    for repeat in &draft.written.repeats {
        // The next repetition follows, except after the last one.
        let route = &draft.written.routes[repeat.route];
        let items = &route.items[repeat.on_route.clone()];
        let last = items.iter().rposition(|&item| !draft.items[item].is_hinge());
        if let Some(last) = last
            && repeat.syntax.count.is_some_and(|count| count > 1)
        {
            leave(items[last]);
        }
    }
    is_left
}

/// Methods of what every body has, which are no names for points: the name, and what has the method. `into` and `try_into`
/// are methods by value of the prelude, which Rust prefers to the generated ones.
const RESERVED: &[(&str, &str)] =
    &[("clone", "results"), ("into", "results"), ("try_into", "results"), ("at", "kinematics")];

/// Reports points with the name of another point of the type, or of a point that every body has.
pub(super) fn points_are_named_once(draft: &Draft, diagnostics: &mut Diagnostics) {
    for body in &draft.types.all {
        for (index, point) in body.points.iter().enumerate() {
            let name = point.name;
            let message = if POINTS.iter().any(|known| name == known) {
                format!("every body has a point `{name}` already: choose another name")
            } else if let Some((_, of)) = RESERVED.iter().find(|(known, _)| name == known) {
                format!("`{name}` is a method of the {of} of every body and cannot be a name")
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
    let masses = draft.types.all.iter().filter_map(|body| body.mass.as_ref());
    masses.map(|mass| vec![MASS.condition(mass.value.clone(), mass.at)]).collect()
}
